// Why there are as many pipelines and shaders as there are.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "layer/tools/cache/commands.h"
#include "layer/tools/cache/words.h"

namespace anteroom::inspect {
namespace {

struct Split {
  std::string field;
  size_t without;  // how many there would be if it did not matter
  std::map<std::string, size_t> values;
};

// What has more than one value, the most splitting first.
std::vector<Split> splitsOf(const std::vector<State>& states) {
  std::set<std::string> fields;
  for (const State& one : states)
    for (const auto& [field, value] : one) fields.insert(field);
  std::vector<Split> splits;
  for (const std::string& field : fields) {
    Split split{field, 0, {}};
    std::set<State> rest;
    for (State one : states) {
      ++split.values[valueOf(one, field)];
      one.erase(field);
      rest.insert(std::move(one));
    }
    split.without = rest.size();
    if (split.values.size() > 1) splits.push_back(std::move(split));
  }
  std::stable_sort(splits.begin(), splits.end(),
                   [](const Split& a, const Split& b) { return a.without < b.without; });
  return splits;
}

nlohmann::json explained(const std::vector<State>& states, const std::string& what, bool quiet) {
  nlohmann::json json{{what, states.size()}, {"splits", nlohmann::json::array()}};
  const std::vector<Split> splits = splitsOf(states);
  if (!quiet) fmt::print("{} {}\n", states.size(), what);
  for (const Split& split : splits) {
    auto values = nlohmann::json::object();
    for (const auto& [value, count] : split.values) values[clean(value)] = count;
    json["splits"].push_back(
        {{"state", clean(split.field)}, {what + "_without", split.without}, {"values", values}});
    if (quiet) continue;
    fmt::print("  {}: {} without it\n", split.field, split.without);
    for (const auto& [value, count] : split.values) fmt::print("    {:4} {}\n", count, value);
  }
  return json;
}

}  // namespace

Status explain(const Settings& settings, const std::string& program) {
  Contents contents;
  if (const Status status = read(settings.file, contents)) return status;
  std::vector<State> pipelines;
  std::set<std::string> words;  // of the shaders that these have
  for (const Pipeline* pipeline : pipelinesOf(contents, program)) {
    pipelines.push_back(state(pipeline->row));
    words.insert({pipeline->row.vertex, pipeline->row.fragment});
  }
  if (!program.empty() && pipelines.empty()) {
    fmt::print(stderr, "anteroom-cache: no program that is called {} has drawn; known are:", program);
    std::set<std::string> known;
    for (const cache::UsageRow& usage : contents.usage) known.insert(usage.program.name);
    for (const std::string& one : known) fmt::print(stderr, " {}", one);
    fmt::print(stderr, "\n");
    return kNo;
  }
  nlohmann::json json;
  json["pipeline"] = explained(pipelines, "pipelines", settings.json);
  for (const cache::KeyKind kind : {cache::KeyKind::Vertex, cache::KeyKind::Fragment}) {
    std::vector<State> states;
    std::set<std::string> seen;  // once, whatever the generators
    for (const Shader& shader : contents.shaders)
      if (shader.row.kind == kind && shader.why.empty() && seen.insert(shader.row.description).second &&
          (program.empty() || words.contains(shader.row.description)))
        states.push_back(state(shader.row));
    if (!settings.json) fmt::print("{} ", kindName(kind));
    json[kindName(kind)] = explained(states, "shaders", settings.json);
  }
  if (settings.json) fmt::print("{}\n", json.dump(2));
  return kDone;
}

}  // namespace anteroom::inspect
