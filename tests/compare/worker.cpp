#include "worker.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES/gl.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "canvas.h"
#include "tests/measure/picture.h"

namespace comparison {

namespace {

class Display {
 public:
  Display() : handle_(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)) {
    if (handle_ == EGL_NO_DISPLAY || !eglInitialize(handle_, nullptr, nullptr))
      throw std::runtime_error("no surfaceless display");
    eglBindAPI(EGL_OPENGL_ES_API);
  }
  ~Display() { eglTerminate(handle_); }
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;
  EGLDisplay handle() const { return handle_; }

 private:
  EGLDisplay handle_;
};

EGLConfig chooseConfig(EGLDisplay display, const Surface& surface) {
  const EGLint depth = 24, stencil = 8;
  const EGLint wanted[] = {EGL_SURFACE_TYPE,
                           EGL_PBUFFER_BIT,
                           EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_ES_BIT,
                           EGL_DEPTH_SIZE,
                           depth,
                           EGL_STENCIL_SIZE,
                           stencil,
                           EGL_SAMPLE_BUFFERS,
                           surface.samples > 0 ? 1 : 0,
                           EGL_SAMPLES,
                           surface.samples,
                           EGL_NONE};
  std::array<EGLConfig, 256> configs;
  EGLint count = 0;
  eglChooseConfig(display, wanted, configs.data(), static_cast<EGLint>(configs.size()), &count);
  const std::array<EGLint, 4> sizes =
      surface.rgb565 ? std::array<EGLint, 4>{5, 6, 5, 0} : std::array<EGLint, 4>{8, 8, 8, 8};
  constexpr std::array<EGLint, 4> names = {EGL_RED_SIZE, EGL_GREEN_SIZE, EGL_BLUE_SIZE, EGL_ALPHA_SIZE};
  const auto attribute = [display](EGLConfig config, EGLint name) {
    EGLint value = 0;
    eglGetConfigAttrib(display, config, name, &value);
    return value;
  };
  for (EGLint i = 0; i < count; ++i) {
    const EGLConfig config = configs[static_cast<std::size_t>(i)];
    bool fits = attribute(config, EGL_SAMPLES) == surface.samples;
    for (std::size_t c = 0; c < names.size(); ++c) fits = fits && attribute(config, names[c]) == sizes[c];
    if (fits) return config;
  }
  return nullptr;
}

// A pbuffer and a current context with initial state.
class Session {
 public:
  Session(EGLDisplay display, const Surface& surface) : display_(display) {
    const EGLConfig config = chooseConfig(display, surface);
    if (!config) return;
    const EGLint size[] = {EGL_WIDTH, surface.width, EGL_HEIGHT, surface.height, EGL_NONE};
    const EGLint version[] = {EGL_CONTEXT_CLIENT_VERSION, 1, EGL_NONE};
    surface_ = eglCreatePbufferSurface(display, config, size);
    context_ = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
    current_ = eglMakeCurrent(display, surface_, surface_, context_) == EGL_TRUE;
  }
  ~Session() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
    if (surface_ != EGL_NO_SURFACE) eglDestroySurface(display_, surface_);
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  bool current() const { return current_; }

 private:
  EGLDisplay display_;
  EGLSurface surface_ = EGL_NO_SURFACE;
  EGLContext context_ = EGL_NO_CONTEXT;
  bool current_ = false;
};

struct Rendered {
  measure::Picture picture;
  double milliseconds = 0;  // drawing and reading back, without the making of the context
};

void varyCoordinates(const Variant& variant) {
  if (variant.scale == 1 && variant.s == 0 && variant.t == 0) return;
  const auto scale = static_cast<GLfloat>(variant.scale);
  glMatrixMode(GL_TEXTURE);
  glTranslatef(static_cast<GLfloat>(variant.s), static_cast<GLfloat>(variant.t), 0);
  glScalef(scale, scale, 1);
  glMatrixMode(GL_MODELVIEW);
}

// An empty picture when there is no config of the kind.
Rendered render(EGLDisplay display, const Scene& scene, const Variant& variant) {
  const Session session(display, scene.surface);
  if (!session.current()) return {};
  Rendered result{{scene.surface.width, scene.surface.height, {}}, 0};
  result.picture.rgba.assign(
      static_cast<std::size_t>(scene.surface.width) * static_cast<std::size_t>(scene.surface.height) * 4,
      0xcd);
  setShift(variant.x, variant.y);
  const auto start = std::chrono::steady_clock::now();
  viewport(0, 0, scene.surface.width, scene.surface.height);
  varyCoordinates(variant);
  clear(0, 0, 0, 0);
  scene.draw();
  glReadPixels(0, 0, scene.surface.width, scene.surface.height, GL_RGBA, GL_UNSIGNED_BYTE,
               result.picture.rgba.data());
  const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
  result.milliseconds = elapsed.count();
  return result;
}

void renderVariants(EGLDisplay display, const Scene& scene, const WorkerTask& task) {
  const std::vector<Variant> all = variants(scene, task.lodError);
  Rendered rendered;
  for (int i = 0; i < task.repeats; ++i) rendered = render(display, scene, all[0]);
  if (rendered.picture.rgba.empty()) throw std::runtime_error("no such config");
  measure::writeRaw(pictureFile(task.directory, scene.name, 0), rendered.picture);
  for (std::size_t i = 1; task.varied && i < all.size(); ++i)
    measure::writeRaw(pictureFile(task.directory, scene.name, static_cast<int>(i)),
                      render(display, scene, all[i]).picture);
  std::printf("done\t%s\t%.4f\n", scene.name.c_str(), rendered.milliseconds);
}

void renderAll(EGLDisplay display, const Scene& scene, const WorkerTask& task) {
  std::printf("begin\t%s\n", scene.name.c_str());
  std::fflush(stdout);
  try {
    renderVariants(display, scene, task);
  } catch (const std::exception& error) {
    std::printf("skip\t%s\t%s\n", scene.name.c_str(), error.what());
  }
  std::fflush(stdout);
}

}  // namespace

void work(const WorkerTask& task) {
  const Display display;
  for (const Scene& scene : allScenes())
    if (std::find(task.scenes.begin(), task.scenes.end(), scene.name) != task.scenes.end())
      renderAll(display.handle(), scene, task);
}

std::vector<Variant> variants(const Scene& scene, double lodError) {
  std::vector<Variant> result = {{}};
  const double unit = 1.0 / 256, ulp = scene.coordinateUlp;
  for (double x : {-1.0, 1.0})
    for (double y : {-1.0, 1.0}) result.push_back({x * unit, y * unit, 1, 0, 0});
  // In steps, since what lies between the ends may be further off than they are.
  // Steps that meet the centres of texels, where a linear filter has its extremes.
  if (ulp > 0) {
    for (int s = -6; s <= 6; ++s)
      for (int t = -6; t <= 6; ++t) result.push_back({0, 0, 1, s / 6.0 * ulp, t / 6.0 * ulp});
  }
  if (scene.driver == Driver::kLevelOfDetail && lodError > 0) {
    for (int i = -16; i <= 16; ++i) result.push_back({0, 0, std::exp2(i / 16.0 * lodError), 0, 0});
  }
  return result;
}

std::string pictureFile(const std::string& directory, const std::string& scene, int variant) {
  return directory + "/" + measure::fileName(scene) + "." + std::to_string(variant) + ".rgba";
}

}  // namespace comparison
