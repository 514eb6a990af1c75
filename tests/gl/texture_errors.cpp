// Every error of sections 2.9, 3.6, 3.7 and 4.3; a command that fails changes nothing.
#include "textures_fixture.h"

namespace anteroom::test {
namespace {

constexpr GLenum kCube = GL_TEXTURE_CUBE_MAP_OES;
constexpr GLenum kFace = GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES;
constexpr GLsizei kHuge = 0x7fffffff;

struct Case {
  const char* what;
  GLenum error;
  std::function<void()> call;
};

// State: texture 1 (2D) is bound and has an 8x8 RGBA level 0 and nothing else; texture 2 is a bound cube map
// with an 8x8 ALPHA face; buffer 1 of 16 bytes is bound to ARRAY_BUFFER, none to ELEMENT_ARRAY_BUFFER.
class TextureErrors : public Texture2DTest {
 protected:
  void SetUp() override {
    Texture2DTest::SetUp();
    data = noise(1024, 1);
    specify(0, 8, 8, GL_RGBA, data.data());
    glBindTexture(kCube, 2);
    glTexImage2D(kFace, 0, GL_ALPHA, 8, 8, 0, GL_ALPHA, GL_UNSIGNED_BYTE, data.data());
    glBindBuffer(GL_ARRAY_BUFFER, 1);
    glBufferData(GL_ARRAY_BUFFER, 16, data.data(), GL_DYNAMIC_DRAW);
    ASSERT_EQ(glGetError(), GLenum{GL_NO_ERROR});
  }

  void expectUnchanged() {
    FakeImage* image = draw();
    ASSERT_TRUE(image);
    ASSERT_EQ(image->desc().width, 8);
    ASSERT_EQ(image->desc().height, 8);
    ASSERT_EQ(std::memcmp(image->at(0, 0, 0, 0), data.data(), 256), 0);
    GLint size = 0, usage = 0, bound2D = 0, boundCube = 0;
    glGetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, &size);
    glGetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_USAGE, &usage);
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound2D);
    glGetIntegerv(GL_TEXTURE_BINDING_CUBE_MAP_OES, &boundCube);
    ASSERT_EQ(size, 16);
    ASSERT_EQ(usage, GL_DYNAMIC_DRAW);
    ASSERT_EQ(bound2D, 1);
    ASSERT_EQ(boundCube, 2);
    GLint filters[2] = {}, wraps[2] = {};
    glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, &filters[0]);
    glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, &filters[1]);
    glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, &wraps[0]);
    glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, &wraps[1]);
    ASSERT_EQ(filters[0], GL_NEAREST);
    ASSERT_EQ(filters[1], GL_LINEAR);
    ASSERT_EQ(wraps[0], GL_REPEAT);
    ASSERT_EQ(wraps[1], GL_REPEAT);
  }

  void run(std::initializer_list<Case> cases) {
    for (const Case& test : cases) {
      SCOPED_TRACE(test.what);
      test.call();
      EXPECT_EQ(glGetError(), test.error);
      expectUnchanged();
    }
  }

  std::vector<uint8_t> data;
};

TEST_F(TextureErrors, TexImage) {
  const auto image = [&](GLenum target, GLint level, GLint internal, GLsizei w, GLsizei h, GLint border,
                         GLenum format, GLenum type) {
    return [=, this] { glTexImage2D(target, level, internal, w, h, border, format, type, data.data()); };
  };
  constexpr GLenum kByte = GL_UNSIGNED_BYTE;
  run({
      {"target", GL_INVALID_ENUM, image(0x806F, 0, GL_RGBA, 4, 4, 0, GL_RGBA, kByte)},
      {"cube target", GL_INVALID_ENUM, image(kCube, 0, GL_RGBA, 4, 4, 0, GL_RGBA, kByte)},
      {"face beyond", GL_INVALID_ENUM, image(kFace + 6, 0, GL_RGBA, 4, 4, 0, GL_RGBA, kByte)},
      {"level < 0", GL_INVALID_VALUE, image(GL_TEXTURE_2D, -1, GL_RGBA, 4, 4, 0, GL_RGBA, kByte)},
      {"level > max", GL_INVALID_VALUE, image(GL_TEXTURE_2D, 11, GL_RGBA, 1, 1, 0, GL_RGBA, kByte)},
      {"level huge", GL_INVALID_VALUE, image(GL_TEXTURE_2D, kHuge, GL_RGBA, 1, 1, 0, GL_RGBA, kByte)},
      {"cube level", GL_INVALID_VALUE, image(kFace, 9, GL_RGBA, 1, 1, 0, GL_RGBA, kByte)},
      {"internal format", GL_INVALID_VALUE, image(GL_TEXTURE_2D, 0, 4, 4, 4, 0, GL_RGBA, kByte)},
      {"format", GL_INVALID_ENUM, image(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, 0x1234, kByte)},
      {"type", GL_INVALID_ENUM, image(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_FLOAT)},
      {"width < 0", GL_INVALID_VALUE, image(GL_TEXTURE_2D, 0, GL_RGBA, -1, 4, 0, GL_RGBA, kByte)},
      {"height < 0", GL_INVALID_VALUE, image(GL_TEXTURE_2D, 0, GL_RGBA, 4, INT32_MIN, 0, GL_RGBA, kByte)},
      {"width", GL_INVALID_VALUE, image(GL_TEXTURE_2D, 0, GL_RGBA, 1025, 1, 0, GL_RGBA, kByte)},
      {"huge", GL_INVALID_VALUE, image(GL_TEXTURE_2D, 0, GL_RGBA, kHuge, kHuge, 0, GL_RGBA, kByte)},
      {"width for the level", GL_INVALID_VALUE, image(GL_TEXTURE_2D, 1, GL_RGBA, 513, 1, 0, GL_RGBA, kByte)},
      {"last level", GL_INVALID_VALUE, image(GL_TEXTURE_2D, 10, GL_RGBA, 2, 1, 0, GL_RGBA, kByte)},
      {"border", GL_INVALID_VALUE, image(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 1, GL_RGBA, kByte)},
      {"face not square", GL_INVALID_VALUE, image(kFace, 0, GL_RGBA, 4, 8, 0, GL_RGBA, kByte)},
      {"face size", GL_INVALID_VALUE, image(kFace, 0, GL_RGBA, 257, 257, 0, GL_RGBA, kByte)},
      {"internal != format", GL_INVALID_OPERATION, image(GL_TEXTURE_2D, 0, GL_RGB, 4, 4, 0, GL_RGBA, kByte)},
      {"RGBA 565", GL_INVALID_OPERATION,
       image(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5)},
      {"RGB 4444", GL_INVALID_OPERATION,
       image(GL_TEXTURE_2D, 0, GL_RGB, 4, 4, 0, GL_RGB, GL_UNSIGNED_SHORT_4_4_4_4)},
      {"ALPHA 5551", GL_INVALID_OPERATION,
       image(GL_TEXTURE_2D, 0, GL_ALPHA, 4, 4, 0, GL_ALPHA, GL_UNSIGNED_SHORT_5_5_5_1)},
  });
}

TEST_F(TextureErrors, TexSubImage) {
  const auto image = [&](GLenum target, GLint level, GLint x, GLint y, GLsizei w, GLsizei h, GLenum format,
                         GLenum type) {
    return [=, this] { glTexSubImage2D(target, level, x, y, w, h, format, type, data.data()); };
  };
  constexpr GLenum k2D = GL_TEXTURE_2D, kByte = GL_UNSIGNED_BYTE;
  run({
      {"target", GL_INVALID_ENUM, image(kCube, 0, 0, 0, 1, 1, GL_RGBA, kByte)},
      {"level < 0", GL_INVALID_VALUE, image(k2D, -1, 0, 0, 1, 1, GL_RGBA, kByte)},
      {"level > max", GL_INVALID_VALUE, image(k2D, 11, 0, 0, 1, 1, GL_RGBA, kByte)},
      {"level undefined", GL_INVALID_OPERATION, image(k2D, 1, 0, 0, 1, 1, GL_RGBA, kByte)},
      {"face undefined", GL_INVALID_OPERATION, image(kFace + 1, 0, 0, 0, 1, 1, GL_RGBA, kByte)},
      {"format", GL_INVALID_ENUM, image(k2D, 0, 0, 0, 1, 1, 0x1234, kByte)},
      {"type", GL_INVALID_ENUM, image(k2D, 0, 0, 0, 1, 1, GL_RGBA, GL_SHORT)},
      {"other format", GL_INVALID_OPERATION, image(k2D, 0, 0, 0, 1, 1, GL_RGB, kByte)},
      {"pair", GL_INVALID_OPERATION, image(k2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5)},
      {"x < 0", GL_INVALID_VALUE, image(k2D, 0, -1, 0, 1, 1, GL_RGBA, kByte)},
      {"y < 0", GL_INVALID_VALUE, image(k2D, 0, 0, -1, 1, 1, GL_RGBA, kByte)},
      {"x + w", GL_INVALID_VALUE, image(k2D, 0, 5, 0, 4, 1, GL_RGBA, kByte)},
      {"y + h", GL_INVALID_VALUE, image(k2D, 0, 0, 8, 1, 1, GL_RGBA, kByte)},
      {"overflow", GL_INVALID_VALUE, image(k2D, 0, kHuge, kHuge, kHuge, kHuge, GL_RGBA, kByte)},
      {"width < 0", GL_INVALID_VALUE, image(k2D, 0, 4, 4, -1, 1, GL_RGBA, kByte)},
      {"height < 0", GL_INVALID_VALUE, image(k2D, 0, 4, 4, 1, -1, GL_RGBA, kByte)},
      {"nothing", GL_NO_ERROR, image(k2D, 0, 8, 8, 0, 0, GL_RGBA, kByte)},
      {"no pixels", GL_NO_ERROR,
       [] { glTexSubImage2D(k2D, 0, 0, 0, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, nullptr); }},
  });
}

TEST_F(TextureErrors, CopyTexImage) {
  const auto copy = [](GLenum target, GLint level, GLenum internal, GLint x, GLint y, GLsizei w, GLsizei h,
                       GLint border) {
    return [=] { glCopyTexImage2D(target, level, internal, x, y, w, h, border); };
  };
  constexpr GLenum k2D = GL_TEXTURE_2D;
  run({
      {"target", GL_INVALID_ENUM, copy(kCube, 0, GL_RGBA, 0, 0, 4, 4, 0)},
      {"internal format", GL_INVALID_ENUM, copy(k2D, 0, 0x1234, 0, 0, 4, 4, 0)},
      {"paletted", GL_INVALID_ENUM, copy(k2D, 0, GL_PALETTE4_RGB8_OES, 0, 0, 4, 4, 0)},
      {"level", GL_INVALID_VALUE, copy(k2D, -1, GL_RGBA, 0, 0, 4, 4, 0)},
      {"level > max", GL_INVALID_VALUE, copy(k2D, 11, GL_RGBA, 0, 0, 1, 1, 0)},
      {"width", GL_INVALID_VALUE, copy(k2D, 0, GL_RGBA, 0, 0, -4, 4, 0)},
      {"height", GL_INVALID_VALUE, copy(k2D, 0, GL_RGBA, 0, 0, 4, 1025, 0)},
      {"border", GL_INVALID_VALUE, copy(k2D, 0, GL_RGBA, 0, 0, 4, 4, 1)},
      {"face", GL_INVALID_VALUE, copy(kFace, 0, GL_RGBA, 0, 0, 4, 2, 0)},
  });
}

TEST_F(TextureErrors, CopyTexSubImage) {
  const auto copy = [](GLenum target, GLint level, GLint tx, GLint ty, GLsizei w, GLsizei h) {
    return [=] { glCopyTexSubImage2D(target, level, tx, ty, 0, 0, w, h); };
  };
  constexpr GLenum k2D = GL_TEXTURE_2D;
  run({
      {"target", GL_INVALID_ENUM, copy(0x1234, 0, 0, 0, 1, 1)},
      {"level", GL_INVALID_VALUE, copy(k2D, -1, 0, 0, 1, 1)},
      {"level undefined", GL_INVALID_OPERATION, copy(k2D, 2, 0, 0, 1, 1)},
      {"x", GL_INVALID_VALUE, copy(k2D, 0, -1, 0, 1, 1)},
      {"x + w", GL_INVALID_VALUE, copy(k2D, 0, 8, 0, 1, 1)},
      {"y + h", GL_INVALID_VALUE, copy(k2D, 0, 0, 1, 1, 8)},
      {"width", GL_INVALID_VALUE, copy(k2D, 0, 0, 0, -1, 1)},
      {"overflow", GL_INVALID_VALUE, copy(k2D, 0, kHuge, 0, kHuge, 1)},
      {"nothing", GL_NO_ERROR, copy(k2D, 0, 8, 8, 0, 0)},
  });
}

// Table 3.9: components can be dropped, not added.
TEST_F(TextureErrors, CopyComponents) {
  struct Row {
    render::Format framebuffer;
    bool alpha;
  };
  for (const Row& row : {Row{render::Format::RGB8, false}, Row{render::Format::RGB565, false},
                         Row{render::Format::RGBA8, true}, Row{render::Format::RGBA4444, true},
                         Row{render::Format::RGBA5551, true}}) {
    useFramebuffer(row.framebuffer);
    for (const GLenum format : {GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_RGB, GL_RGBA}) {
      const bool legal = row.alpha || format == GL_LUMINANCE || format == GL_RGB;
      const GLenum error = legal ? GL_NO_ERROR : GL_INVALID_OPERATION;
      glBindTexture(GL_TEXTURE_2D, 3);
      glCopyTexImage2D(GL_TEXTURE_2D, 0, format, 0, 0, 4, 4, 0);
      EXPECT_EQ(glGetError(), error);
      specify(0, 4, 4, format);
      glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 4, 4);
      EXPECT_EQ(glGetError(), error);
    }
  }
}

TEST_F(TextureErrors, Objects) {
  GLuint names[2] = {7, 7};
  GLint value = 0;
  run({
      {"GenTextures", GL_INVALID_VALUE, [&] { glGenTextures(-1, names); }},
      {"DeleteTextures", GL_INVALID_VALUE, [&] { glDeleteTextures(-1, names); }},
      {"BindTexture target", GL_INVALID_ENUM, [] { glBindTexture(kFace, 1); }},
      {"BindTexture other target", GL_INVALID_OPERATION, [] { glBindTexture(kCube, 1); }},
      {"BindTexture other target", GL_INVALID_OPERATION, [] { glBindTexture(GL_TEXTURE_2D, 2); }},
      {"GenBuffers", GL_INVALID_VALUE, [&] { glGenBuffers(-1, names); }},
      {"DeleteBuffers", GL_INVALID_VALUE, [&] { glDeleteBuffers(-1, names); }},
      {"BindBuffer", GL_INVALID_ENUM, [] { glBindBuffer(GL_TEXTURE_2D, 1); }},
      {"delete names that are none", GL_NO_ERROR,
       [] {
         const GLuint unused[3] = {0, 77, 0xffffffff};
         glDeleteTextures(3, unused);
         glDeleteBuffers(3, unused);
       }},
      {"BufferData target", GL_INVALID_ENUM, [&] { glBufferData(0, 4, data.data(), GL_STATIC_DRAW); }},
      {"BufferData size", GL_INVALID_VALUE,
       [&] { glBufferData(GL_ARRAY_BUFFER, -1, nullptr, GL_STATIC_DRAW); }},
      {"BufferData usage", GL_INVALID_ENUM, [&] { glBufferData(GL_ARRAY_BUFFER, 4, data.data(), 0x88E0); }},
      {"BufferData on 0", GL_INVALID_OPERATION,
       [&] { glBufferData(GL_ELEMENT_ARRAY_BUFFER, 4, data.data(), GL_STATIC_DRAW); }},
      {"BufferData huge", GL_OUT_OF_MEMORY,
       [] { glBufferData(GL_ARRAY_BUFFER, GLsizeiptr{1} << 50, nullptr, GL_STATIC_DRAW); }},
      {"BufferSubData target", GL_INVALID_ENUM, [&] { glBufferSubData(1, 0, 4, data.data()); }},
      {"BufferSubData on 0", GL_INVALID_OPERATION,
       [&] { glBufferSubData(GL_ELEMENT_ARRAY_BUFFER, 0, 4, data.data()); }},
      {"BufferSubData offset", GL_INVALID_VALUE,
       [&] { glBufferSubData(GL_ARRAY_BUFFER, -1, 4, data.data()); }},
      {"BufferSubData size", GL_INVALID_VALUE, [&] { glBufferSubData(GL_ARRAY_BUFFER, 0, -1, data.data()); }},
      {"BufferSubData end", GL_INVALID_VALUE, [&] { glBufferSubData(GL_ARRAY_BUFFER, 13, 4, data.data()); }},
      {"BufferSubData overflow", GL_INVALID_VALUE,
       [&] { glBufferSubData(GL_ARRAY_BUFFER, PTRDIFF_MAX, PTRDIFF_MAX, data.data()); }},
      {"BufferSubData nothing", GL_NO_ERROR, [&] { glBufferSubData(GL_ARRAY_BUFFER, 16, 0, nullptr); }},
      {"GetBufferParameter target", GL_INVALID_ENUM,
       [&] { glGetBufferParameteriv(0, GL_BUFFER_SIZE, &value); }},
      {"GetBufferParameter name", GL_INVALID_ENUM,
       [&] { glGetBufferParameteriv(GL_ARRAY_BUFFER, GL_TEXTURE_2D, &value); }},
      {"GetBufferParameter on 0", GL_INVALID_OPERATION,
       [&] { glGetBufferParameteriv(GL_ELEMENT_ARRAY_BUFFER, GL_BUFFER_SIZE, &value); }},
  });
  EXPECT_EQ(names[0], 7u);
  EXPECT_EQ(value, 0);
}

TEST_F(TextureErrors, TexParameter) {
  GLint integers[4] = {9, 9, 9, 9};
  const auto set = [](GLenum target, GLenum pname, GLenum value) {
    return [=] {
      const GLint i = static_cast<GLint>(value);
      const GLfloat f = static_cast<GLfloat>(value);
      // Six forms: all have to fail alike. The last one's error is left for the caller.
      glTexParameteri(target, pname, i);
      const GLenum error = glGetError();
      glTexParameterx(target, pname, i);
      EXPECT_EQ(glGetError(), error);
      glTexParameterf(target, pname, f);
      EXPECT_EQ(glGetError(), error);
      glTexParameteriv(target, pname, &i);
      EXPECT_EQ(glGetError(), error);
      glTexParameterxv(target, pname, &i);
      EXPECT_EQ(glGetError(), error);
      glTexParameterfv(target, pname, &f);
    };
  };
  run({
      {"target", GL_INVALID_ENUM, set(kFace, GL_TEXTURE_WRAP_S, GL_REPEAT)},
      {"name", GL_INVALID_ENUM, set(GL_TEXTURE_2D, 0x813C, 1)},
      {"min filter", GL_INVALID_ENUM, set(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_REPEAT)},
      {"min filter", GL_INVALID_ENUM, set(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, 0x2704)},
      {"mag filter", GL_INVALID_ENUM, set(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR_MIPMAP_LINEAR)},
      {"wrap s", GL_INVALID_ENUM, set(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, 0x2900)},
      {"wrap t", GL_INVALID_ENUM, set(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_NEAREST)},
      {"crop in a scalar", GL_INVALID_ENUM,
       [] { glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_CROP_RECT_OES, 1); }},
      {"nan", GL_INVALID_ENUM, [] { glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, NAN); }},
      {"infinity", GL_INVALID_ENUM, [] { glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, -INFINITY); }},
      {"get target", GL_INVALID_ENUM, [&] { glGetTexParameteriv(kFace, GL_TEXTURE_WRAP_S, integers); }},
      {"get name", GL_INVALID_ENUM, [&] { glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_2D, integers); }},
  });
  EXPECT_EQ(integers[0], 9);
}

TEST_F(TextureErrors, ReadPixels) {
  std::vector<uint8_t> out(64, 0x77);
  const std::vector<uint8_t> before = out;
  const auto read = [&](GLsizei w, GLsizei h, GLenum format, GLenum type) {
    return [=, &out] { glReadPixels(0, 0, w, h, format, type, out.data()); };
  };
  run({
      {"format", GL_INVALID_ENUM, read(1, 1, 0x1234, GL_UNSIGNED_BYTE)},
      {"type", GL_INVALID_ENUM, read(1, 1, GL_RGBA, GL_FLOAT)},
      {"width", GL_INVALID_VALUE, read(-1, 1, GL_RGBA, GL_UNSIGNED_BYTE)},
      {"height", GL_INVALID_VALUE, read(1, -1, GL_RGBA, GL_UNSIGNED_BYTE)},
      {"pair", GL_INVALID_OPERATION, read(1, 1, GL_RGB, GL_UNSIGNED_BYTE)},
      {"pair", GL_INVALID_OPERATION, read(1, 1, GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4)},
      {"null", GL_NO_ERROR, [] { glReadPixels(0, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, nullptr); }},
      {"outside", GL_NO_ERROR,
       [&] { glReadPixels(kHuge, kHuge, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, out.data()); }},
      {"outside", GL_NO_ERROR,
       [&] { glReadPixels(INT32_MIN, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, out.data()); }},
  });
  EXPECT_EQ(out, before);
}

TEST_F(TextureErrors, NoFramebuffer) {
  gl::setDefaultFramebuffer(*context, nullptr);
  uint8_t out[4];
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, out);
  EXPECT_EQ(glGetError(), GLenum{GL_INVALID_FRAMEBUFFER_OPERATION_OES});
  glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 1, 1, 0);
  EXPECT_EQ(glGetError(), GLenum{GL_INVALID_FRAMEBUFFER_OPERATION_OES});
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 1, 1);
  EXPECT_EQ(glGetError(), GLenum{GL_INVALID_FRAMEBUFFER_OPERATION_OES});
}

TEST_F(TextureErrors, NoContext) {
  gl::makeCurrent(nullptr);
  GLuint name = 5;
  GLint value = 5;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, data.data());
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, data.data());
  glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 4, 4, 0);
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 4, 4);
  glCompressedTexImage2D(GL_TEXTURE_2D, 0, GL_PALETTE4_RGB8_OES, 4, 4, 0, 56, data.data());
  glCompressedTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 4, GL_PALETTE4_RGB8_OES, 56, data.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
  glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_CROP_RECT_OES, &value);
  glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, &value);
  glDeleteTextures(1, &name);
  glGenBuffers(1, &name);
  glBindBuffer(GL_ARRAY_BUFFER, 1);
  glBufferData(GL_ARRAY_BUFFER, 4, data.data(), GL_STATIC_DRAW);
  glBufferSubData(GL_ARRAY_BUFFER, 0, 4, data.data());
  glGetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, &value);
  glDeleteBuffers(1, &name);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, data.data());
  EXPECT_FALSE(glIsTexture(1));
  EXPECT_FALSE(glIsBuffer(1));
  EXPECT_EQ(name, 5u);
  EXPECT_EQ(value, 5);
}

}  // namespace
}  // namespace anteroom::test
