// Texture and buffer objects: names, bindings, sharing, parameters, images of EGL.
#include "layer/gl/vertices/buffer.h"
#include "textures_fixture.h"

namespace anteroom::test {
namespace {

GLint integer(GLenum pname) {
  GLint value = -1;
  glGetIntegerv(pname, &value);
  return value;
}

using TextureObjects = Texture2DTest;

TEST_F(TextureObjects, TextureNames) {
  GLuint names[3] = {};
  glGenTextures(3, names);
  EXPECT_TRUE(names[0] && names[1] && names[2] && names[0] != names[1] && names[1] != names[2]);
  EXPECT_FALSE(glIsTexture(names[0]));
  glBindTexture(GL_TEXTURE_2D, names[0]);
  EXPECT_TRUE(glIsTexture(names[0]));
  EXPECT_EQ(integer(GL_TEXTURE_BINDING_2D), static_cast<GLint>(names[0]));
  glBindTexture(GL_TEXTURE_2D, 0xfffffff0);  // a name that nobody generated
  EXPECT_TRUE(glIsTexture(0xfffffff0));
  EXPECT_FALSE(glIsTexture(0));
  glDeleteTextures(3, names);
  EXPECT_FALSE(glIsTexture(names[0]));
  glGenTextures(0, nullptr);
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST_F(TextureObjects, DeletedTexturesLeaveEveryUnit) {
  specify(0, 2, 2);
  glActiveTexture(GL_TEXTURE3);
  glBindTexture(GL_TEXTURE_2D, 1);
  glEnable(GL_TEXTURE_2D);
  draw();
  EXPECT_TRUE(renderer(context).textures[3].image);
  const GLuint name = 1;
  glDeleteTextures(1, &name);
  draw();
  EXPECT_FALSE(renderer(context).textures[0].image);
  EXPECT_FALSE(renderer(context).textures[3].image);
  EXPECT_EQ(integer(GL_TEXTURE_BINDING_2D), 0);
  glBindTexture(GL_TEXTURE_CUBE_MAP_OES, 1);  // the name is free for another target
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST_F(TextureObjects, ClearBetweenEnableAndDraw) {
  specify(0, 2, 2);
  glDisable(GL_TEXTURE_2D);
  EXPECT_FALSE(draw());
  glEnable(GL_TEXTURE_2D);
  glClear(GL_COLOR_BUFFER_BIT);
  EXPECT_TRUE(draw());
}

TEST_F(TextureObjects, DefaultTextures) {
  glBindTexture(GL_TEXTURE_2D, 0);
  filter(GL_TEXTURE_2D, GL_LINEAR);
  specify(0, 2, 2, GL_ALPHA);
  EXPECT_TRUE(draw());
  glActiveTexture(GL_TEXTURE1);
  glEnable(GL_TEXTURE_2D);
  draw();
  EXPECT_EQ(renderer(context).textures[1].image, renderer(context).textures[0].image);
}

TEST_F(TextureObjects, Parameters) {
  struct Case {
    GLenum pname;
    GLint initial;
    std::vector<GLint> legal;
  };
  const Case cases[] = {
      {GL_TEXTURE_MIN_FILTER,
       GL_NEAREST_MIPMAP_LINEAR,
       {GL_NEAREST, GL_LINEAR, GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_NEAREST, GL_NEAREST_MIPMAP_LINEAR,
        GL_LINEAR_MIPMAP_LINEAR}},
      {GL_TEXTURE_MAG_FILTER, GL_LINEAR, {GL_NEAREST, GL_LINEAR}},
      {GL_TEXTURE_WRAP_S, GL_REPEAT, {GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT_OES, GL_REPEAT}},
      {GL_TEXTURE_WRAP_T, GL_REPEAT, {GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT_OES, GL_REPEAT}},
      {GL_GENERATE_MIPMAP, GL_FALSE, {GL_TRUE, GL_FALSE}},
  };
  GLuint name = 10;
  for (const GLenum target : {GL_TEXTURE_2D, GL_TEXTURE_CUBE_MAP_OES}) {
    glBindTexture(target, name++);
    for (const Case& test : cases) {
      const auto expect = [&](GLint wanted) {
        GLint i = -1;
        GLfixed x = -1;
        GLfloat f = -1;
        glGetTexParameteriv(target, test.pname, &i);
        glGetTexParameterxv(target, test.pname, &x);
        glGetTexParameterfv(target, test.pname, &f);
        EXPECT_EQ(i, wanted);
        EXPECT_EQ(x, wanted);
        EXPECT_EQ(f, static_cast<GLfloat>(wanted));
      };
      expect(test.initial);
      for (const GLint value : test.legal) {
        const GLfloat f = static_cast<GLfloat>(value);
        const GLint other = test.legal.front() == value ? test.legal.back() : test.legal.front();
        const std::function<void()> forms[] = {
            [&] { glTexParameteri(target, test.pname, value); },
            [&] { glTexParameterx(target, test.pname, value); },
            [&] { glTexParameterf(target, test.pname, f); },
            [&] { glTexParameteriv(target, test.pname, &value); },
            [&] { glTexParameterxv(target, test.pname, &value); },
            [&] { glTexParameterfv(target, test.pname, &f); },
        };
        for (const auto& form : forms) {
          glTexParameteri(target, test.pname, other);
          form();
          expect(value);
        }
      }
    }
  }
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST_F(TextureObjects, CropRectangle) {
  const GLint integers[4] = {1, -2, 0x7fffffff, INT32_MIN};
  const GLfixed fixeds[4] = {65536, -131072, 3 << 16, 4 << 16};
  const GLfloat floats[4] = {1, 2.4f, -3.6f, NAN};
  GLint got[4];
  GLfixed gotFixed[4];
  GLfloat gotFloat[4];
  glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_CROP_RECT_OES, integers);
  glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_CROP_RECT_OES, got);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(got[i], integers[i]);
  glGetTexParameterxv(GL_TEXTURE_2D, GL_TEXTURE_CROP_RECT_OES, gotFixed);  // saturates
  const GLfixed saturated[4] = {65536, -131072, 0x7fffffff, INT32_MIN};
  for (int i = 0; i < 4; ++i) EXPECT_EQ(gotFixed[i], saturated[i]);
  glTexParameterxv(GL_TEXTURE_2D, GL_TEXTURE_CROP_RECT_OES, fixeds);
  glGetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_CROP_RECT_OES, gotFloat);
  const GLfloat wantedFloat[4] = {1, -2, 3, 4};
  for (int i = 0; i < 4; ++i) EXPECT_EQ(gotFloat[i], wantedFloat[i]);
  glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_CROP_RECT_OES, floats);
  glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_CROP_RECT_OES, got);
  const GLint rounded[4] = {1, 2, -4, 0};
  for (int i = 0; i < 4; ++i) EXPECT_EQ(got[i], rounded[i]);
}

TEST_F(TextureObjects, SharedTextures) {
  const std::vector<uint8_t> data = noise(64, 1);
  specify(0, 4, 4, GL_RGBA, data.data());
  draw();
  ContextPtr other = gl::createContext(device, context.get(), {});
  render::Framebuffer framebuffer;
  framebuffer.color.image = color;
  framebuffer.width = kWidth;
  framebuffer.height = kHeight;
  gl::setDefaultFramebuffer(*other, &framebuffer);

  gl::makeCurrent(other.get());
  EXPECT_TRUE(glIsTexture(1));
  EXPECT_EQ(integer(GL_TEXTURE_BINDING_2D), 0);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, kPositions);
  glEnable(GL_TEXTURE_2D);
  glBindTexture(GL_TEXTURE_2D, 1);
  FakeImage* image = drawWith(other);
  ASSERT_TRUE(image);
  EXPECT_EQ(std::memcmp(image->at(0, 0, 0, 0), data.data(), 64), 0);
  specify(0, 2, 2, GL_ALPHA);  // the other context must see a new image

  gl::makeCurrent(context.get());
  EXPECT_EQ(draw()->desc().width, 2);
  EXPECT_EQ(renderer(context).units[0].baseFormat, GLenum{GL_ALPHA});
  const GLuint name = 1;
  glDeleteTextures(1, &name);  // bindings of other contexts are not affected

  gl::makeCurrent(other.get());
  EXPECT_FALSE(glIsTexture(1));
  EXPECT_EQ(drawWith(other)->desc().width, 2);
  gl::makeCurrent(nullptr);
  other.reset();
  EXPECT_EQ(device.log.liveImages, 0);
  gl::makeCurrent(context.get());
}

TEST_F(TextureObjects, BoundImages) {
  const auto pbuffer = device.createImage({.format = render::Format::RGBA8, .width = 8, .height = 4});
  specify(0, 2, 2);
  EXPECT_FALSE(gl::bindTexImage(*context, GL_TEXTURE_CUBE_MAP_OES, pbuffer, true));
  EXPECT_TRUE(gl::bindTexImage(*context, GL_TEXTURE_2D, pbuffer, true));
  EXPECT_EQ(draw(), pbuffer.get());
  EXPECT_EQ(renderer(context).units[0].baseFormat, GLenum{GL_RGBA});
  filter(GL_TEXTURE_2D, GL_LINEAR_MIPMAP_LINEAR);
  EXPECT_FALSE(draw());
  filter(GL_TEXTURE_2D, GL_LINEAR);
  glBindTexture(GL_TEXTURE_2D, 0);
  gl::releaseTexImage(*context, pbuffer);  // from a texture that is bound nowhere
  glBindTexture(GL_TEXTURE_2D, 1);
  EXPECT_FALSE(draw());

  EXPECT_TRUE(gl::bindTexImage(*context, GL_TEXTURE_2D, pbuffer, false));
  EXPECT_EQ(draw(), pbuffer.get());
  EXPECT_EQ(renderer(context).units[0].baseFormat, GLenum{GL_RGB});
  // Specifying any level gives the image back, with what was level 0 (EGL 1.5, 3.6.1).
  specify(1, 4, 2);
  EXPECT_EQ(pbuffer.use_count(), 1);
  EXPECT_FALSE(draw());
  gl::releaseTexImage(*context, pbuffer);
  EXPECT_TRUE(gl::bindTexImage(*context, GL_TEXTURE_2D, pbuffer, true));
  const GLuint name = 1;
  glDeleteTextures(1, &name);
  EXPECT_EQ(pbuffer.use_count(), 1);
}

TEST_F(TextureObjects, Buffers) {
  GLuint names[2];
  glGenBuffers(2, names);
  EXPECT_FALSE(glIsBuffer(names[0]));
  glBindBuffer(GL_ARRAY_BUFFER, names[0]);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, names[0]);
  EXPECT_TRUE(glIsBuffer(names[0]));
  EXPECT_FALSE(glIsBuffer(0));
  const auto parameter = [](GLenum pname) {
    GLint value = -1;
    glGetBufferParameteriv(GL_ARRAY_BUFFER, pname, &value);
    return value;
  };
  EXPECT_EQ(parameter(GL_BUFFER_SIZE), 0);
  EXPECT_EQ(parameter(GL_BUFFER_USAGE), GL_STATIC_DRAW);

  const std::vector<uint8_t> data = noise(64, 1), other = noise(64, 2);
  glBufferData(GL_ARRAY_BUFFER, 64, data.data(), GL_DYNAMIC_DRAW);
  EXPECT_EQ(parameter(GL_BUFFER_SIZE), 64);
  EXPECT_EQ(parameter(GL_BUFFER_USAGE), GL_DYNAMIC_DRAW);
  gl::BufferObject& buffer = *context->arrayBuffer;
  EXPECT_EQ(std::memcmp(buffer.store->contents(), data.data(), 64), 0);
  glBufferSubData(GL_ELEMENT_ARRAY_BUFFER, 10, 20, other.data());
  EXPECT_EQ(std::memcmp(buffer.store->contents() + 10, other.data(), 20), 0);
  EXPECT_EQ(std::memcmp(buffer.store->contents() + 30, data.data() + 30, 34), 0);

  context->told = 0;
  glBufferData(GL_ARRAY_BUFFER, 64, other.data(), GL_STATIC_DRAW);  // the same store again
  EXPECT_EQ(device.log.buffers, 1);
  EXPECT_EQ(context->told, 0u);
  EXPECT_EQ(std::memcmp(buffer.store->contents(), other.data(), 64), 0);
  glBufferData(GL_ARRAY_BUFFER, 32, nullptr, GL_STATIC_DRAW);
  EXPECT_EQ(parameter(GL_BUFFER_SIZE), 32);
  EXPECT_EQ(context->told, gen::Groups{gen::kGroupArrays});
  device.log.failAfter = 0;
  glBufferData(GL_ARRAY_BUFFER, 16, nullptr, GL_DYNAMIC_DRAW);
  EXPECT_EQ(glGetError(), GLenum{GL_OUT_OF_MEMORY});
  EXPECT_EQ(parameter(GL_BUFFER_SIZE), 32);
  EXPECT_EQ(parameter(GL_BUFFER_USAGE), GL_STATIC_DRAW);
  device.log.failAfter = 0;
  glBufferSubData(GL_ARRAY_BUFFER, 0, 4, data.data());
  EXPECT_EQ(glGetError(), GLenum{GL_OUT_OF_MEMORY});
  glBufferData(GL_ARRAY_BUFFER, 0, data.data(), GL_STATIC_DRAW);
  EXPECT_EQ(parameter(GL_BUFFER_SIZE), 0);

  glVertexPointer(2, GL_FLOAT, 0, nullptr);
  EXPECT_EQ(integer(GL_VERTEX_ARRAY_BUFFER_BINDING), static_cast<GLint>(names[0]));
  glDeleteBuffers(2, names);
  EXPECT_EQ(integer(GL_ARRAY_BUFFER_BINDING), 0);
  EXPECT_EQ(integer(GL_ELEMENT_ARRAY_BUFFER_BINDING), 0);
  EXPECT_EQ(integer(GL_VERTEX_ARRAY_BUFFER_BINDING), 0);
  EXPECT_FALSE(glIsBuffer(names[0]));
}

TEST_F(TextureObjects, SharedBuffers) {
  const std::vector<uint8_t> data = noise(64, 1);
  glBindBuffer(GL_ARRAY_BUFFER, 5);
  glBufferData(GL_ARRAY_BUFFER, 64, data.data(), GL_STATIC_DRAW);
  ContextPtr other = gl::createContext(device, context.get(), {});
  gl::makeCurrent(other.get());
  EXPECT_EQ(integer(GL_ARRAY_BUFFER_BINDING), 0);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 5);
  EXPECT_EQ(other->vertexArrays.elementBuffer, context->arrayBuffer);
  const GLuint name = 5;
  glDeleteBuffers(1, &name);
  EXPECT_EQ(integer(GL_ELEMENT_ARRAY_BUFFER_BINDING), 0);
  gl::makeCurrent(context.get());
  EXPECT_EQ(integer(GL_ARRAY_BUFFER_BINDING), 5);  // not affected
  glBufferSubData(GL_ARRAY_BUFFER, 0, 4, data.data());
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

}  // namespace
}  // namespace anteroom::test
