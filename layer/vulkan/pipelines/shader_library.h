// Shaders by key, and shaders of the renderer's own.
#pragma once

#include <volk.h>

#include <atomic>
#include <memory>
#include <string>
#include <unordered_map>

#include "layer/cache/rows.h"
#include "layer/vulkan/pipelines/made_once.h"
#include "layer/vulkan/pipelines/own_shaders.h"

namespace anteroom::vulkan {

class VulkanDevice;
struct ShaderText;

struct Shader {
  VkShaderModule module = VK_NULL_HANDLE;
  uint32_t id = 0;  // unlike any other shader's on this device
  cache::KeyKind kind = cache::KeyKind::Vertex;
  cache::KeyBytes key;  // lives as long as the shader
};

// Thread-safe. Shaders live as long as the device; a pointer to one stays valid.
class ShaderLibrary {
 public:
  explicit ShaderLibrary(VulkanDevice& device) : device_(device) {}
  ~ShaderLibrary();

  // Opens the shader cache, and builds the compiler's tables when it will be needed, beside the program's own
  // start. Once a process.
  static void warmUp();
  // Writes what is new to the shader cache.
  static void flush();

  // Null: the shader cannot be made; the reason was logged.
  const Shader* get(const gen::VertexKey& key);
  const Shader* get(const gen::FragmentKey& key);
  const Shader* get(const OwnShader& own, Counted counted = Counted::Yes);
  // By cache::wordsOf(). Null also when they are none of this generator's, or of this renderer's.
  const Shader* get(gen::Stage stage, const std::string& words);

  uint64_t compiled() const { return compiled_; }
  uint64_t fromCache() const { return fromCache_; }

 private:
  template <class Key>
  struct KeyHash {
    size_t operator()(const Key& key) const { return gen::hash(key); }
  };
  template <class Key>
  using Map = MadeOnce<Key, Shader, KeyHash<Key>>;

  // False: out of memory, so that the next to ask tries again. What is refused is refused for good.
  bool create(cache::KeyKind kind, cache::KeyBytes key, Shader& shader, Counted counted = Counted::Yes);
  VkResult createModule(const std::vector<uint32_t>& spirv, const ShaderText& text, VkShaderModule& module);
  // Empty: it does not compile.
  std::vector<uint32_t> compile(cache::KeyKind kind, cache::KeyBytes key);

  VulkanDevice& device_;
  Map<gen::VertexKey> vertex_;
  Map<gen::FragmentKey> fragment_;
  MadeOnce<const OwnShader*, Shader, std::hash<const OwnShader*>> own_;
  std::atomic<uint32_t> nextId_{1};
  std::atomic<uint64_t> compiled_{0}, fromCache_{0};
};

}  // namespace anteroom::vulkan
