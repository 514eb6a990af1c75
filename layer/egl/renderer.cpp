#include "layer/egl/renderer.h"

#include <cstdlib>
#include <string_view>
#include <vector>

namespace anteroom::egl {
namespace {

struct Renderer {
  std::string name;
  CreateDevice create;
};

// Never destroyed: displays may be initialized while a process ends.
std::vector<Renderer>& renderers() {
  static auto& instance = *new std::vector<Renderer>;
  return instance;
}

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string() : std::string(value);
}

bool isOn(const char* name) {
  const std::string value = variable(name);
  return !value.empty() && value != "0" && value != "off";
}

std::string names() {
  std::string list;
  for (const Renderer& renderer : renderers()) list += (list.empty() ? "" : ", ") + renderer.name;
  return list;
}

std::unique_ptr<render::Device> createDevice(std::optional<render::WindowSystem> windows,
                                             std::string& error) {
  const std::string wanted = variable("ANTEROOM_RENDERER");
  const RendererOptions options{variable("ANTEROOM_DEVICE"), render::debugOptions(), isOn("ANTEROOM_MINIMAL"),
                                windows};
  for (const Renderer& renderer : renderers()) {
    if (wanted.empty() || wanted == renderer.name) return renderer.create(options, error);
  }
  error = "ANTEROOM_RENDERER=" + wanted + ": no such renderer is built in; choose from: " + names();
  return nullptr;
}

// What decides which device createDevice makes, and how. ANTEROOM_DEBUG is read but once.
std::string settings() {
  std::string all;
  for (const char* name : {"ANTEROOM_RENDERER", "ANTEROOM_DEVICE", "ANTEROOM_MINIMAL"})
    all += variable(name) + '\n';
  return all;
}

struct Latest {
  std::string settings;
  std::optional<render::WindowSystem> windows;
  std::weak_ptr<render::Device> device;
};
Latest& latest() {
  static auto& instance = *new Latest;
  return instance;
}

}  // namespace

bool addRenderer(const char* name, CreateDevice create) {
  renderers().push_back({name, create});
  return true;
}

std::shared_ptr<render::Device> findDevice(std::optional<render::WindowSystem> windows, std::string& error) {
  std::string wanted = settings();
  std::shared_ptr<render::Device> device = latest().device.lock();
  const bool fits = !windows || windows == latest().windows;
  if (device != nullptr && fits && latest().settings == wanted) return device;
  device = createDevice(windows, error);
  if (device != nullptr) latest() = {std::move(wanted), windows, device};
  return device;
}

void abandonDevice() {
  latest().device.reset();
}

}  // namespace anteroom::egl
