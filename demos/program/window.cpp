#include "window.h"

#include <GLES/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "frame_files.h"
#include "playback.h"
#include "room/context.h"
#include "room/overlay.h"
#include "room/picture.h"

namespace program {
namespace {

struct Binding {
  int key;
  Action action;
  const char* help;  // a line of the overlay; empty for a second key of the line above
};
constexpr std::array kBindings = {
    Binding{GLFW_KEY_SPACE, Action::Pause, "SPACE         pause, go on"},
    Binding{GLFW_KEY_PERIOD, Action::StepForward, "PERIOD COMMA  a frame on, back"},
    Binding{GLFW_KEY_COMMA, Action::StepBack, ""},
    Binding{GLFW_KEY_RIGHT, Action::NextStage, "RIGHT LEFT    next stage, previous"},
    Binding{GLFW_KEY_TAB, Action::NextStage, ""},
    Binding{GLFW_KEY_LEFT, Action::PreviousStage, ""},
    Binding{GLFW_KEY_A, Action::TurnLeft, "A  D          camera left, right"},
    Binding{GLFW_KEY_D, Action::TurnRight, ""},
    Binding{GLFW_KEY_W, Action::Nearer, "W  S          nearer, farther"},
    Binding{GLFW_KEY_S, Action::Farther, ""},
    Binding{GLFW_KEY_R, Action::ResetCamera, "R             camera as it was"},
    Binding{GLFW_KEY_P, Action::SavePicture, "P             save a picture"},
    Binding{GLFW_KEY_H, Action::Help, "H  F1         hide this"},
    Binding{GLFW_KEY_F1, Action::Help, ""},
    Binding{GLFW_KEY_ESCAPE, Action::Quit, "ESC           quit"}};

std::string glfwMessage() {
  const char* message = nullptr;
  glfwGetError(&message);
  return message != nullptr ? message : "no reason given";
}

// Owns GLFW, a window and its context, current on the creating thread.
class Window {
 public:
  Window(Size size, int samples, bool resizable) {
    if (glfwInit() != GLFW_TRUE) {
      throw UsageError(fmt::format("--window: no window system: {}", glfwMessage()));
    }
    glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_ES_API);
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 1);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
    glfwWindowHint(GLFW_ALPHA_BITS, 8);
    glfwWindowHint(GLFW_DEPTH_BITS, 24);
    glfwWindowHint(GLFW_STENCIL_BITS, 8);
    glfwWindowHint(GLFW_SAMPLES, samples);
    glfwWindowHint(GLFW_RESIZABLE, resizable ? GLFW_TRUE : GLFW_FALSE);
    window_ = glfwCreateWindow(size.width, size.height, "rooms", nullptr, nullptr);
    if (window_ == nullptr) {
      const std::string message = fmt::format("--window: no OpenGL ES 1.1 context: {}", glfwMessage());
      glfwTerminate();
      throw UsageError(message);
    }
    glfwMakeContextCurrent(window_);
    glfwSetWindowUserPointer(window_, this);
    glfwSetKeyCallback(window_, onKey);
  }
  ~Window() { glfwTerminate(); }
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  bool closed() const { return glfwWindowShouldClose(window_) == GLFW_TRUE; }
  // In pixels; nothing while it is an icon.
  Size size() const {
    Size size{};
    glfwGetFramebufferSize(window_, &size.width, &size.height);
    return size;
  }
  void setTitle(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }
  void present() { glfwSwapBuffers(window_); }
  // What keys have asked for since the last call; waits for an event first, where told to.
  std::vector<Action> takeActions(bool wait) {
    wait ? glfwWaitEvents() : glfwPollEvents();
    return std::exchange(actions_, {});
  }

 private:
  static void onKey(GLFWwindow* window, int key, int, int happened, int) {
    if (happened == GLFW_RELEASE) return;
    for (const Binding& binding : kBindings) {
      if (binding.key == key)
        static_cast<Window*>(glfwGetWindowUserPointer(window))->actions_.push_back(binding.action);
    }
  }

  GLFWwindow* window_ = nullptr;
  std::vector<Action> actions_;
};

std::vector<std::string> helpLines(const Playback& playback) {
  std::vector<std::string> lines = {
      fmt::format("{}, {:.2f} s{}", playback.stage(), playback.time(), playback.paused() ? ", paused" : "")};
  for (const Binding& binding : kBindings) {
    if (*binding.help != '\0') lines.emplace_back(binding.help);
  }
  return lines;
}

// Named after its time, which --time takes to draw it again; no picture takes another's place.
std::filesystem::path freeName(const Options& options, const std::string& stem, double time) {
  const std::string format = options.format == "gif" ? "png" : options.format;
  const std::string name = fmt::format("{}-{:.3f}s", stem, time);
  std::filesystem::path file = std::filesystem::path(options.out) / fmt::format("{}.{}", name, format);
  for (int i = 2; std::filesystem::exists(file); ++i)
    file.replace_filename(fmt::format("{}-{}.{}", name, i, format));
  return file;
}

// A full disk does not end the show.
void savePicture(const Options& options, const std::string& stem, const room::View& view) {
  try {
    std::filesystem::create_directories(options.out);
    const std::filesystem::path file = freeName(options, stem, view.time);
    room::writePicture(file, room::readPicture(view.width, view.height));
    fmt::print("saved {}\n", file.string());
    std::fflush(stdout);
  } catch (const std::exception& error) {
    fmt::print(stderr, "rooms: {}\n", error.what());
  }
}

void play(Window& window, const room::DemoEntry& entry, room::Demo& demo, std::string_view firstStage,
          const Options& options) {
  using Clock = std::chrono::steady_clock;
  glfwSwapInterval(1);
  room::Overlay overlay;
  Playback playback(demo.stages(), firstStage, options.time, 1 / options.fps);
  std::string_view titled;
  auto last = Clock::now();
  while (!window.closed() && !playback.quits()) {
    const Size size = window.size();
    const bool visible = size.width > 0 && size.height > 0;
    if (visible) {
      if (titled != playback.stage()) {
        titled = playback.stage();
        window.setTitle(fmt::format("rooms: {}, {} (H: help)", entry.name, titled));
      }
      const room::View view = playback.view(size.width, size.height);
      demo.frame(view, playback.stage());
      if (playback.takePictureRequest()) savePicture(options, stemOf(entry, demo, playback.stage()), view);
      if (playback.helps()) {
        glViewport(0, 0, view.width, view.height);  // a stage may end in a part of it
        overlay.draw(view, helpLines(playback), 0.85);
      }
      room::checkErrors(fmt::format("{} at {} s", entry.name, view.time));
      window.present();
    }
    const bool waits = playback.paused() || !visible;
    const std::vector<Action> actions = window.takeActions(waits);
    const auto now = Clock::now();
    if (!waits) playback.advance(std::chrono::duration<double>(now - last).count());
    last = now;
    for (Action action : actions) playback.handle(action);
  }
}

void showFrames(Window& window, const room::DemoEntry& entry, room::Demo& demo, std::string_view stage,
                const Options& options) {
  glfwSwapInterval(0);
  const FrameRange range = parseFrames(options.frames);
  const std::string stem = stemOf(entry, demo, stage);
  window.setTitle(fmt::format("rooms: {}, {}", entry.name, stage));
  FrameFiles files(options, stem);
  for (int frame = range.first; frame <= range.last && !window.closed(); ++frame) {
    const Size size = window.size();
    const room::View view{size.width, size.height, timeOf(options, frame)};
    demo.frame(view, stage);
    files.add(frame, room::readPicture(view.width, view.height));
    room::checkErrors(fmt::format("frame {} of {}", frame, stem));
    window.present();
    for (Action action : window.takeActions(false)) {
      if (action == Action::Quit) return files.finish();
    }
  }
  files.finish();
}

}  // namespace

void show(const room::DemoEntry& entry, const Options& options) {
  checkFrames(options);
  const std::vector<std::string_view> stages = chosenStages(*entry.make(), entry.name, options.stage);
  Window window(parseSize(options.size), options.samples, !options.framesChosen);
  const std::unique_ptr<room::Demo> demo = entry.make();  // after the context, so that it goes before it
  demo->configure(options.settings);
  demo->setup();
  room::checkErrors(fmt::format("the setup of {}", entry.name));
  if (!options.framesChosen) return play(window, entry, *demo, stages.front(), options);
  makeFolder(options.out);
  for (std::string_view stage : stages) showFrames(window, entry, *demo, stage, options);
}

}  // namespace program
