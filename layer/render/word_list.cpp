#include "layer/render/word_list.h"

#include <algorithm>
#include <cstdlib>

namespace anteroom::render {

std::string WordList::help() const {
  size_t width = 0;
  for (const Word& word : words) width = std::max(width, word.text.size() + 2);
  std::string text = std::string("anteroom: ") + variable + " takes, separated by commas:\n";
  for (const Word& word : words) {
    std::string padded = word.text;
    padded.resize(width, ' ');
    text.append("  ").append(padded).append(word.meaning).append("\n");
  }
  return text;
}

std::string WordList::known() const {
  std::string list;
  for (const Word& word : words) list.append(word.text).append(", ");
  return list + "help";
}

std::string WordList::read(std::string_view text,
                           const std::function<bool(std::string_view word)>& take) const {
  std::string said, unknown;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(','));
    text.remove_prefix(std::min(word.size() + 1, text.size()));
    if (word == "help")
      said += help();
    else if (!word.empty() && !take(word))
      unknown.append(unknown.empty() ? "" : ", ").append(word);
  }
  if (!unknown.empty())
    said +=
        std::string("anteroom: ") + variable + " does not know " + unknown + "; it knows: " + known() + "\n";
  return said;
}

std::string_view environmentWords(const char* variable) {
  const char* const words = secure_getenv(variable);
  return words ? words : "";
}

}  // namespace anteroom::render
