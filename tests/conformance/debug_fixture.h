// What the cases of KHR_debug and EXT_debug_label stand on.
#pragma once

#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "extension_commands.h"
#include "other_context.h"

namespace conformance {

// <GLES/glext.h> has none of these; the numbers are the registry's.
enum : GLenum {
  kSynchronous = 0x8242,
  kNextLength = 0x8243,
  kCallbackFunction = 0x8244,
  kCallbackUserParam = 0x8245,
  kSourceApi = 0x8246,
  kSourceThirdParty = 0x8249,
  kSourceApplication = 0x824A,
  kTypeError = 0x824C,
  kTypePerformance = 0x8250,
  kTypeOther = 0x8251,
  kTypeMarker = 0x8268,
  kTypePushGroup = 0x8269,
  kTypePopGroup = 0x826A,
  kNotification = 0x826B,
  kMaxGroupDepth = 0x826C,
  kGroupDepth = 0x826D,
  kBuffer = 0x82E0,
  kVertexArray = 0x8074,
  kMaxLabelLength = 0x82E8,
  kMaxMessageLength = 0x9143,
  kMaxLogged = 0x9144,
  kLogged = 0x9145,
  kHigh = 0x9146,
  kMedium = 0x9147,
  kLow = 0x9148,
  kBufferObjectExt = 0x9151,
  kVertexArrayObjectExt = 0x9154,
  kDebugOutput = 0x92E0,
};

using DebugProc = void(GL_APIENTRY*)(GLenum, GLenum, GLuint, GLenum, GLsizei, const char*, const void*);

struct Message {
  GLenum source, type;
  GLuint id;
  GLenum severity;
  std::string text;
};

// A debug context; its messages arrive in `heard`.
class DebugFixture : public GlTest {
 protected:
  // Loaded by SetUp.
  struct Commands {
    void(GL_APIENTRY* Control)(GLenum, GLenum, GLenum, GLsizei, const GLuint*, GLboolean);
    void(GL_APIENTRY* Insert)(GLenum, GLenum, GLuint, GLenum, GLsizei, const char*);
    void(GL_APIENTRY* Callback)(DebugProc, const void*);
    GLuint(GL_APIENTRY* GetLog)(GLuint, GLsizei, GLenum*, GLenum*, GLuint*, GLenum*, GLsizei*, char*);
    void(GL_APIENTRY* GetPointer)(GLenum, void**);
    void(GL_APIENTRY* Push)(GLenum, GLuint, GLsizei, const char*);
    void(GL_APIENTRY* Pop)();
    void(GL_APIENTRY* Label)(GLenum, GLuint, GLsizei, const char*);
    void(GL_APIENTRY* GetLabel)(GLenum, GLuint, GLsizei, GLsizei*, char*);
    void(GL_APIENTRY* PtrLabel)(const void*, GLsizei, const char*);
    void(GL_APIENTRY* GetPtrLabel)(const void*, GLsizei, GLsizei*, char*);
    void(GL_APIENTRY* LabelExt)(GLenum, GLuint, GLsizei, const char*);
    void(GL_APIENTRY* GetLabelExt)(GLenum, GLuint, GLsizei, GLsizei*, char*);
  };
  static inline Commands gl;

  void SetUp() override {
    GlTest::SetUp();
    context_ = std::make_unique<OtherContext>(std::vector<EGLint>{EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE});
    if (!context_->valid() && onMesa()) GTEST_SKIP() << "Mesa makes no such contexts of ES 1.1";
    ASSERT_TRUE(context_->valid());
    NEEDS_EXTENSION("GL_KHR_debug");
    NEEDS_EXTENSION("GL_EXT_debug_label");
    load(gl.Control, "glDebugMessageControlKHR");
    load(gl.Insert, "glDebugMessageInsertKHR");
    load(gl.Callback, "glDebugMessageCallbackKHR");
    load(gl.GetLog, "glGetDebugMessageLogKHR");
    load(gl.GetPointer, "glGetPointervKHR");
    load(gl.Push, "glPushDebugGroupKHR");
    load(gl.Pop, "glPopDebugGroupKHR");
    load(gl.Label, "glObjectLabelKHR");
    load(gl.GetLabel, "glGetObjectLabelKHR");
    load(gl.PtrLabel, "glObjectPtrLabelKHR");
    load(gl.GetPtrLabel, "glGetObjectPtrLabelKHR");
    load(gl.LabelExt, "glLabelObjectEXT");
    load(gl.GetLabelExt, "glGetObjectLabelEXT");
  }
  void TearDown() override {
    context_.reset();
    GlTest::TearDown();
  }

  static void GL_APIENTRY hear(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length,
                               const char* text, const void* self) {
    EXPECT_EQ(std::strlen(text), static_cast<std::size_t>(length));
    const_cast<DebugFixture*>(static_cast<const DebugFixture*>(self))
        ->heard.push_back({source, type, id, severity, text});
  }
  void listen() { gl.Callback(hear, this); }
  static GLint get(GLenum name) {
    GLint value = -1;
    glGetIntegerv(name, &value);
    return value;
  }
  // A marker of the application.
  static void insert(const char* text, GLuint id = 1, GLenum severity = kNotification) {
    gl.Insert(kSourceApplication, kTypeMarker, id, severity, -1, text);
  }
  std::vector<std::string> texts() {
    std::vector<std::string> out;
    for (const Message& message : heard) out.push_back(message.text);
    heard.clear();
    return out;
  }

  std::vector<Message> heard;

 private:
  std::unique_ptr<OtherContext> context_;
};

}  // namespace conformance
