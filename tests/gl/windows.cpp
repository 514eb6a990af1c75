// The framebuffer of name 0 where it is a window's: followed from picture to picture.
#include "tests/gl/gl_fixture.h"

namespace anteroom::gl::test {

namespace {

class FakeWindow : public render::Window {
 public:
  explicit FakeWindow(FakeDevice& device) : device_(device) {}

  bool makeReady() override {
    if (isReady()) return true;
    ++begun;
    if (outOfMemory) return false;
    if (framebuffer_.width != nextWidth) {
      render::ImageDesc desc;
      desc.width = nextWidth;
      desc.height = 8;
      framebuffer_ = {};
      framebuffer_.window = this;
      framebuffer_.width = desc.width;
      framebuffer_.height = desc.height;
      framebuffer_.color.image = device_.createImage(desc);
    }
    ready_ = true;
    return true;
  }
  int age() const override { return 0; }

  int nextWidth = 16;
  int begun = 0;  // pictures
  bool outOfMemory = false;

 private:
  FakeDevice& device_;
};

class Windows : public GlTest {
 protected:
  Windows() : window(device) {
    window.makeReady();
    setDefaultFramebuffer(*context, &window.framebuffer());
    window.expire();
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, kVertices);
  }
  ~Windows() override { setDefaultFramebuffer(*context, nullptr); }
  void draw() { glDrawArrays(GL_TRIANGLES, 0, 3); }

  static constexpr GLfloat kVertices[9] = {};
  FakeWindow window;
};

}  // namespace

TEST_F(Windows, APictureBeginsWithWhatIsDrawnFirst) {
  glClearColor(1, 0, 0, 1);
  glFlush();
  EXPECT_EQ(window.begun, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  draw();
  EXPECT_EQ(window.begun, 2);
  window.expire();
  draw();
  EXPECT_EQ(window.begun, 3);
}

TEST_F(Windows, APictureBeginsWithAReadToo) {
  GLubyte pixel[4];
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  EXPECT_EQ(window.begun, 2);
}

TEST_F(Windows, ImagesOfAnotherSizeAreFollowed) {
  draw();
  window.expire();
  draw();
  EXPECT_EQ(renderer().draws.back().changed, 0u);  // the same images
  window.expire();
  window.nextWidth = 32;
  draw();
  EXPECT_EQ(state().framebuffer.width, 32);
  EXPECT_EQ(state().framebuffer.color.image, window.framebuffer().color.image);
  EXPECT_TRUE(renderer().draws.back().changed & gen::kGroupFramebuffer);
}

TEST_F(Windows, WithoutMemoryForAPictureThereIsAnError) {
  window.outOfMemory = true;
  draw();
  EXPECT_EQ(glGetError(), GLenum{GL_OUT_OF_MEMORY});
  window.outOfMemory = false;
  draw();
  EXPECT_TRUE(window.isReady());
}

}  // namespace anteroom::gl::test
