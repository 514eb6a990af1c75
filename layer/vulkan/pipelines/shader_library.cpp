#include "layer/vulkan/pipelines/shader_library.h"

#include <malloc.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <string_view>
#include <thread>

#include "layer/cache/quiet_thread.h"
#include "layer/cache/shader_cache.h"
#include "layer/vulkan/debug/shader_dump.h"
#include "layer/vulkan/device/device.h"
#include "layer/vulkan/device/no_fork.h"

namespace anteroom::vulkan {
namespace {

// Joined before the process, or this library, ends.
class WarmUp {
 public:
  WarmUp()
      : thread_(cache::quietThread([&cache = cache::ShaderCache::process()] {
          if (cache.filled()) return;
          const NoFork noFork;
          gen::warmCompiler();
#ifdef __GLIBC__
          malloc_trim(0);  // the compiler's tables leave more behind than they keep
#endif
        })) {
  }
  ~WarmUp() {
    if (getpid() != process_)
      cache::forget(thread_);
    else if (thread_.joinable())
      thread_.join();
  }

 private:
  const int process_ = getpid();
  std::thread thread_;
};

}  // namespace

ShaderLibrary::~ShaderLibrary() {
  const auto destroy = [&](const Shader& shader) {
    device_.fn().vkDestroyShaderModule(device_.handle(), shader.module, nullptr);
  };
  vertex_.visit(destroy);
  fragment_.visit(destroy);
  own_.visit(destroy);
}

void ShaderLibrary::flush() {
  cache::ShaderCache::process().flush();
}

void ShaderLibrary::warmUp() {
  static const WarmUp warmUp;
}

std::vector<uint32_t> ShaderLibrary::compile(cache::KeyKind kind, cache::KeyBytes key) {
  const auto start = std::chrono::steady_clock::now();
  const NoFork noFork;
  std::string glsl = cache::emit(kind, key);
  gen::CompileResult result = gen::compile(cache::stageOf(kind), glsl);
  const auto time = std::chrono::steady_clock::now() - start;
  if (result.spirv.empty()) {
    const ShaderText text{kind, key};
    reportFailure(device_, "glslang refuses a shader", {&text, 1}, {}, result.log);
    return {};
  }
  const auto microseconds = std::chrono::duration_cast<std::chrono::microseconds>(time).count();
  cache::ShaderCache::process().store(kind, key, std::move(glsl), result.spirv, microseconds);
  return std::move(result.spirv);
}

bool ShaderLibrary::create(cache::KeyKind kind, cache::KeyBytes key, Shader& shader, Counted counted) {
  shader.kind = kind;
  shader.key = key;
  std::vector<uint32_t> spirv = cache::ShaderCache::process().find(kind, key);
  const bool cached = !spirv.empty();
  if (!cached) spirv = compile(kind, key);
  if (counted == Counted::Yes) ++(cached ? fromCache_ : compiled_);
  if (spirv.empty()) return true;
  dumpShader(device_, {kind, key});
  const VkResult result = createModule(spirv, {kind, key}, shader.module);
  if (result == VK_SUCCESS) shader.id = nextId_++;
  return result == VK_SUCCESS || isFault(result);
}

VkResult ShaderLibrary::createModule(const std::vector<uint32_t>& spirv, const ShaderText& text,
                                     VkShaderModule& module) {
  VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
  info.codeSize = spirv.size() * sizeof(uint32_t);
  info.pCode = spirv.data();
  const ValidationScope validation;
  const VkResult result = device_.fn().vkCreateShaderModule(device_.handle(), &info, nullptr, &module);
  if (isFault(result))
    reportFailure(device_, "the driver refuses a shader, VkResult " + std::to_string(result), {&text, 1}, {},
                  validation.messages());
  else if (!validation.messages().empty())
    reportFailure(device_, "validation finds fault with a shader", {&text, 1}, {}, validation.messages());
  if (result != VK_SUCCESS) {
    module = VK_NULL_HANDLE;
    return result;
  }
  device_.countObject();
  if (device_.labels().nameAll()) device_.labels().name(VK_OBJECT_TYPE_SHADER_MODULE, module, describe(text));
  return result;
}

const Shader* ShaderLibrary::get(const gen::VertexKey& key) {
  const Shader& shader = vertex_.get(key, [this](const gen::VertexKey& kept, Shader& made) {
    return create(cache::KeyKind::Vertex, cache::bytesOf(kept), made);
  });
  return shader.module ? &shader : nullptr;
}

const Shader* ShaderLibrary::get(const gen::FragmentKey& key) {
  const Shader& shader = fragment_.get(key, [this](const gen::FragmentKey& kept, Shader& made) {
    return create(cache::KeyKind::Fragment, cache::bytesOf(kept), made);
  });
  return shader.module ? &shader : nullptr;
}

const Shader* ShaderLibrary::get(const OwnShader& own, Counted counted) {
  const Shader& shader = own_.get(&own, [&](const OwnShader* kept, Shader& made) {
    const bool vertex = kept->stage == gen::Stage::Vertex;
    const auto kind = vertex ? cache::KeyKind::VertexText : cache::KeyKind::FragmentText;
    return create(kind, std::as_bytes(std::span(std::string_view(kept->text))), made, counted);
  });
  return shader.module ? &shader : nullptr;
}

const Shader* ShaderLibrary::get(gen::Stage stage, const std::string& words) {
  for (const OwnShader* own : ownShaders())
    if (own->stage == stage && words == own->text) return get(*own);
  gen::VertexKey vertex;
  gen::FragmentKey fragment;
  if (stage == gen::Stage::Vertex) return gen::parse(words, vertex) ? get(vertex) : nullptr;
  return gen::parse(words, fragment) ? get(fragment) : nullptr;
}

}  // namespace anteroom::vulkan
