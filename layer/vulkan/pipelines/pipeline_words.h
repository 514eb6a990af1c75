// What a pipeline holds besides its shaders, as text: what the shader cache keeps, and people read.
#pragma once

#include <string>

#include "layer/vulkan/pipelines/pipeline_key.h"

namespace anteroom::vulkan {

// What a pipeline's device took as dynamic state, and its words therefore do not say.
struct DynamicStates {
  bool state1 = false, state2 = false, state3 = false, vertexInput = false;
};

std::string describe(const PipelineKey& key, const Features& features);
// All of `key` but its shaders; each value is one that Vulkan has. False: the text says nothing that can be.
bool parse(const std::string& words, PipelineKey& key, DynamicStates& dynamic);
// Whether these arrays bring all that the vertex shader reads.
bool feeds(const VertexLayout& layout, const gen::VertexKey& vertex, const gen::FragmentKey& fragment);

}  // namespace anteroom::vulkan
