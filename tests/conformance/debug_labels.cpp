// KHR_debug and EXT_debug_label: labels.
#include "debug_fixture.h"

namespace conformance {
namespace {

using DebugLabels = DebugFixture;

struct Object {
  GLenum khr, ext;
  GLuint name;
};

std::vector<Object> makeObjects() {
  GLuint buffer = 0, texture = 0, framebuffer = 0, renderbuffer = 0, array = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  useNearest();
  command<PFNGLGENFRAMEBUFFERSOESPROC>("glGenFramebuffersOES")(1, &framebuffer);
  command<PFNGLGENRENDERBUFFERSOESPROC>("glGenRenderbuffersOES")(1, &renderbuffer);
  command<PFNGLBINDRENDERBUFFEROESPROC>("glBindRenderbufferOES")(GL_RENDERBUFFER_OES, renderbuffer);
  command<PFNGLRENDERBUFFERSTORAGEOESPROC>("glRenderbufferStorageOES")(GL_RENDERBUFFER_OES, GL_RGBA8_OES, 4,
                                                                       4);
  command<PFNGLGENVERTEXARRAYSOESPROC>("glGenVertexArraysOES")(1, &array);
  command<PFNGLBINDVERTEXARRAYOESPROC>("glBindVertexArrayOES")(array);
  command<PFNGLBINDVERTEXARRAYOESPROC>("glBindVertexArrayOES")(0);
  command<PFNGLBINDFRAMEBUFFEROESPROC>("glBindFramebufferOES")(GL_FRAMEBUFFER_OES, framebuffer);
  command<PFNGLBINDFRAMEBUFFEROESPROC>("glBindFramebufferOES")(GL_FRAMEBUFFER_OES, 0);
  return {{kBuffer, kBufferObjectExt, buffer},
          {GL_TEXTURE, GL_TEXTURE, texture},
          {GL_FRAMEBUFFER_OES, GL_FRAMEBUFFER_OES, framebuffer},
          {GL_RENDERBUFFER_OES, GL_RENDERBUFFER_OES, renderbuffer},
          {kVertexArray, kVertexArrayObjectExt, array}};
}

TEST_F(DebugLabels, Labels) {
  MESA_DISAGREES("KHR_debug 5.7", "objects that exist are refused with INVALID_OPERATION");
  char text[300];
  for (const Object& object : makeObjects()) {
    const auto label = [&](GLsizei room = sizeof text) {
      GLsizei length = -1;
      gl.GetLabel(object.khr, object.name, room, &length, text);
      EXPECT_EQ(static_cast<std::size_t>(length), std::strlen(text));
      return std::string(text);
    };
    EXPECT_EQ(label(), "");
    gl.Label(object.khr, object.name, -1, "the first");
    EXPECT_EQ(label(), "the first");
    EXPECT_EQ(label(4), "the");
    GLsizei length = 0;
    gl.GetLabel(object.khr, object.name, 0, &length, nullptr);
    EXPECT_EQ(length, 9);
    gl.Label(object.khr, object.name, 3, "abcdef");
    EXPECT_EQ(label(), "abc");
    gl.GetLabelExt(object.ext, object.name, sizeof text, &length, text);
    EXPECT_EQ(std::string(text), "abc") << "one label, whoever asks";
    gl.LabelExt(object.ext, object.name, 0, "to the null");
    EXPECT_EQ(label(), "to the null");
    gl.LabelExt(object.ext, object.name, 2, "xyz");
    EXPECT_EQ(label(), "xy");
    gl.Label(object.khr, object.name, 5, nullptr);
    EXPECT_EQ(label(), "");
    const std::string longest(static_cast<std::size_t>(get(kMaxLabelLength)) - 1, 'x');
    gl.Label(object.khr, object.name, -1, longest.c_str());
    EXPECT_EQ(label(), longest);
    EXPECT_GL_ERROR(GL_NO_ERROR);
    gl.Label(object.khr, object.name, -1, (longest + "y").c_str());
    EXPECT_GL_ERROR(GL_INVALID_VALUE);
    gl.Label(object.khr, 77777, -1, "x");
    EXPECT_GL_ERROR(GL_INVALID_VALUE);
    gl.GetLabel(object.khr, 77777, sizeof text, nullptr, text);
    EXPECT_GL_ERROR(GL_INVALID_VALUE);
    gl.LabelExt(object.ext, 77777, 0, "x");
    EXPECT_GL_ERROR(GL_INVALID_OPERATION);
    gl.GetLabelExt(object.ext, 77777, sizeof text, nullptr, text);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION);
    gl.LabelExt(object.ext, object.name, -1, "x");
    EXPECT_GL_ERROR(GL_INVALID_VALUE);
    gl.GetLabelExt(object.ext, object.name, -1, nullptr, text);
    EXPECT_GL_ERROR(GL_INVALID_VALUE);
    gl.GetLabel(object.khr, object.name, -1, nullptr, text);
    EXPECT_GL_ERROR(GL_INVALID_VALUE);
  }
  for (const GLenum type : {GLenum{GL_RGBA}, GLenum{kBufferObjectExt}, GLenum{0x82E1}}) {  // SHADER
    gl.Label(type, 1, -1, "x");
    EXPECT_GL_ERROR(GL_INVALID_ENUM);
    gl.GetLabel(type, 1, sizeof text, nullptr, text);
    EXPECT_GL_ERROR(GL_INVALID_ENUM);
  }
  gl.LabelExt(kBuffer, 1, 0, "x");
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  gl.GetLabelExt(GL_RGBA, 1, sizeof text, nullptr, text);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  gl.PtrLabel(this, -1, "x");
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  gl.GetPtrLabel(this, sizeof text, nullptr, text);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
}

// Labels of images in use, before and after they are made.
TEST_F(DebugLabels, LabelsOfImagesInUse) {
  MESA_DISAGREES("KHR_debug 5.7", "objects that exist are refused with INVALID_OPERATION");
  const std::vector<Object> objects = makeObjects();
  const GLuint texture = objects[1].name;
  gl.Label(GL_TEXTURE, texture, -1, "before");
  glEnable(GL_TEXTURE_2D);
  drawTexturedRect({}, 0, 0, 1, 1);
  gl.Label(GL_TEXTURE, texture, -1, "after");
  drawTexturedRect({}, 0, 0, 1, 1);
  glFinish();
  gl.Label(GL_RENDERBUFFER_OES, objects[3].name, -1, "a renderbuffer");
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

}  // namespace
}  // namespace conformance
