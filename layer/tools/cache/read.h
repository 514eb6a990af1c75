// Rows of a cache, read whole.
#pragma once

#include <string>
#include <vector>

#include "layer/cache/store.h"
#include "layer/tools/cache/commands.h"

namespace anteroom::inspect {

struct Shader {
  int64_t number = 0;  // of the row
  int64_t id = 0;      // its key
  cache::ShaderRow row;
  std::string why;  // empty: a good row
};

struct Pipeline {
  int64_t id = 0;
  cache::PipelineRow row;
  std::string why;
};

struct Contents {
  std::vector<Shader> shaders;
  std::vector<Pipeline> pipelines;
  std::vector<cache::UsageRow> usage;
};

// Opens, or says on stderr what is wrong.
Status open(const std::string& file, cache::Store::Mode mode, cache::Store& store);
Status read(const std::string& file, Contents& contents);
// "rooms": all pipelines that programs of this name needed; empty: all.
std::vector<const Pipeline*> pipelinesOf(const Contents& contents, const std::string& program);

}  // namespace anteroom::inspect
