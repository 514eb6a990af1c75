// Which renderer draws: ANTEROOM_RENDERER names it.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "layer/render/debug_options.h"
#include "layer/render/renderer.h"

namespace anteroom::egl {

struct RendererOptions {
  std::string device;          // ANTEROOM_DEVICE: part of a device's name, or an index
  render::DebugOptions debug;  // ANTEROOM_DEBUG
  bool minimal = false;        // ANTEROOM_MINIMAL: as little of the device as a renderer can live with
  std::optional<render::WindowSystem> windows = std::nullopt;  // whose windows will be drawn to
};

// Null: no device; `error` then says why and what to do.
using CreateDevice = std::unique_ptr<render::Device> (*)(const RendererOptions& options, std::string& error);

// Makes a renderer known; the first one is the default. Called while a program or library is loaded, by
// whoever links renderers in (layer/loader, tests).
bool addRenderer(const char* name, CreateDevice create);

// The device that the environment asks for, by which the window system's windows can be drawn to: the one
// that another display has, if it is that. Null: none, `error` says why. Called under EGL's lock.
std::shared_ptr<render::Device> findDevice(std::optional<render::WindowSystem> windows, std::string& error);
// In a process that was forked: the parent's device is no longer found.
void abandonDevice();

}  // namespace anteroom::egl
