// EXT_texture_format_BGRA8888, APPLE_texture_format_BGRA8888, EXT_read_format_bgra, IMG_read_format,
// OES_required_internalformat, ARM_rgba8, OES_depth32, OES_stencil1, OES_stencil4,
// APPLE_texture_2D_limited_npot.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "extension_commands.h"

namespace conformance {
namespace {

class PixelFormats : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  }

  static GLuint bindNew() {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    useNearest();
    return name;
  }

  static void specify(GLenum internal, GLenum format, GLenum type, const void* data, GLsizei size = 2,
                      GLint level = 0) {
    glTexImage2D(GL_TEXTURE_2D, level, static_cast<GLint>(internal), size, size, 0, format, type, data);
  }
};

// Four texels, each component different.
constexpr std::array<GLubyte, 16> kBgra = {10, 20,  30,  40,  50,  60,  70,  80,
                                           90, 100, 110, 120, 130, 140, 150, 160};

Vec4 bgraColor(std::size_t texel) {
  const GLubyte* t = &kBgra[texel * 4];
  return {t[2] / 255.0, t[1] / 255.0, t[0] / 255.0, t[3] / 255.0};
}

TEST_F(PixelFormats, BgraTexels) {
  NEEDS_EXTENSION("GL_EXT_texture_format_BGRA8888");
  for (const GLenum internal : {GLenum{GL_BGRA_EXT}, GLenum{GL_RGBA}}) {
    // APPLE_texture_format_BGRA8888 has RGBA as the internal format.
    if (internal == GL_RGBA && !hasExtension("GL_APPLE_texture_format_BGRA8888")) continue;
    bindNew();
    specify(internal, GL_BGRA_EXT, GL_UNSIGNED_BYTE, kBgra.data());
    EXPECT_GL_ERROR(GL_NO_ERROR);
    drawTexturedRect({}, 0, 0, 1, 1);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_PIXEL(16 + static_cast<int>(i % 2) * 32, 16 + static_cast<int>(i / 2) * 32, bgraColor(i), 0.001);
    }
    // A part of it, when it is in an image.
    glTexSubImage2D(GL_TEXTURE_2D, 0, 1, 0, 1, 1, GL_BGRA_EXT, GL_UNSIGNED_BYTE, &kBgra[8]);
    EXPECT_GL_ERROR(GL_NO_ERROR);
    drawTexturedRect({}, 0, 0, 1, 1);
    EXPECT_PIXEL(48, 16, bgraColor(2), 0.001);
    EXPECT_PIXEL(16, 16, bgraColor(0), 0.001);
  }
}

// The base format is RGBA: the texture's alpha is used.
TEST_F(PixelFormats, BgraModulates) {
  NEEDS_EXTENSION("GL_EXT_texture_format_BGRA8888");
  bindNew();
  specify(GL_BGRA_EXT, GL_BGRA_EXT, GL_UNSIGNED_BYTE, kBgra.data());
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
  glColor4f(0.5f, 1, 0.25f, 0.5f);
  drawTexturedRect({}, 0, 0, 1, 1);
  const Vec4 c = bgraColor(0);
  EXPECT_PIXEL(16, 16, {c[0] * 0.5, c[1], c[2] * 0.25, c[3] * 0.5});
}

TEST_F(PixelFormats, BgraErrors) {
  NEEDS_EXTENSION("GL_APPLE_texture_format_BGRA8888");
  bindNew();
  specify(GL_RGB, GL_BGRA_EXT, GL_UNSIGNED_BYTE, kBgra.data());
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  specify(GL_BGRA_EXT, GL_RGBA, GL_UNSIGNED_BYTE, kBgra.data());
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  specify(GL_RGBA, GL_BGRA_EXT, GL_UNSIGNED_SHORT_4_4_4_4, kBgra.data());
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  specify(GL_BGRA8_EXT, GL_BGRA_EXT, GL_UNSIGNED_BYTE, kBgra.data());
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_BGRA_EXT, 0, 0, 2, 2, 0);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  specify(GL_BGRA_EXT, GL_BGRA_EXT, GL_UNSIGNED_BYTE, kBgra.data());
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, kBgra.data());
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  specify(GL_RGB, GL_RGB, GL_UNSIGNED_BYTE, kBgra.data());
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_BGRA_EXT, GL_UNSIGNED_BYTE, kBgra.data());
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  // The framebuffer's pixels may be copied into one.
  specify(GL_BGRA_EXT, GL_BGRA_EXT, GL_UNSIGNED_BYTE, kBgra.data());
  glClearColor(0.2f, 0.4f, 0.6f, 0.8f);
  glClear(GL_COLOR_BUFFER_BIT);
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 2, 2);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  drawTexturedRect({}, 0, 0, 1, 1);
  EXPECT_PIXEL(5, 5, {0.2, 0.4, 0.6, 0.8});
}

TEST_F(PixelFormats, ReadBgra) {
  NEEDS_EXTENSION("GL_EXT_read_format_bgra");
  EXPECT_TRUE(onMesa() || hasExtension("GL_IMG_read_format"));
  glDisable(GL_TEXTURE_2D);
  // Left half and right half.
  const Vec4 colors[2] = {{0.8, 0.6, 0.2, 1}, {0.13, 0.2, 11 / 15.0, 0.2}};
  for (int half = 0; half < 2; ++half) {
    const Vec4& c = colors[half];
    glColor4f(static_cast<GLfloat>(c[0]), static_cast<GLfloat>(c[1]), static_cast<GLfloat>(c[2]),
              static_cast<GLfloat>(c[3]));
    drawRect({half - 1.0, -1, half + 0.0, 1});
  }
  const auto level = [](double value, int most) { return static_cast<int>(std::lround(value * most)); };
  GLubyte bytes[4 * 4] = {};
  glReadPixels(30, 8, 4, 1, GL_BGRA_EXT, GL_UNSIGNED_BYTE, bytes);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  for (int i = 0; i < 4; ++i) {
    const Vec4& c = colors[i / 2];
    const int order[4] = {2, 1, 0, 3};
    for (int k = 0; k < 4; ++k) {
      EXPECT_NEAR(bytes[4 * i + k], 255 * c[static_cast<std::size_t>(order[k])], 1) << i << " " << k;
    }
  }
  if (onMesa()) GTEST_SKIP() << "Mesa reads only in the pair that it names";
  GLushort words[5] = {0, 0, 0, 0, 0x1234};
  glReadPixels(30, 8, 4, 1, GL_BGRA_EXT, GL_UNSIGNED_SHORT_4_4_4_4_REV_EXT, words);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  for (int i = 0; i < 4; ++i) {
    const Vec4& c = colors[i / 2];
    EXPECT_EQ(words[i],
              level(c[3], 15) << 12 | level(c[0], 15) << 8 | level(c[1], 15) << 4 | level(c[2], 15));
  }
  glReadPixels(30, 8, 4, 1, GL_BGRA_EXT, GL_UNSIGNED_SHORT_1_5_5_5_REV_EXT, words);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  for (int i = 0; i < 4; ++i) {
    const Vec4& c = colors[i / 2];
    EXPECT_EQ(words[i],
              level(c[3], 1) << 15 | level(c[0], 31) << 10 | level(c[1], 31) << 5 | level(c[2], 31));
  }
  EXPECT_EQ(words[4], 0x1234) << "wrote beyond the row";
}

// Rows lie PACK_ALIGNMENT apart; pixels outside the framebuffer leave memory as it is.
TEST_F(PixelFormats, ReadBgraRows) {
  NEEDS_EXTENSION("GL_EXT_read_format_bgra");
  if (onMesa()) GTEST_SKIP() << "Mesa reads only in the pair that it names";
  glClearColor(1, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glPixelStorei(GL_PACK_ALIGNMENT, 8);
  std::vector<GLushort> words(16, 0x7777);
  glReadPixels(-1, -1, 3, 3, GL_BGRA_EXT, GL_UNSIGNED_SHORT_4_4_4_4_REV_EXT, words.data());
  EXPECT_GL_ERROR(GL_NO_ERROR);
  const std::vector<GLushort> expected = {0x7777, 0x7777, 0x7777, 0x7777, 0x7777, 0xff00, 0xff00, 0x7777,
                                          0x7777, 0xff00, 0xff00, 0x7777, 0x7777, 0x7777, 0x7777, 0x7777};
  EXPECT_EQ(words, expected);
}

TEST_F(PixelFormats, ReadBgraErrors) {
  NEEDS_EXTENSION("GL_EXT_read_format_bgra");
  if (onMesa()) GTEST_SKIP() << "Mesa has other codes";
  GLubyte out[16];
  glReadPixels(0, 0, 1, 1, GL_BGRA_EXT, GL_FLOAT, out);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  glReadPixels(0, 0, 1, 1, GL_BGRA_EXT, GL_UNSIGNED_SHORT_4_4_4_4, out);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4_REV_EXT, out);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  glReadPixels(0, 0, 1, 1, GL_SRGB_EXT, GL_UNSIGNED_BYTE, out);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
}

// --- OES_required_internalformat

struct Combination {
  GLenum format, type;
  std::vector<GLenum> sized;
};
// Table 3.4
const std::vector<Combination>& combinations() {
  static const std::vector<Combination> table = {
      {GL_RGBA, GL_UNSIGNED_BYTE, {GL_RGBA8_OES, GL_RGB5_A1_OES, GL_RGBA4_OES}},
      {GL_RGB, GL_UNSIGNED_BYTE, {GL_RGB8_OES, GL_RGB565_OES}},
      {GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, {GL_RGBA4_OES}},
      {GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, {GL_RGB5_A1_OES}},
      {GL_RGB, GL_UNSIGNED_SHORT_5_6_5, {GL_RGB565_OES}},
      {GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, {GL_LUMINANCE8_ALPHA8_OES, GL_LUMINANCE4_ALPHA4_OES}},
      {GL_LUMINANCE, GL_UNSIGNED_BYTE, {GL_LUMINANCE8_OES}},
      {GL_ALPHA, GL_UNSIGNED_BYTE, {GL_ALPHA8_OES}},
  };
  return table;
}
constexpr GLenum kSized[] = {
    GL_RGBA8_OES,     GL_RGB5_A1_OES,           GL_RGBA4_OES,  GL_RGB8_OES,
    GL_RGB565_OES,    GL_LUMINANCE8_ALPHA8_OES, GL_ALPHA8_OES, GL_LUMINANCE4_ALPHA4_OES,
    GL_LUMINANCE8_OES};

// A texel of every format as the fragment sees it under REPLACE on black, with at least the bits that the
// internal format asks for.
TEST_F(PixelFormats, RequiredFormats) {
  NEEDS_EXTENSION("GL_OES_required_internalformat");
  constexpr GLubyte kTexel[4] = {200, 100, 50, 150};
  for (const Combination& combination : combinations()) {
    for (const GLenum internal : kSized) {
      SCOPED_TRACE(fmt::format("{:#x} {:#x} {:#x}", combination.format, combination.type, internal));
      const bool legal =
          std::find(combination.sized.begin(), combination.sized.end(), internal) != combination.sized.end();
      bindNew();
      specify(internal, combination.format, combination.type, kTexel, 1);
      EXPECT_GL_ERROR(legal ? GL_NO_ERROR : GL_INVALID_OPERATION);
      if (!legal || combination.type != GL_UNSIGNED_BYTE) continue;
      glClear(GL_COLOR_BUFFER_BIT);
      glColor4f(0, 0, 0, 0);
      drawTexturedRect({}, 0, 0, 1, 1);
      const double r = 200 / 255.0, g = 100 / 255.0, b = 50 / 255.0, a = 150 / 255.0;
      Vec4 expected{};
      switch (combination.format) {
        case GL_RGBA:
          expected = {r, g, b, a};
          break;
        case GL_RGB:
          expected = {r, g, b, 0};
          break;
        case GL_LUMINANCE_ALPHA:
          expected = {r, r, r, g};
          break;
        case GL_LUMINANCE:
          expected = {r, r, r, 0};
          break;
        default:
          expected = {0, 0, 0, r};
      }
      // Half a step of the fewest bits that are asked for.
      const bool oneBit = internal == GL_RGB5_A1_OES;
      double tolerance = kOneStep;
      if (internal == GL_RGBA4_OES || internal == GL_LUMINANCE4_ALPHA4_OES) tolerance = 0.5 / 15 + kOneStep;
      if (internal == GL_RGB565_OES || oneBit) tolerance = 0.5 / 31 + kOneStep;
      const Vec4 drawn = readPixel(8, 8);
      if (oneBit && std::abs(drawn[3] - 1) < tolerance) expected[3] = 1;
      EXPECT_TRUE(near(drawn, expected, tolerance));
    }
  }
}

// A level's sub-images have the base format; their type is free.
TEST_F(PixelFormats, RequiredFormatsTakeSubImages) {
  NEEDS_EXTENSION("GL_OES_required_internalformat");
  if (onMesa()) GTEST_SKIP() << "Mesa wants the type that the internal format goes with";
  bindNew();
  const std::vector<GLubyte> data(64, 255);
  specify(GL_RGBA8_OES, GL_RGBA, GL_UNSIGNED_BYTE, data.data());
  const GLushort packed = 0xf00f;
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, &packed);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGB, GL_UNSIGNED_BYTE, &packed);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  drawTexturedRect({}, 0, 0, 1, 1);
  EXPECT_PIXEL(16, 16, {1, 0, 0, 1});
  EXPECT_PIXEL(48, 16, {1, 1, 1, 1});
}

// 3.7.9: levels of a sized format must agree in format and type, too.
TEST_F(PixelFormats, RequiredFormatsAndCompleteness) {
  NEEDS_EXTENSION("GL_OES_required_internalformat");
  if (onMesa()) GTEST_SKIP() << "Mesa does not compare types";
  const std::vector<GLubyte> data(64, 255);
  struct Row {
    GLenum internal, type;
    bool complete;
  };
  for (const Row& row :
       {Row{GL_RGB565_OES, GL_UNSIGNED_SHORT_5_6_5, true}, Row{GL_RGB565_OES, GL_UNSIGNED_BYTE, false},
        Row{GL_RGB, GL_UNSIGNED_SHORT_5_6_5, false}, Row{GL_RGB8_OES, GL_UNSIGNED_BYTE, false}}) {
    bindNew();
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    specify(GL_RGB565_OES, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, data.data());
    specify(row.internal, GL_RGB, row.type, data.data(), 1, 1);
    EXPECT_GL_ERROR(GL_NO_ERROR);
    glColor4f(0, 1, 0, 1);
    drawTexturedRect({}, 0, 0, 1, 1);
    EXPECT_PIXEL(8, 8, row.complete ? Vec4{1, 1, 1, 1} : Vec4{0, 1, 0, 1});
  }
}

// Table 3.4.y
TEST_F(PixelFormats, RequiredFormatsByCopies) {
  NEEDS_EXTENSION("GL_OES_required_internalformat");
  glDisable(GL_TEXTURE_2D);
  glClearColor(0.8f, 0.4f, 0.2f, 0.6f);
  glClear(GL_COLOR_BUFFER_BIT);
  glEnable(GL_TEXTURE_2D);
  for (const GLenum internal : kSized) {
    bindNew();
    glCopyTexImage2D(GL_TEXTURE_2D, 0, internal, 0, 0, 4, 4, 0);
    EXPECT_GL_ERROR(GL_NO_ERROR) << internal;
  }
  for (const GLenum internal : {GLenum{GL_DEPTH_COMPONENT16_OES}, GLenum{GL_STENCIL_INDEX8_OES},
                                GLenum{GL_SRGB8_ALPHA8_EXT}, GLenum{0x9999}}) {
    bindNew();
    glCopyTexImage2D(GL_TEXTURE_2D, 0, internal, 0, 0, 4, 4, 0);
    EXPECT_GL_ERROR(GL_INVALID_ENUM) << internal;
  }
  bindNew();
  glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8_OES, 0, 0, 4, 4, 0);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  drawTexturedRect({}, 0, 0, 1, 1);
  EXPECT_PIXEL(8, 8, {0.8, 0.4, 0.2, 0.6});
}

// --- renderbuffers

struct Renderbuffers {
  PFNGLGENRENDERBUFFERSOESPROC gen = command<PFNGLGENRENDERBUFFERSOESPROC>("glGenRenderbuffersOES");
  PFNGLBINDRENDERBUFFEROESPROC bind = command<PFNGLBINDRENDERBUFFEROESPROC>("glBindRenderbufferOES");
  PFNGLRENDERBUFFERSTORAGEOESPROC storage =
      command<PFNGLRENDERBUFFERSTORAGEOESPROC>("glRenderbufferStorageOES");
  PFNGLGETRENDERBUFFERPARAMETERIVOESPROC get =
      command<PFNGLGETRENDERBUFFERPARAMETERIVOESPROC>("glGetRenderbufferParameterivOES");
  PFNGLGENFRAMEBUFFERSOESPROC genFramebuffers = command<PFNGLGENFRAMEBUFFERSOESPROC>("glGenFramebuffersOES");
  PFNGLBINDFRAMEBUFFEROESPROC bindFramebuffer = command<PFNGLBINDFRAMEBUFFEROESPROC>("glBindFramebufferOES");
  PFNGLFRAMEBUFFERRENDERBUFFEROESPROC attach =
      command<PFNGLFRAMEBUFFERRENDERBUFFEROESPROC>("glFramebufferRenderbufferOES");
  PFNGLCHECKFRAMEBUFFERSTATUSOESPROC status =
      command<PFNGLCHECKFRAMEBUFFERSTATUSOESPROC>("glCheckFramebufferStatusOES");

  GLuint make(GLenum format, GLsizei size) const {
    GLuint name = 0;
    gen(1, &name);
    bind(GL_RENDERBUFFER_OES, name);
    storage(GL_RENDERBUFFER_OES, format, size, size);
    return name;
  }
  GLint parameter(GLenum pname) const {
    GLint value = -1;
    get(GL_RENDERBUFFER_OES, pname, &value);
    return value;
  }
  // A framebuffer object with color and one more.
  void useFramebuffer(GLenum point, GLuint other, GLsizei size) const {
    GLuint object = 0;
    genFramebuffers(1, &object);
    bindFramebuffer(GL_FRAMEBUFFER_OES, object);
    attach(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_RENDERBUFFER_OES, make(GL_RGBA8_OES, size));
    attach(GL_FRAMEBUFFER_OES, point, GL_RENDERBUFFER_OES, other);
    glViewport(0, 0, size, size);
  }
};

TEST_F(PixelFormats, RenderbufferFormats) {
  struct Row {
    const char* extension;
    GLenum format, point, size;
    int bits;
  };
  const Renderbuffers buffers;
  for (const Row& row :
       {Row{"GL_ARM_rgba8", GL_RGBA8_OES, GL_COLOR_ATTACHMENT0_OES, GL_RENDERBUFFER_ALPHA_SIZE_OES, 8},
        Row{"GL_OES_depth32", GL_DEPTH_COMPONENT32_OES, GL_DEPTH_ATTACHMENT_OES,
            GL_RENDERBUFFER_DEPTH_SIZE_OES, 32},
        Row{"GL_OES_stencil1", GL_STENCIL_INDEX1_OES, GL_STENCIL_ATTACHMENT_OES,
            GL_RENDERBUFFER_STENCIL_SIZE_OES, 1},
        Row{"GL_OES_stencil4", GL_STENCIL_INDEX4_OES, GL_STENCIL_ATTACHMENT_OES,
            GL_RENDERBUFFER_STENCIL_SIZE_OES, 4}}) {
    if (onMesa() && !hasExtension(row.extension)) continue;
    EXPECT_TRUE(hasExtension(row.extension)) << row.extension;
    const GLuint name = buffers.make(row.format, 16);
    EXPECT_GL_ERROR(GL_NO_ERROR) << row.extension;
    EXPECT_EQ(buffers.parameter(GL_RENDERBUFFER_INTERNAL_FORMAT_OES), static_cast<GLint>(row.format));
    EXPECT_GE(buffers.parameter(row.size), row.bits) << row.extension;
    buffers.useFramebuffer(row.point, name, 16);
    EXPECT_EQ(buffers.status(GL_FRAMEBUFFER_OES), GLenum{GL_FRAMEBUFFER_COMPLETE_OES}) << row.extension;
  }
  buffers.bindFramebuffer(GL_FRAMEBUFFER_OES, 0);
}

// Depths that 16 or 24 bits do not tell apart.
TEST_F(PixelFormats, Depth32Resolves) {
  NEEDS_EXTENSION("GL_OES_depth32");
  glDisable(GL_TEXTURE_2D);
  const Renderbuffers buffers;
  buffers.useFramebuffer(GL_DEPTH_ATTACHMENT_OES, buffers.make(GL_DEPTH_COMPONENT32_OES, 16), 16);
  GLint bits = 0;
  glGetIntegerv(GL_DEPTH_BITS, &bits);
  EXPECT_GE(bits, 32);
  glEnable(GL_DEPTH_TEST);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  // Window depths near 0, 2^-28 apart.
  const double step = std::ldexp(1.0, -28);
  glDepthRangef(0, static_cast<GLfloat>(std::ldexp(1.0, -20)));
  const auto at = [&](double depth) { return depth * std::ldexp(1.0, 20) * 2 - 1; };
  glColor4f(1, 0, 0, 1);
  drawRect({-1, -1, 1, 1, at(3 * step)});
  glColor4f(0, 1, 0, 1);
  drawRect({-1, -1, 0, 1, at(2 * step)});
  glColor4f(0, 0, 1, 1);
  drawRect({0, -1, 1, 1, at(4 * step)});
  const Image drawn = readImage(0, 0, 16, 16);
  EXPECT_TRUE(near(drawn.at(4, 8), {0, 1, 0, 1})) << "nearer";
  EXPECT_TRUE(near(drawn.at(12, 8), {1, 0, 0, 1})) << "farther";
  glDepthRangef(0, 1);
  buffers.bindFramebuffer(GL_FRAMEBUFFER_OES, 0);
}

TEST_F(PixelFormats, FewStencilBits) {
  glDisable(GL_TEXTURE_2D);
  const Renderbuffers buffers;
  for (const auto& [extension, format] : {std::pair{"GL_OES_stencil1", GLenum{GL_STENCIL_INDEX1_OES}},
                                          std::pair{"GL_OES_stencil4", GLenum{GL_STENCIL_INDEX4_OES}}}) {
    NEEDS_EXTENSION(extension);
    buffers.useFramebuffer(GL_STENCIL_ATTACHMENT_OES, buffers.make(format, 16), 16);
    glClear(GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, 1, 1);
    glStencilOp(GL_REPLACE, GL_REPLACE, GL_REPLACE);
    drawRect({-1, -1, 0, 1});
    glStencilFunc(GL_EQUAL, 1, 1);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    glColor4f(0, 0, 1, 1);
    drawRect();
    const Image drawn = readImage(0, 0, 16, 16);
    EXPECT_TRUE(near(drawn.at(4, 8), {0, 0, 1, 1}));
    EXPECT_TRUE(near(drawn.at(12, 8), {0, 0, 0, 0}));
    glDisable(GL_STENCIL_TEST);
    glColor4f(1, 1, 1, 1);
  }
  buffers.bindFramebuffer(GL_FRAMEBUFFER_OES, 0);
}

// APPLE_texture_2D_limited_npot, and OES_texture_npot beside it.
TEST_F(PixelFormats, LimitedNpot) {
  NEEDS_EXTENSION("GL_APPLE_texture_2D_limited_npot");
  bindNew();
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  std::vector<GLubyte> texels;
  for (int i = 0; i < 15; ++i) {
    for (const int c : {i * 16, 255 - i * 16, i % 3 * 100, 255}) texels.push_back(static_cast<GLubyte>(c));
  }
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 3, 5, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  EXPECT_GL_ERROR(GL_NO_ERROR);
  glViewport(0, 0, 3, 5);
  drawTexturedRect({}, 0, 0, 1, 1);
  const Image drawn = readImage(0, 0, 3, 5);
  for (int i = 0; i < 15; ++i) {
    EXPECT_TRUE(near(drawn.at(i % 3, i / 3), {i * 16 / 255.0, 1 - i * 16 / 255.0, i % 3 * 100 / 255.0, 1}));
  }
}

}  // namespace
}  // namespace conformance
