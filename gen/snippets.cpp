#include "gen/snippets.h"

#include <algorithm>

namespace anteroom::gen {
namespace {

constexpr std::string_view kHead = "// Expects: ";

}  // namespace

const Snippet* findSnippet(std::string_view function) {
  const auto all = snippets();
  const auto at = std::lower_bound(all.begin(), all.end(), function,
                                   [](const Snippet& s, std::string_view name) { return s.function < name; });
  return at != all.end() && at->function == function ? &*at : nullptr;
}

std::vector<std::string_view> expectations(const Snippet& snippet) {
  std::string_view line = snippet.text.substr(0, snippet.text.find('\n'));
  std::vector<std::string_view> names;
  if (!line.starts_with(kHead)) return names;
  line.remove_prefix(kHead.size());
  if (line == "nothing") return names;
  while (!line.empty()) {
    const size_t comma = std::min(line.find(", "), line.size());
    names.push_back(line.substr(0, comma));
    line.remove_prefix(std::min(comma + 2, line.size()));
  }
  return names;
}

std::string_view body(const Snippet& snippet) {
  return snippet.text.substr(std::min(snippet.text.find('\n') + 1, snippet.text.size()));
}

}  // namespace anteroom::gen
