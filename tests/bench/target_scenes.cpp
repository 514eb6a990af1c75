// Frames that change their render target again and again.

#include <EGL/egl.h>
#include <GLES/gl.h>
#include <GLES/glext.h>

#include <array>

#include "scene.h"
#include "session.h"

namespace bench {

namespace {

constexpr int kSize = 128;
constexpr unsigned kSwitches = 64;
constexpr int kCell = 16;
constexpr int kColumns = kSize / kCell;

template <class Command>
Command command(const char* name) {
  return reinterpret_cast<Command>(eglGetProcAddress(name));
}

struct Commands {
  PFNGLGENFRAMEBUFFERSOESPROC gen = command<PFNGLGENFRAMEBUFFERSOESPROC>("glGenFramebuffersOES");
  PFNGLBINDFRAMEBUFFEROESPROC bind = command<PFNGLBINDFRAMEBUFFEROESPROC>("glBindFramebufferOES");
  PFNGLFRAMEBUFFERTEXTURE2DOESPROC attach =
      command<PFNGLFRAMEBUFFERTEXTURE2DOESPROC>("glFramebufferTexture2DOES");
};

// 64 draws into two textures by turns; what came out is drawn in the end. In each step a cell gets a color;
// `pingPong`: by a full draw with the other texture first, so that both hold all cells so far.
class Switches : public Scene {
 public:
  explicit Switches(bool pingPong)
      : Scene(pingPong ? "target.ping_pong" : "target.switches",
              pingPong ? "64 draws between two 128x128 textures, each reads the other"
                       : "64 render-target switches between two 128x128 textures"),
        pingPong_(pingPong) {}

  void begin() override {
    commands_ = Commands();
    setPixelProjection();
    static constexpr std::array<float, 8> corners = {0, 0, 1, 0, 0, 1, 1, 1};
    glVertexPointer(2, GL_FLOAT, 0, corners.data());
    glTexCoordPointer(2, GL_FLOAT, 0, corners.data());
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glGenTextures(2, textures_.data());
    commands_.gen(2, targets_.data());
    for (std::size_t i = 0; i < 2; ++i) {
      glBindTexture(GL_TEXTURE_2D, textures_[i]);
      glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
      glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
      glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, kSize, kSize, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
      commands_.bind(GL_FRAMEBUFFER_OES, targets_[i]);
      commands_.attach(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, textures_[i], 0);
    }
  }

  void frame(unsigned number) override {
    glViewport(0, 0, kSize, kSize);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrthof(0, kSize, 0, kSize, -1, 1);
    glMatrixMode(GL_MODELVIEW);
    for (unsigned step = 0; step < kSwitches; ++step) {
      commands_.bind(GL_FRAMEBUFFER_OES, targets_[step % 2]);
      if (pingPong_) drawTexture(textures_[(step + 1) % 2], 0, 0, kSize);
      const Rgb color = variedColor(step + number);
      glColor4f(float(color[0]) / 255, float(color[1]) / 255, float(color[2]) / 255, 1);
      drawQuad(left(step), bottom(step), kCell);
    }
    commands_.bind(GL_FRAMEBUFFER_OES, 0);
    setPixelProjection();
    glViewport(0, 0, kWidth, kHeight);
    glClearColor(0, 0, 0.2f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (std::size_t i = 0; i < 2; ++i) drawTexture(textures_[i], int(i) * kSize, 0, kSize);
  }

  Verdict check(unsigned number) const override {
    Picture picture;
    for (unsigned step = 0; step < kSwitches; ++step) {
      const Rgb wanted = variedColor(step + number);
      for (unsigned i = 0; i < 2; ++i) {
        const bool drawn = i == step % 2 || (pingPong_ && step + 1 < kSwitches);
        if (drawn) picture.expect(int(i) * kSize + left(step) + 8, bottom(step) + 8, wanted);
      }
    }
    picture.expect(kWidth / 2, kHeight / 2, {0, 0, 51});
    return picture.verdict();
  }

 private:
  static int left(unsigned step) { return int(step % kColumns) * kCell; }
  static int bottom(unsigned step) { return int(step / kColumns) * kCell; }

  static void drawQuad(int x, int y, int size) {
    glPushMatrix();
    glTranslatef(float(x), float(y), 0);
    glScalef(float(size), float(size), 1);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glPopMatrix();
  }
  static void drawTexture(GLuint texture, int x, int y, int size) {
    glBindTexture(GL_TEXTURE_2D, texture);
    glEnable(GL_TEXTURE_2D);
    drawQuad(x, y, size);
    glDisable(GL_TEXTURE_2D);
  }

  bool pingPong_;
  Commands commands_;
  std::array<GLuint, 2> textures_{}, targets_{};
};

}  // namespace

void addTargetScenes(Scenes& scenes) {
  scenes.push_back(std::make_unique<Switches>(false));
  scenes.push_back(std::make_unique<Switches>(true));
}

}  // namespace bench
