#include "layer/tools/cache/read.h"

#include <fmt/format.h>

#include <unordered_set>

namespace anteroom::inspect {

Status open(const std::string& file, cache::Store::Mode mode, cache::Store& store) {
  const auto say = [&](Status status, const std::string& what) {
    fmt::print(stderr, "anteroom-cache: {} {}\n", file, what);
    return status;
  };
  switch (store.open(file, mode, 2000)) {
    case cache::Opened::Ok:
      return kDone;
    case cache::Opened::Missing:
      return say(kMissing, "does not exist; a program that draws makes it");
    case cache::Opened::Foreign:
      return say(kNotACache, "is not a shader cache");
    case cache::Opened::Older:
      return say(
          kNotACache,
          "was made by an older version of Anteroom; the next program that draws, or `anteroom-cache warm`,"
          " brings it up to date");
    case cache::Opened::Newer:
      return say(kNotACache, "was made by a newer version of Anteroom");
    case cache::Opened::Damaged:
      return say(kNotACache,
                 "is no shader cache, or a damaged one; the next program that draws begins it again");
    case cache::Opened::Unusable:
      break;
  }
  return say(kUnusable, "cannot be opened: " + store.message());
}

Status read(const std::string& file, Contents& contents) {
  cache::Store store;
  if (const Status status = open(file, cache::Store::Mode::Read, store)) return status;
  const bool whole = store.visitShaders([&](int64_t number, int64_t id, cache::ShaderRow& row,
                                            const std::string& why) {
    contents.shaders.push_back({number, id, std::move(row), why});
  }) && store.visitPipelines([&](int64_t id, cache::PipelineRow& row, const std::string& why) {
    contents.pipelines.push_back({id, std::move(row), why});
  }) && store.visitUsage([&](const cache::UsageRow& row) { contents.usage.push_back(row); });
  if (whole) return kDone;
  fmt::print(stderr, "anteroom-cache: {} is damaged after {} rows: {}\n", file,
             contents.shaders.size() + contents.pipelines.size() + contents.usage.size(), store.message());
  return kNotACache;
}

std::vector<const Pipeline*> pipelinesOf(const Contents& contents, const std::string& program) {
  std::unordered_set<int64_t> needed;
  for (const cache::UsageRow& usage : contents.usage)
    if (usage.program.name == program) needed.insert(usage.pipeline);
  std::vector<const Pipeline*> result;
  for (const Pipeline& pipeline : contents.pipelines)
    if (program.empty() || needed.contains(pipeline.id)) result.push_back(&pipeline);
  return result;
}

}  // namespace anteroom::inspect
