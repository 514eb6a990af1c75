#include "layer/tools/info/print.h"

#include <EGL/egl.h>
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

namespace info {
namespace {

constexpr size_t kWidth = 100;

std::string joined(const Names& names, const char* separator) {
  return fmt::format("{}", fmt::join(names, separator));
}

void printRow(const char* title, const std::string& value) {
  if (!value.empty()) fmt::print("  {:<11}{}\n", title, value);
}

// Names in lines of kWidth at most.
void printNames(const char* title, const Names& names) {
  if (names.empty()) return;
  fmt::print("  {}, {}:\n", title, names.size());
  std::string line;
  for (const std::string& name : names) {
    if (!line.empty() && line.size() + name.size() + 5 > kWidth) {
      fmt::print("    {}\n", line);
      line.clear();
    }
    line += (line.empty() ? "" : " ") + name;
  }
  fmt::print("    {}\n", line);
}

std::string cacheText(const std::string& cache) {
  if (cache.empty() || cache.starts_with("none")) return cache;
  std::error_code error;
  const auto size = std::filesystem::file_size(cache, error);
  return cache +
         (error ? ", not there yet" : fmt::format(", {:.1f} MiB", static_cast<double>(size) / (1 << 20)));
}

std::string surfacesText(int types) {
  std::string text;
  for (const auto& [bit, letter] :
       {std::pair{EGL_WINDOW_BIT, 'w'}, {EGL_PBUFFER_BIT, 'b'}, {EGL_PIXMAP_BIT, 'x'}})
    text += (types & bit) != 0 ? letter : '-';
  return text;
}

std::string caveatText(int caveat) {
  return caveat == EGL_SLOW_CONFIG ? "slow" : caveat == EGL_NON_CONFORMANT_CONFIG ? "bad" : "";
}

std::string valueText(int attribute, int value) {
  switch (attribute) {
    case EGL_SURFACE_TYPE:
      return surfacesText(value);
    case EGL_CONFIG_CAVEAT:
      return caveatText(value);
    case EGL_NATIVE_VISUAL_ID:
      return fmt::format("{:#x}", value);
    default:
      return fmt::format("{}", value);
  }
}

void printConfigs(const std::vector<Config>& configs) {
  fmt::print("  configs, {} (surfaces: w window, b pbuffer, x pixmap):\n    ", configs.size());
  for (const ConfigColumn& column : kConfigColumns)
    fmt::print("{:>{}}", column.title, std::string_view(column.title).size() < 4 ? 4 : 9);
  fmt::print("\n");
  for (const Config& config : configs) {
    fmt::print("    ");
    for (size_t i = 0; i < config.values.size(); ++i)
      fmt::print("{:>{}}", valueText(kConfigColumns[i].attribute, config.values[i]),
                 std::string_view(kConfigColumns[i].title).size() < 4 ? 4 : 9);
    fmt::print("\n");
  }
}

void printPlatform(const Facts& facts, const Platform& platform, bool brief) {
  fmt::print("\nPlatform {}\n", joined(platform.names, ", "));
  const Platform& first = facts.platforms.front();
  if (brief) return fmt::print("  {} configs\n", platform.configs.size());
  printRow("vendor", platform.vendor);
  printRow("version", platform.version);
  printRow("APIs", platform.apis);
  if (&platform != &first && platform.extensions == first.extensions)
    fmt::print("  extensions as above\n");
  else
    printNames("extensions", platform.extensions);
  if (&platform != &first && platform.configs == first.configs)
    fmt::print("  configs as above\n");
  else
    printConfigs(platform.configs);
}

void printGl(const Gl& gl, bool brief) {
  fmt::print("\nOpenGL ES\n");
  if (gl.version.empty()) return fmt::print("  there is no context of version 1\n");
  printRow("vendor", gl.vendor);
  printRow("renderer", gl.renderer);
  printRow("version", gl.version);
  if (brief) return;
  printNames("extensions", gl.extensions);
  fmt::print("  limits:\n");
  for (const auto& [name, value] : gl.limits) fmt::print("    {:<32}{}\n", name, value);
}

}  // namespace

void print(const Facts& facts, bool brief) {
  fmt::print("Libraries\n");
  printRow("EGL", facts.eglLibrary);
  printRow("OpenGL ES", facts.glLibrary);
  if (!facts.driver.empty()) {
    fmt::print("\nDevice\n");
    for (const std::string& device : facts.devices) fmt::print("  {}\n", device);
    printRow("because", facts.choice);
    printRow("driver", facts.driver);
    printRow("quirks", joined(facts.quirks, ", "));
    printRow("cache", cacheText(facts.cache));
  }
  fmt::print("\nEGL\n");
  printRow("version", facts.eglVersion);
  if (!brief) printNames("client extensions", facts.clientExtensions);
  for (const Platform& platform : facts.platforms) printPlatform(facts, platform, brief);
  printGl(facts.gl, brief);
}

void printJson(const Facts& facts) {
  using Json = nlohmann::ordered_json;
  Json platforms = Json::array();
  for (const Platform& platform : facts.platforms) {
    Json configs = Json::array();
    for (const Config& config : platform.configs) {
      Json& row = configs.emplace_back();
      for (size_t i = 0; i < config.values.size(); ++i) row[kConfigColumns[i].title] = config.values[i];
    }
    platforms.push_back({{"names", platform.names},
                         {"vendor", platform.vendor},
                         {"version", platform.version},
                         {"apis", platform.apis},
                         {"extensions", platform.extensions},
                         {"configs", configs}});
  }
  Json limits = Json::object();
  for (const auto& [name, value] : facts.gl.limits) limits[name] = value;
  const Json all = {{"libraries", {{"egl", facts.eglLibrary}, {"gles", facts.glLibrary}}},
                    {"device",
                     {{"found", facts.devices},
                      {"because", facts.choice},
                      {"driver", facts.driver},
                      {"quirks", facts.quirks},
                      {"cache", facts.cache}}},
                    {"egl", {{"version", facts.eglVersion}, {"clientExtensions", facts.clientExtensions}}},
                    {"platforms", platforms},
                    {"gles",
                     {{"vendor", facts.gl.vendor},
                      {"renderer", facts.gl.renderer},
                      {"version", facts.gl.version},
                      {"extensions", facts.gl.extensions},
                      {"limits", limits}}}};
  fmt::print("{}\n", all.dump(2));
}

}  // namespace info
