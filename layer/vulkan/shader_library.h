// Shaders by key, and shaders of the renderer's own.
#pragma once

#include <volk.h>

#include <atomic>
#include <cstring>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>

#include "gen/cache/shader_cache.h"

namespace anteroom::vulkan {

class VulkanDevice;

struct Shader {
  VkShaderModule module = VK_NULL_HANDLE;
  uint32_t id = 0;  // unlike any other shader's on this device
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
  static void flush() { gen::ShaderCache::process().flush(); }

  // Null: the shader cannot be made; the reason was logged.
  const Shader* get(const gen::VertexKey& key);
  const Shader* get(const gen::FragmentKey& key);
  // The renderer's own: `text` is GLSL with static lifetime.
  const Shader* get(gen::Stage stage, const char* text);

  uint64_t compiled() const { return compiled_; }
  uint64_t fromCache() const { return fromCache_; }

 private:
  template <class Key>
  struct KeyHash {
    size_t operator()(const Key& key) const { return gen::hash(key); }
  };
  template <class Key>
  struct KeyEqual {
    bool operator()(const Key& a, const Key& b) const { return !std::memcmp(&a, &b, sizeof(Key)); }
  };
  template <class Key>
  using Map = std::unordered_map<Key, Shader, KeyHash<Key>, KeyEqual<Key>>;

  Shader create(gen::KeyKind kind, gen::KeyBytes key);
  // Empty: it does not compile.
  std::vector<uint32_t> compile(gen::KeyKind kind, gen::KeyBytes key);

  VulkanDevice& device_;
  std::mutex mutex_;
  Map<gen::VertexKey> vertex_;
  Map<gen::FragmentKey> fragment_;
  std::unordered_map<const char*, Shader> own_;
  uint32_t nextId_ = 1;
  std::atomic<uint64_t> compiled_{0}, fromCache_{0};
};

}  // namespace anteroom::vulkan
