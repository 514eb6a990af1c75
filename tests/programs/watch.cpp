// Preloaded into a program that shows frames by SDL or GLFW, of which it needs to know nothing else:
//   WATCH_FOLDER   where the pictures go
//   WATCH_FRAMES   the numbers of the frames to keep, 3,7: back buffers just before they are shown, 0003.ppm
//   WATCH_SHOWN    those that must then be seen on the screen, by
//   WATCH_SCREEN   the program for that, which is given the picture and the name of a screenshot,
//                  0003-screen.png
//   WATCH_STEP     milliseconds by which the time of SDL goes on whenever the program has seen to all
//                  events; SDL asks it to end after the last frame to keep
//   WATCH_LIGHT    by which the colors of all lights are multiplied, where the program is linked to
//                  libGLESv1_CM.so.1
#include <GLES/gl.h>
#include <GLFW/glfw3.h>
#include <SDL.h>
#include <dlfcn.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#define EXPORTED extern "C" __attribute__((visibility("default")))

namespace {

template <class Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

const char* environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

std::set<int> numbers(const char* name) {
  std::set<int> result;
  std::istringstream text(environment(name));
  for (std::string number; std::getline(text, number, ',');) result.insert(std::atoi(number.c_str()));
  return result;
}

[[noreturn]] void fail(const std::string& why) {
  std::fprintf(stderr, "watch: %s\n", why.c_str());
  _exit(3);
}

class Watch {
 public:
  static Watch& instance() {
    static Watch watch;
    return watch;
  }

  bool keepsThis() const { return kept_.contains(frame_) || shown_.contains(frame_); }
  std::string name(const char* end) const {
    char number[16];
    std::snprintf(number, sizeof number, "%04d", frame_);
    return folder_ + "/" + number + end;
  }
  // Rows of 4 bytes a pixel.
  void keep(int width, int height, bool topFirst, const std::vector<unsigned char>& pixels) const {
    std::FILE* file = std::fopen(name(".ppm").c_str(), "wb");
    if (!file) fail("cannot write " + name(".ppm"));
    std::fprintf(file, "P6\n%d %d\n255\n", width, height);
    for (int row = 0; row < height; ++row) {
      const unsigned char* at =
          pixels.data() + 4 * std::size_t(width) * std::size_t(topFirst ? row : height - 1 - row);
      for (int x = 0; x < width; ++x) std::fwrite(at + 4 * x, 1, 3, file);
    }
    std::fclose(file);
  }
  void shown() {
    if (shown_.contains(frame_)) demandOnScreen();
    ++frame_;
  }

  bool keepsTime() const { return step_ != 0; }
  unsigned time() const { return time_; }
  bool ended() const { return !kept_.empty() && frame_ > *kept_.rbegin(); }
  void pass() { time_ += step_; }

 private:
  Watch()
      : folder_(environment("WATCH_FOLDER")),
        kept_(numbers("WATCH_FRAMES")),
        shown_(numbers("WATCH_SHOWN")),
        step_(unsigned(std::atoi(environment("WATCH_STEP")))) {}

  void demandOnScreen() const {
    std::string program = environment("WATCH_SCREEN"), picture = name(".ppm"), shot = name("-screen.png");
    std::vector<char*> variables;
    for (char** variable = environ; *variable; ++variable)
      if (std::string(*variable).rfind("LD_PRELOAD=", 0) != 0) variables.push_back(*variable);
    variables.push_back(nullptr);
    char* const arguments[] = {program.data(), picture.data(), shot.data(), nullptr};
    pid_t child = 0;
    int status = 0;
    if (posix_spawn(&child, program.c_str(), nullptr, nullptr, arguments, variables.data()) != 0 ||
        waitpid(child, &status, 0) != child || status != 0)
      fail(picture + " did not come to the screen");
  }

  std::string folder_;
  std::set<int> kept_, shown_;
  unsigned step_, time_ = 1000;
  int frame_ = 0;
};

// Of the surface that is current.
void keepBackBuffer(int width, int height) {
  Watch& watch = Watch::instance();
  if (!watch.keepsThis()) return;
  void* gl = dlopen("libGLESv1_CM.so.1", RTLD_LAZY | RTLD_NOLOAD);
  if (!gl) fail("the program does not use libGLESv1_CM.so.1");
  const auto getInteger = reinterpret_cast<decltype(&glGetIntegerv)>(dlsym(gl, "glGetIntegerv"));
  const auto pixelStore = reinterpret_cast<decltype(&glPixelStorei)>(dlsym(gl, "glPixelStorei"));
  const auto readPixels = reinterpret_cast<decltype(&glReadPixels)>(dlsym(gl, "glReadPixels"));
  GLint alignment = 4;
  getInteger(GL_PACK_ALIGNMENT, &alignment);
  pixelStore(GL_PACK_ALIGNMENT, 4);
  std::vector<unsigned char> pixels(4 * std::size_t(width) * std::size_t(height));
  readPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  pixelStore(GL_PACK_ALIGNMENT, alignment);
  watch.keep(width, height, false, pixels);
}

}  // namespace

EXPORTED void glfwSwapBuffers(GLFWwindow* window) {
  int width = 0, height = 0;
  next<decltype(&glfwGetFramebufferSize)>("glfwGetFramebufferSize")(window, &width, &height);
  keepBackBuffer(width, height);
  next<decltype(&glfwSwapBuffers)>("glfwSwapBuffers")(window);
  Watch::instance().shown();
}

EXPORTED void SDL_GL_SwapWindow(SDL_Window* window) {
  int width = 0, height = 0;
  next<decltype(&SDL_GL_GetDrawableSize)>("SDL_GL_GetDrawableSize")(window, &width, &height);
  keepBackBuffer(width, height);
  next<decltype(&SDL_GL_SwapWindow)>("SDL_GL_SwapWindow")(window);
  Watch::instance().shown();
}

EXPORTED void glLightfv(GLenum light, GLenum name, const GLfloat* values) {
  static const float factor = static_cast<float>(std::atof(environment("WATCH_LIGHT")));
  const auto set = next<decltype(&glLightfv)>("glLightfv");
  if (factor == 0 || (name != GL_AMBIENT && name != GL_DIFFUSE && name != GL_SPECULAR))
    return set(light, name, values);
  const GLfloat color[] = {factor * values[0], factor * values[1], factor * values[2], values[3]};
  set(light, name, color);
}

EXPORTED Uint32 SDL_GetTicks() {
  const Watch& watch = Watch::instance();
  return watch.keepsTime() ? watch.time() : next<decltype(&SDL_GetTicks)>("SDL_GetTicks")();
}

EXPORTED int SDL_PollEvent(SDL_Event* event) {
  Watch& watch = Watch::instance();
  if (watch.keepsTime() && watch.ended() && event) {
    event->type = SDL_QUIT;
    return 1;
  }
  const int some = next<decltype(&SDL_PollEvent)>("SDL_PollEvent")(event);
  if (!some) watch.pass();
  return some;
}
