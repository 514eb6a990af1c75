// What anteroom-info tells: asked of whichever libEGL.so.1 and libGLESv1_CM.so.1 it finds.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace info {

using Names = std::vector<std::string>;

struct Config {
  // In the order of kConfigColumns.
  std::vector<int> values;
  bool operator==(const Config&) const = default;
};

struct Platform {
  Names names;  // by which the same display was had
  std::string vendor, version, apis;
  Names extensions;
  std::vector<Config> configs;
};

struct Gl {
  std::string vendor, renderer, version;
  Names extensions;
  std::vector<std::pair<std::string, std::string>> limits;
};

struct Facts {
  std::string eglLibrary, glLibrary;  // files
  // Of EGL_ANTEROOM_origin; empty where somebody else's library answers.
  Names devices, quirks;
  std::string choice, driver, cache;
  std::string eglVersion;
  Names clientExtensions;
  std::vector<Platform> platforms;
  Gl gl;  // on the first platform; all empty: there is no context
};

struct ConfigColumn {
  int attribute;
  const char* title;
};
extern const std::vector<ConfigColumn> kConfigColumns;

// Opens every platform that there is. Makes one context; draws nothing.
Facts ask();

}  // namespace info
