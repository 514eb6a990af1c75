#include "tests/measure/implementations.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <stdexcept>

namespace measure {

namespace {

std::string ourLibraries() {
  return process::executableDirectory() + "/../lib";
}

std::optional<Implementation> ifThere(const char* file, Implementation implementation) {
  if (!std::filesystem::exists(ourLibraries() + "/" + file)) return std::nullopt;
  return implementation;
}

// The parts of "NAME=VALUE" or the like.
std::pair<std::string, std::string> parts(const std::string& text, char between, const char* shape) {
  const std::size_t at = text.find(between);
  if (at == std::string::npos || at == 0)
    throw std::invalid_argument(fmt::format("'{}' is not {}", text, shape));
  return {text.substr(0, at), text.substr(at + 1)};
}

}  // namespace

process::Environment with(process::Environment environment, const process::Environment& more) {
  for (const auto& [name, value] : more) environment[name] = value;
  return environment;
}

std::optional<Implementation> ours() {
  return ifThere("libEGL.so.1", {"ours", {{"LD_LIBRARY_PATH", ourLibraries()}}});
}

std::optional<Implementation> reference() {
  return ifThere("libanteroom_reference.so",
                 {"reference", {{"LD_LIBRARY_PATH", ourLibraries()}, {"ANTEROOM_RENDERER", "reference"}}});
}

Implementation mesa(const std::string& folder) {
  return {"mesa", {{"LD_LIBRARY_PATH", folder}, {"EGL_PLATFORM", "surfaceless"}}};
}

Implementation zink(const std::string& folder) {
  return {"zink",
          with(mesa(folder).environment, {{"LIBGL_ALWAYS_SOFTWARE", "1"}, {"GALLIUM_DRIVER", "zink"}})};
}

std::string systemLibraries() {
  return SYSTEM_LIBRARIES;
}

Implementation fromFolder(const std::string& text) {
  const auto [name, folder] = parts(text, '=', "NAME=FOLDER");
  if (!std::filesystem::exists(folder + "/libEGL.so.1"))
    throw std::invalid_argument(fmt::format("no libEGL.so.1 in '{}'", folder));
  return {name, {{"LD_LIBRARY_PATH", folder}}};
}

Implementation fromVariables(const std::string& text) {
  const auto [name, settings] = parts(text, ':', "NAME:VARIABLE=VALUE,...");
  Implementation result{name, {}};
  for (std::size_t begin = 0, end; begin < settings.size(); begin = end + 1) {
    end = std::min(settings.find(',', begin), settings.size());
    const auto [variable, value] = parts(settings.substr(begin, end - begin), '=', "VARIABLE=VALUE");
    result.environment[variable] = value;
  }
  return result;
}

process::Environment withoutCaches(const process::Environment& environment) {
  return with(environment, {{"MESA_SHADER_CACHE_DISABLE", "true"}, {"ANTEROOM_CACHE", "off"}});
}

process::Environment withCaches(const process::Environment& environment, const std::string& folder) {
  for (const char* cache : {"/mesa", "/anteroom"}) std::filesystem::create_directories(folder + cache);
  return with(environment, {{"MESA_SHADER_CACHE_DISABLE", "false"},
                            {"MESA_SHADER_CACHE_DIR", folder + "/mesa"},
                            {"ANTEROOM_CACHE", "on"},
                            {"ANTEROOM_CACHE_DIR", folder + "/anteroom"}});
}

std::vector<Implementation> others(const Sources& sources) {
  std::vector<Implementation> result;
  for (const std::string& text : sources.also) result.push_back(fromFolder(text));
  for (const std::string& text : sources.variables) result.push_back(fromVariables(text));
  return result;
}

std::vector<Implementation> sideBySide(const Sources& sources) {
  std::vector<Implementation> result;
  if (const auto own = ours())
    result.push_back(*own);
  else
    fmt::print(stderr, "ours is left out: no libEGL.so.1 in {}\n", ourLibraries());
  result.push_back(mesa(sources.mesaLibraries));
  result.push_back(zink(sources.mesaLibraries));
  for (Implementation& other : others(sources)) result.push_back(std::move(other));
  return result;
}

}  // namespace measure
