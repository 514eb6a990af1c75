#include "layer/vulkan/debug/shader_dump.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <unordered_set>
#include <vector>

#include <fmt/format.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include "layer/cache/generator_version.h"
#include "layer/cache/shader_cache.h"
#include "layer/vulkan/device/device.h"

namespace anteroom::vulkan {
namespace {

namespace fs = std::filesystem;

const char* stageName(cache::KeyKind kind) {
  return cache::stageOf(kind) == gen::Stage::Vertex ? "vertex" : "fragment";
}

bool isOwn(cache::KeyKind kind) {
  return kind == cache::KeyKind::VertexText || kind == cache::KeyKind::FragmentText;
}

// False: it cannot be written. What is there already has the same contents, as its name says.
bool writeFile(const fs::path& path, std::string_view text) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (file < 0) return errno == EEXIST;
  while (!text.empty()) {
    const ssize_t written = write(file, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) break;
    text.remove_prefix(static_cast<size_t>(written));
  }
  const bool whole = close(file) == 0 && text.empty();
  if (!whole) unlink(path.c_str());
  return whole;
}

std::vector<fs::path> reportFolders() {
  std::vector<fs::path> folders;
  if (const char* asked = secure_getenv("ANTEROOM_DUMP_DIR"); asked && *asked) folders.emplace_back(asked);
  const cache::ShaderCache& cache = cache::ShaderCache::process();
  if (cache.wanted()) folders.push_back(cache.file().parent_path());
  std::error_code error;
  if (fs::path temporary = fs::temp_directory_path(error); !error) folders.push_back(std::move(temporary));
  return folders;
}

// Where `text` was written. Empty: nowhere.
fs::path writeReport(const std::string& name, std::string_view text) {
  for (const fs::path& folder : reportFolders()) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (writeFile(folder / name, text)) return folder / name;
  }
  return {};
}

std::string version(uint32_t number) {
  return fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(number), VK_API_VERSION_MINOR(number),
                     VK_API_VERSION_PATCH(number));
}

std::string describeDevice(const VulkanDevice& device) {
  VkPhysicalDeviceProperties is;
  vkGetPhysicalDeviceProperties(device.physical(), &is);
  return fmt::format("device: {} ({:04x}:{:04x})\ndriver: {}, version {:#x}, Vulkan {}\nquirks: {}\n",
                     is.deviceName, is.vendorID, is.deviceID, device.driver().text, is.driverVersion,
                     version(is.apiVersion), namesOf(device.quirks()));
}

std::string hex(cache::KeyBytes bytes) {
  std::string text;
  for (size_t i = 0; i < bytes.size(); ++i) {
    if (i) text += i % 32 ? " " : "\n     ";
    text += fmt::format("{:02x}", static_cast<unsigned>(bytes[i]));
  }
  return text;
}

std::string describeFully(const ShaderText& shader) {
  std::string text = fmt::format("\n== {} shader ==\nkey: {}\n", stageName(shader.kind), describe(shader));
  if (!isOwn(shader.kind)) text += fmt::format("bytes: {}\n", hex(shader.key));
  return text + "\n" + cache::emit(shader.kind, shader.key) + "\n";
}

// Whether this process has not said so yet.
bool isNews(uint64_t hash) {
  static std::mutex mutex;
  static auto& known = *new std::unordered_set<uint64_t>;
  const std::lock_guard lock(mutex);
  return known.insert(hash).second;
}

}  // namespace

std::string describe(const ShaderText& shader) {
  std::string words = cache::wordsOf(shader.kind, shader.key);
  if (!isOwn(shader.kind)) return words;
  const size_t comment = words.find("// ");
  if (comment == words.npos) return "without a key";
  return words.substr(comment + 3, words.find('\n', comment) - comment - 3);
}

void dumpShader(const VulkanDevice& device, const ShaderText& shader) {
  if (!device.debug().glsl) return;
  const std::string glsl = cache::emit(shader.kind, shader.key);
  const std::string& folder = device.debug().glslFolder;
  if (folder.empty()) {
    std::fprintf(stderr, "anteroom: %s shader: %s\n%s\n", stageName(shader.kind), describe(shader).c_str(),
                 glsl.c_str());
    return;
  }
  const auto id = static_cast<uint64_t>(cache::shaderId(shader.kind, shader.key));
  const fs::path path = fs::path(folder) / fmt::format("{}-{:016x}.glsl", stageName(shader.kind), id);
  std::error_code error;
  fs::create_directories(folder, error);
  if (!writeFile(path, glsl) && isNews(XXH3_64bits(folder.data(), folder.size())))
    std::fprintf(stderr, "anteroom: ANTEROOM_DEBUG=glsl: %s cannot be written\n", path.c_str());
}

void reportFailure(const VulkanDevice& device, std::string_view fault, std::span<const ShaderText> shaders,
                   std::string_view state, std::string_view log) {
  std::string text = fmt::format(
      "Anteroom cannot draw with this: please report it with the whole of this file.\n\nfault: {}\n"
      "library: Anteroom {}, generator {}\n{}",
      fault, ANTEROOM_VERSION, cache::generatorVersion(), describeDevice(device));
  if (!state.empty()) text += fmt::format("state: {}\n", state);
  text += fmt::format("\n== log ==\n{}\n", log.empty() ? "none" : log);
  for (const ShaderText& shader : shaders) text += describeFully(shader);
  const uint64_t hash = XXH3_64bits(text.data(), text.size());
  if (!isNews(hash)) return;
  const fs::path path = writeReport(fmt::format("anteroom-shader-{:016x}.txt", hash), text);
  if (path.empty())
    std::fprintf(stderr, "anteroom: %s\n", text.c_str());
  else
    std::fprintf(stderr, "anteroom: %.*s: please report %s\n", static_cast<int>(fault.size()), fault.data(),
                 path.c_str());
}

}  // namespace anteroom::vulkan
