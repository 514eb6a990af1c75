#include "layer/vulkan/shader_library.h"

#include <chrono>
#include <cstdio>
#include <span>
#include <string_view>
#include <thread>

#include "layer/vulkan/device.h"

namespace anteroom::vulkan {
namespace {

// Joined before the process, or this library, ends.
class WarmUp {
 public:
  WarmUp()
      : thread_([&cache = gen::ShaderCache::process()] {
          if (!cache.filled()) gen::warmCompiler();
        }) {}
  ~WarmUp() {
    if (thread_.joinable()) thread_.join();
  }

 private:
  std::thread thread_;
};

}  // namespace

ShaderLibrary::~ShaderLibrary() {
  const auto destroy = [&](const auto& map) {
    for (const auto& [key, shader] : map)
      device_.fn().vkDestroyShaderModule(device_.handle(), shader.module, nullptr);
  };
  destroy(vertex_);
  destroy(fragment_);
  destroy(own_);
}

void ShaderLibrary::warmUp() {
  static const WarmUp warmUp;
}

std::vector<uint32_t> ShaderLibrary::compile(gen::KeyKind kind, gen::KeyBytes key) {
  ++compiled_;
  const auto start = std::chrono::steady_clock::now();
  std::string glsl = gen::emit(kind, key);
  gen::CompileResult result = gen::compile(gen::stageOf(kind), glsl);
  const auto time = std::chrono::steady_clock::now() - start;
  if (result.spirv.empty()) {
    std::fprintf(stderr, "anteroom: a shader does not compile: please report this\n%s\n%s\n", glsl.c_str(),
                 result.log.c_str());
    return {};
  }
  const auto microseconds = std::chrono::duration_cast<std::chrono::microseconds>(time).count();
  gen::ShaderCache::process().store(kind, key, std::move(glsl), result.spirv, microseconds);
  return std::move(result.spirv);
}

Shader ShaderLibrary::create(gen::KeyKind kind, gen::KeyBytes key) {
  std::vector<uint32_t> spirv = gen::ShaderCache::process().find(kind, key);
  if (!spirv.empty()) ++fromCache_;
  if (spirv.empty()) spirv = compile(kind, key);
  if (spirv.empty()) return {};
  VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
  info.codeSize = spirv.size() * sizeof(uint32_t);
  info.pCode = spirv.data();
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
    found = vertex_.emplace(key, create(gen::KeyKind::Vertex, gen::bytesOf(key))).first;
  return found->second.module ? &found->second : nullptr;
}

const Shader* ShaderLibrary::get(const gen::FragmentKey& key) {
  const std::lock_guard lock(mutex_);
  auto found = fragment_.find(key);
  if (found == fragment_.end())
    found = fragment_.emplace(key, create(gen::KeyKind::Fragment, gen::bytesOf(key))).first;
  return found->second.module ? &found->second : nullptr;
}

const Shader* ShaderLibrary::get(gen::Stage stage, const char* text) {
  const std::lock_guard lock(mutex_);
  auto found = own_.find(text);
  if (found == own_.end()) {
    const auto kind = stage == gen::Stage::Vertex ? gen::KeyKind::VertexText : gen::KeyKind::FragmentText;
    found = own_.emplace(text, create(kind, std::as_bytes(std::span(std::string_view(text))))).first;
  }
  return found->second.module ? &found->second : nullptr;
}

}  // namespace anteroom::vulkan
