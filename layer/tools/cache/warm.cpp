// Everything in the cache, made ready before a program asks.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <unordered_set>

#include "layer/cache/shader_cache.h"
#include "layer/tools/cache/change.h"
#include "layer/vulkan/vulkan_device.h"

namespace anteroom::inspect {
namespace {

struct Shaders {
  size_t compiled = 0, known = 0, refused = 0;
};

// For each key, a row of this generator.
Status warmShaders(const Settings& settings, const Contents& contents, Shaders& shaders) {
  cache::Store store;
  if (const Status status = begin(settings, cache::Store::Mode::Write, store)) return status;
  std::unordered_set<int64_t> done;
  for (const Shader& shader : contents.shaders)
    if (shader.row.current() && shader.why.empty()) done.insert(shader.id);
  shaders.known = done.size();
  bool good = true;
  const auto compile = [&](cache::KeyKind kind, const std::vector<std::byte>& key) {
    if (!done.insert(cache::shaderId(kind, key)).second) return;
    const auto row = compiled(kind, key);
    if (row) good = good && store.put(*row);
    ++(row ? shaders.compiled : shaders.refused);
  };
  for (const Shader& shader : contents.shaders) {
    const std::vector<std::byte> key = shader.row.currentKey();
    if (!key.empty() && (shader.why.empty() || shader.row.id() == shader.id)) compile(shader.row.kind, key);
  }
  for (const Pipeline& pipeline : contents.pipelines) {
    cache::KeyKind kind;
    std::vector<std::byte> key;
    if (cache::keyOf(gen::Stage::Vertex, pipeline.row.vertex, kind, key)) compile(kind, key);
    if (cache::keyOf(gen::Stage::Fragment, pipeline.row.fragment, kind, key)) compile(kind, key);
  }
  return finish(store, settings, good);
}

}  // namespace

Status warm(const Settings& settings, const std::string& preferred) {
  {
    // A file of an older version is brought up to date.
    cache::Store store;
    if (const Status status = open(settings.file, cache::Store::Mode::Write, store)) return status;
  }
  Contents contents;
  if (const Status status = read(settings.file, contents)) return status;
  Shaders shaders;
  if (const Status status = warmShaders(settings, contents, shaders)) return status;

  cache::ShaderCache::setProcessFile(settings.file);
  std::string error;
  const auto device = vulkan::createDevice({.preferred = preferred}, error);
  size_t made = 0;
  if (device) {
    std::vector<cache::PipelineRow> rows;
    for (const Pipeline& pipeline : contents.pipelines)
      if (pipeline.why.empty()) rows.push_back(pipeline.row);
    made = vulkan::makePipelines(*device, rows);
  }
  const size_t other = contents.pipelines.size() - made;
  if (settings.json) {
    nlohmann::json json{{"compiled", shaders.compiled},
                        {"known", shaders.known},
                        {"refused", shaders.refused},
                        {"pipelines", made},
                        {"others", other}};
    if (device) json["device"] = device->caps().deviceName;
    fmt::print("{}\n", json.dump(2));
  } else {
    fmt::print("{} shaders compiled, {} were there, {} do not compile\n", shaders.compiled, shaders.known,
               shaders.refused);
    if (device)
      fmt::print("{} pipelines made for {}, {} are not for it\n", made, device->caps().deviceName, other);
  }
  if (device) return shaders.refused ? kNo : kDone;
  fmt::print(stderr, "anteroom-cache: no pipelines were made: {}\n", error);
  return kUnusable;
}

}  // namespace anteroom::inspect
