#include "layer/vulkan/shader_library.h"

#include <cstdio>

#include "layer/vulkan/device.h"

namespace anteroom::vulkan {

ShaderLibrary::~ShaderLibrary() {
  const auto destroy = [&](const auto& map) {
    for (const auto& [key, shader] : map)
      device_.fn().vkDestroyShaderModule(device_.handle(), shader.module, nullptr);
  };
  destroy(vertex_);
  destroy(fragment_);
  destroy(own_);
}

Shader ShaderLibrary::create(gen::Stage stage, const std::string& glsl) {
  ++compiled_;
  const gen::CompileResult result = gen::compile(stage, glsl);
  if (result.spirv.empty()) {
    std::fprintf(stderr, "anteroom: a shader does not compile: please report this\n%s\n%s\n", glsl.c_str(),
                 result.log.c_str());
    return {};
  }
  VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
  info.codeSize = result.spirv.size() * sizeof(uint32_t);
  info.pCode = result.spirv.data();
  Shader shader;
  if (device_.fn().vkCreateShaderModule(device_.handle(), &info, nullptr, &shader.module) != VK_SUCCESS)
    return {};
  device_.countObject();
  shader.id = nextId_++;
  return shader;
}

const Shader* ShaderLibrary::get(const gen::VertexKey& key) {
  const std::lock_guard lock(mutex_);
  auto found = vertex_.find(key);
  if (found == vertex_.end())
    found = vertex_.emplace(key, create(gen::Stage::Vertex, gen::emitVertex(key))).first;
  return found->second.module ? &found->second : nullptr;
}

const Shader* ShaderLibrary::get(const gen::FragmentKey& key) {
  const std::lock_guard lock(mutex_);
  auto found = fragment_.find(key);
  if (found == fragment_.end())
    found = fragment_.emplace(key, create(gen::Stage::Fragment, gen::emitFragment(key))).first;
  return found->second.module ? &found->second : nullptr;
}

const Shader* ShaderLibrary::get(gen::Stage stage, const char* text) {
  const std::lock_guard lock(mutex_);
  auto found = own_.find(text);
  if (found == own_.end()) found = own_.emplace(text, create(stage, text)).first;
  return found->second.module ? &found->second : nullptr;
}

}  // namespace anteroom::vulkan
