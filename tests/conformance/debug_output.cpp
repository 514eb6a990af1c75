// KHR_debug: messages and what they say, the log, control, groups.
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <functional>

#include "debug_fixture.h"

namespace conformance {
namespace {

using DebugOutput = DebugFixture;

TEST_F(DebugOutput, InitialState) {
  EXPECT_EQ(glIsEnabled(kDebugOutput), GL_TRUE);
  EXPECT_EQ(glIsEnabled(kSynchronous), GL_FALSE);
  EXPECT_EQ(get(kLogged), 0);
  EXPECT_EQ(get(kNextLength), 0);
  EXPECT_EQ(get(kGroupDepth), 1);
  EXPECT_GE(get(kMaxGroupDepth), 64);
  EXPECT_GE(get(kMaxMessageLength), 1);
  EXPECT_GE(get(kMaxLogged), 1);
  EXPECT_GE(get(kMaxLabelLength), 256);
  void* pointer = this;
  gl.GetPointer(kCallbackFunction, &pointer);
  EXPECT_EQ(pointer, nullptr);
  listen();
  gl.GetPointer(kCallbackFunction, &pointer);
  EXPECT_EQ(pointer, reinterpret_cast<void*>(hear));
  glGetPointerv(kCallbackUserParam, &pointer);
  EXPECT_EQ(pointer, this);
  glEnable(kSynchronous);
  EXPECT_EQ(glIsEnabled(kSynchronous), GL_TRUE);
  EXPECT_EQ(get(kSynchronous), 1);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  const OtherContext plain({});
  EXPECT_EQ(glIsEnabled(kDebugOutput), GL_FALSE);
  const OtherContext flagged({EGL_CONTEXT_FLAGS_KHR, EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR});
  EXPECT_EQ(glIsEnabled(kDebugOutput), GL_TRUE);
}

// Every error says in which call it happened, what was wrong, and what to do.
TEST_F(DebugOutput, ErrorsSayWhatIsWrong) {
  MESA_DISAGREES("KHR_debug", "the text of a message is each implementation's own");
  listen();
  const struct {
    std::function<void()> call;
    GLenum error;
    std::vector<const char*> parts;
  } rows[] = {
      {[] { glLineWidth(-1); },
       GL_INVALID_VALUE,
       {"glLineWidth", "GL_INVALID_VALUE", "width is -1", "above 0"}},
      {[] { glPointSize(0); }, GL_INVALID_VALUE, {"glPointSize", "size is 0"}},
      {[] { glEnable(GL_RGBA); },
       GL_INVALID_ENUM,
       {"glEnable", "cap is GL_RGBA (0x1908)", "Use a capability"}},
      {[] { glEnableClientState(GL_RGBA); }, GL_INVALID_ENUM, {"glEnableClientState", "array is GL_RGBA"}},
      {[] { glFogf(GL_FOG_MODE, 5); }, GL_INVALID_ENUM, {"glFogf", "param is 0x0005", "EXP2"}},
      {[] { glFogx(GL_FOG_DENSITY, -65536); }, GL_INVALID_VALUE, {"glFogx", "param is -1"}},
      {[] { glLightf(GL_LIGHT0 + 9, GL_SPOT_CUTOFF, 1); }, GL_INVALID_ENUM, {"glLightf", "light is 0x4009"}},
      {[] { glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 91); }, GL_INVALID_VALUE, {"glLightf", "param is 91", "180"}},
      {[] { glLightf(GL_LIGHT0, GL_AMBIENT, 1); },
       GL_INVALID_ENUM,
       {"glLightf", "pname is GL_AMBIENT", "pointer"}},
      {[] { glMaterialf(GL_FRONT, GL_SHININESS, 1); }, GL_INVALID_ENUM, {"glMaterialf", "face is GL_FRONT"}},
      {[] { glShadeModel(7); }, GL_INVALID_ENUM, {"glShadeModel", "mode is 0x0007"}},
      {[] { glViewport(0, 0, 1, -4); }, GL_INVALID_VALUE, {"glViewport", "height is -4"}},
      {[] { glScissor(0, 0, -3, 1); }, GL_INVALID_VALUE, {"glScissor", "width is -3"}},
      {[] { glDepthFunc(1); }, GL_INVALID_ENUM, {"glDepthFunc", "func is 0x0001", "LEQUAL"}},
      {[] { glStencilOp(GL_KEEP, 3, GL_KEEP); }, GL_INVALID_ENUM, {"glStencilOp", "zfail is 0x0003"}},
      {[] { glBlendFunc(GL_ONE, GL_SRC_ALPHA_SATURATE); },
       GL_INVALID_ENUM,
       {"glBlendFunc", "dfactor is GL_SRC_ALPHA_SATURATE (0x0308)", "DST_ALPHA or ONE_MINUS_DST_ALPHA."}},
      {[] { glLogicOp(GL_ONE); }, GL_INVALID_ENUM, {"glLogicOp", "opcode is 0x0001", "NAND or SET"}},
      {[] { glClear(0x1200); }, GL_INVALID_VALUE, {"glClear", "mask is 0x1200"}},
      {[] { glCullFace(GL_ONE); }, GL_INVALID_ENUM, {"glCullFace", "mode is 0x0001"}},
      {[] { glHint(GL_FOG_HINT, 3); }, GL_INVALID_ENUM, {"glHint", "mode is 0x0003"}},
      {[] { glMatrixMode(GL_FOG); }, GL_INVALID_ENUM, {"glMatrixMode", "mode is GL_FOG"}},
      {[] { glPopMatrix(); },
       GL_STACK_UNDERFLOW,
       {"glPopMatrix", "GL_STACK_UNDERFLOW", "Nothing was pushed"}},
      {[] { glFrustumf(-1, 1, -1, 1, -2, 5); }, GL_INVALID_VALUE, {"glFrustumf", "near is -2"}},
      {[] { glOrthox(0, 0, 0, 1, 0, 1); }, GL_INVALID_VALUE, {"glOrthox", "planes are the same"}},
      {[] { glDrawArrays(GL_TRIANGLES, -2, 3); }, GL_INVALID_VALUE, {"glDrawArrays", "first is -2"}},
      {[] { glDrawArrays(7, 0, 3); }, GL_INVALID_ENUM, {"glDrawArrays", "mode is 0x0007"}},
      {[] { glDrawElements(GL_TRIANGLES, 3, GL_FLOAT, nullptr); },
       GL_INVALID_ENUM,
       {"glDrawElements", "type is GL_FLOAT", "UNSIGNED_SHORT"}},
      {[] { glVertexPointer(5, GL_FLOAT, 0, nullptr); }, GL_INVALID_VALUE, {"glVertexPointer", "size is 5"}},
      {[] { glColorPointer(4, GL_SHORT, 0, nullptr); },
       GL_INVALID_ENUM,
       {"glColorPointer", "type is GL_SHORT"}},
      {[] { glNormalPointer(GL_FLOAT, -8, nullptr); }, GL_INVALID_VALUE, {"glNormalPointer", "stride is -8"}},
      {[] { glBufferData(GL_ARRAY_BUFFER, 4, nullptr, GL_STATIC_DRAW); },
       GL_INVALID_OPERATION,
       {"glBufferData", "No buffer is bound", "glBindBuffer"}},
      {[] { glBindBuffer(GL_RGBA, 1); }, GL_INVALID_ENUM, {"glBindBuffer", "target is GL_RGBA"}},
      {[] { glGenBuffers(-1, nullptr); }, GL_INVALID_VALUE, {"glGenBuffers", "n is -1"}},
      {[] { glBindTexture(GL_RGBA, 1); }, GL_INVALID_ENUM, {"glBindTexture", "target is GL_RGBA"}},
      {[] { glActiveTexture(GL_TEXTURE0 + 64); },
       GL_INVALID_ENUM,
       {"glActiveTexture", "texture is GL_TEXTURE_FILTER_CONTROL_EXT"}},
      {[] { glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, 3); },
       GL_INVALID_ENUM,
       {"glTexParameteri", "param is 0x0003"}},
      {[] { glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 3); },
       GL_INVALID_VALUE,
       {"glTexEnvf", "param is 3", "1, 2 or 4"}},
      {[] { glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, 1); },
       GL_INVALID_ENUM,
       {"glTexEnvi", "param is 0x0001"}},
      {[] { glTexImage2D(GL_TEXTURE_2D, -1, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr); },
       GL_INVALID_VALUE,
       {"glTexImage2D", "level is -1"}},
      {[] { glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, nullptr); },
       GL_INVALID_VALUE,
       {"glTexImage2D", "border is 1", "Give 0"}},
      {[] { glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, nullptr); },
       GL_INVALID_OPERATION,
       {"glTexSubImage2D", "never specified"}},
      {[] { glReadPixels(0, 0, -1, 1, GL_RGBA, GL_UNSIGNED_BYTE, nullptr); },
       GL_INVALID_VALUE,
       {"glReadPixels", "width is -1"}},
      {[] { glPixelStorei(GL_PACK_ALIGNMENT, 3); },
       GL_INVALID_VALUE,
       {"glPixelStorei", "param is 3", "1, 2, 4 or 8"}},
      {[] { glCompressedTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, 64, nullptr); },
       GL_INVALID_ENUM,
       {"glCompressedTexImage2D", "internalformat is GL_RGBA"}},
      {[] { glCompressedTexImage2D(GL_TEXTURE_2D, 0, GL_PALETTE4_RGB8_OES, 4, 4, 0, 1, nullptr); },
       GL_INVALID_VALUE,
       {"glCompressedTexImage2D", "imageSize is 1", "bytes that the format needs"}},
      {[] { command<PFNGLTEXSTORAGE2DEXTPROC>("glTexStorage2DEXT")(GL_TEXTURE_2D, 0, GL_RGBA8_OES, 4, 4); },
       GL_INVALID_VALUE,
       {"glTexStorage2DEXT", "levels is 0"}},
      {[] { glGetString(5); }, GL_INVALID_ENUM, {"glGetString", "name is 0x0005"}},
      {[] { get(5); }, GL_INVALID_ENUM, {"glGetIntegerv", "pname is 0x0005"}},
      {[] { command<PFNGLBINDFRAMEBUFFEROESPROC>("glBindFramebufferOES")(GL_RGBA, 1); },
       GL_INVALID_ENUM,
       {"glBindFramebufferOES", "target is GL_RGBA"}},
      {[] {
         command<PFNGLRENDERBUFFERSTORAGEOESPROC>("glRenderbufferStorageOES")(GL_RENDERBUFFER_OES,
                                                                              GL_RGBA8_OES, 1, 1);
       },
       GL_INVALID_OPERATION,
       {"glRenderbufferStorageOES", "No renderbuffer is bound"}},
  };
  for (const auto& row : rows) {
    heard.clear();
    row.call();
    EXPECT_GL_ERROR(row.error) << row.parts[0];
    ASSERT_EQ(heard.size(), 1u) << row.parts[0];
    const Message& message = heard[0];
    EXPECT_EQ(message.source, GLenum{kSourceApi});
    EXPECT_EQ(message.type, GLenum{kTypeError});
    EXPECT_EQ(message.severity, GLenum{kHigh});
    EXPECT_EQ(message.id, row.error);
    EXPECT_EQ(message.text.find(row.parts[0]), 0u) << message.text;
    for (const char* part : row.parts) EXPECT_NE(message.text.find(part), std::string::npos) << message.text;
    EXPECT_EQ(message.text.back(), '.');
  }
}

// Errors after the first make messages, too, though glGetError tells of one alone.
TEST_F(DebugOutput, EveryErrorIsTold) {
  listen();
  glLineWidth(-1);
  glLineWidth(-2);
  glEnable(1);
  EXPECT_EQ(heard.size(), 3u);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  heard.clear();
  glDisable(kDebugOutput);
  glLineWidth(-1);
  EXPECT_TRUE(heard.empty());
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  glEnable(kDebugOutput);
  glLineWidth(-1);
  EXPECT_EQ(heard.size(), 1u);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
}

// A context without the flag is silent until it is asked.
TEST_F(DebugOutput, WithoutADebugContext) {
  MESA_DISAGREES("KHR_debug 5.5.5", "a wrong insertion is an error while output is off");
  const OtherContext plain({});
  listen();
  glLineWidth(-1);
  insert("unheard");
  EXPECT_TRUE(heard.empty());
  glEnable(kDebugOutput);
  glLineWidth(-1);
  EXPECT_EQ(heard.size(), 1u);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  // Nothing of it is an error while output is off.
  glDisable(kDebugOutput);
  gl.Insert(kSourceApi, kTypeError, 1, kHigh, -1, "discarded");
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

// A pipeline that a draw must wait for.
TEST_F(DebugOutput, SlowCommands) {
  MESA_DISAGREES("KHR_debug 5.5", "what is slow is the implementation's own to say");
  const char* renderer = std::getenv("ANTEROOM_RENDERER");
  if (renderer && std::string(renderer) == "reference") GTEST_SKIP() << "the reference compiles nothing";
  listen();
  glEnable(GL_FOG);
  glFogf(GL_FOG_MODE, GL_EXP2);
  glEnable(GL_ALPHA_TEST);
  glAlphaFunc(GL_NOTEQUAL, 0.3f);
  glEnable(GL_CLIP_PLANE3);
  glShadeModel(GL_FLAT);
  drawRect();
  ASSERT_EQ(heard.size(), 1u);
  EXPECT_EQ(heard[0].source, GLenum{kSourceApi});
  EXPECT_EQ(heard[0].type, GLenum{kTypePerformance});
  EXPECT_EQ(heard[0].severity, GLenum{kMedium});
  EXPECT_NE(heard[0].text.find("pipeline"), std::string::npos);
  drawRect();
  EXPECT_EQ(heard.size(), 1u) << "the second draw waits for nothing";
}

TEST_F(DebugOutput, Log) {
  insert("first", 11);
  gl.Insert(kSourceThirdParty, kTypeOther, 12, kMedium, 6, "second and more");
  EXPECT_EQ(get(kLogged), 2);
  EXPECT_EQ(get(kNextLength), 6);
  GLenum sources[4], types[4], severities[4];
  GLuint ids[4];
  GLsizei lengths[4];
  char text[64];
  gl.GetLog(1, -1, nullptr, nullptr, nullptr, nullptr, nullptr, text);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);  // which is the third message
  EXPECT_EQ(gl.GetLog(4, 6, sources, types, ids, severities, lengths, text), 1u) << "the second does not fit";
  EXPECT_EQ(std::string(text), "first");
  EXPECT_EQ(lengths[0], 6);
  EXPECT_EQ(ids[0], 11u);
  EXPECT_EQ(gl.GetLog(4, 5, sources, types, ids, severities, lengths, text), 0u);
  EXPECT_EQ(gl.GetLog(1, 64, sources, types, ids, severities, lengths, text), 1u);
  EXPECT_EQ(std::string(text), "second");
  EXPECT_EQ(sources[0], GLenum{kSourceThirdParty});
  EXPECT_EQ(types[0], GLenum{kTypeOther});
  EXPECT_EQ(severities[0], GLenum{kMedium});
  EXPECT_EQ(get(kLogged), 1);
  EXPECT_EQ(gl.GetLog(9, 0, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr), 1u);
  EXPECT_EQ(get(kLogged), 0);
  // Two strings after each other.
  insert("a");
  insert("bc");
  EXPECT_EQ(gl.GetLog(2, 5, nullptr, nullptr, nullptr, nullptr, nullptr, text), 2u);
  EXPECT_EQ(std::memcmp(text, "a\0bc\0", 5), 0);
  // A full log takes no more.
  const GLint most = get(kMaxLogged);
  for (GLint i = 0; i < most + 10; ++i) insert("again", static_cast<GLuint>(i));
  EXPECT_EQ(get(kLogged), most);
  EXPECT_EQ(gl.GetLog(1, 0, nullptr, nullptr, ids, nullptr, nullptr, nullptr), 1u);
  EXPECT_EQ(ids[0], 0u);
  // With a callback nothing is logged.
  listen();
  insert("heard");
  EXPECT_EQ(get(kLogged), most - 1);
  EXPECT_EQ(heard.size(), 1u);
  gl.Callback(nullptr, nullptr);
  insert("logged");
  EXPECT_EQ(get(kLogged), most);
  EXPECT_EQ(heard.size(), 1u);
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

// By source, type, severity and id; low severity is off at first; the last word counts.
TEST_F(DebugOutput, Control) {
  MESA_DISAGREES("KHR_debug 5.5", "the ids of messages about errors are each implementation's own");
  listen();
  const auto each = [&] {
    heard.clear();
    for (const GLenum source : {kSourceApplication, kSourceThirdParty})
      for (const GLenum type : {kTypeMarker, kTypeOther})
        for (const GLenum severity : {kNotification, kLow})
          for (const GLuint id : {1u, 2u}) gl.Insert(source, type, id, severity, -1, "x");
    return heard.size();
  };
  EXPECT_EQ(each(), 8u);
  gl.Control(GL_DONT_CARE, GL_DONT_CARE, kLow, 0, nullptr, GL_TRUE);
  EXPECT_EQ(each(), 16u);
  gl.Control(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_FALSE);
  EXPECT_EQ(each(), 0u);
  glLineWidth(-1);
  EXPECT_TRUE(heard.empty());
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  gl.Control(kSourceApplication, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_TRUE);
  EXPECT_EQ(each(), 8u);
  gl.Control(kSourceApplication, kTypeMarker, kLow, 0, nullptr, GL_FALSE);
  EXPECT_EQ(each(), 6u);
  const GLuint ids[] = {2, 77};
  gl.Control(kSourceApplication, kTypeOther, GL_DONT_CARE, 2, ids, GL_FALSE);
  EXPECT_EQ(each(), 4u);
  gl.Control(kSourceThirdParty, kTypeOther, GL_DONT_CARE, 2, ids, GL_TRUE);
  EXPECT_EQ(each(), 6u);
  gl.Control(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_TRUE);
  EXPECT_EQ(each(), 16u);
  const GLuint error = GL_INVALID_VALUE;
  gl.Control(kSourceApi, kTypeError, GL_DONT_CARE, 1, &error, GL_FALSE);
  heard.clear();
  glLineWidth(-1);
  EXPECT_TRUE(heard.empty());
  glEnable(1);
  EXPECT_EQ(heard.size(), 1u);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
}

TEST_F(DebugOutput, ControlAndInsertErrors) {
  const GLuint id = 1;
  gl.Control(1, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_TRUE);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  gl.Control(GL_DONT_CARE, 1, GL_DONT_CARE, 0, nullptr, GL_TRUE);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  gl.Control(GL_DONT_CARE, GL_DONT_CARE, 1, 0, nullptr, GL_TRUE);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  gl.Control(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, -1, nullptr, GL_TRUE);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  gl.Control(GL_DONT_CARE, kTypeError, GL_DONT_CARE, 1, &id, GL_TRUE);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  gl.Control(kSourceApi, GL_DONT_CARE, GL_DONT_CARE, 1, &id, GL_TRUE);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  gl.Control(kSourceApi, kTypeError, kHigh, 1, &id, GL_TRUE);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  gl.Insert(kSourceApi, kTypeOther, 1, kHigh, -1, "x");
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  gl.Insert(kSourceApplication, 1, 1, kHigh, -1, "x");
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  gl.Insert(kSourceApplication, kTypeOther, 1, 1, -1, "x");
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  const std::string longest(static_cast<std::size_t>(get(kMaxMessageLength)) - 1, 'x');
  const GLsizei length = static_cast<GLsizei>(longest.size());
  listen();
  gl.Insert(kSourceApplication, kTypeOther, 1, kHigh, length, longest.c_str());
  EXPECT_GL_ERROR(GL_NO_ERROR);
  EXPECT_EQ(heard[0].text, longest);
  gl.Insert(kSourceApplication, kTypeOther, 1, kHigh, length + 1, (longest + "y").c_str());
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  gl.Insert(kSourceApplication, kTypeOther, 1, kHigh, -1, (longest + "y").c_str());
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
}

// Groups make a message at each end, and control in one ends with it.
TEST_F(DebugOutput, Groups) {
  MESA_DISAGREES("KHR_debug 5.5.6", "the length of a group's message is ignored");
  listen();
  gl.Push(kSourceApplication, 5, -1, "outer");
  EXPECT_EQ(get(kGroupDepth), 2);
  gl.Control(kSourceApplication, kTypeMarker, GL_DONT_CARE, 0, nullptr, GL_FALSE);
  insert("unheard");
  gl.Push(kSourceThirdParty, 6, 5, "inner and more");
  insert("unheard: control is inherited");
  gl.Control(kSourceApplication, kTypeMarker, GL_DONT_CARE, 0, nullptr, GL_TRUE);
  insert("heard");
  gl.Pop();
  insert("unheard again");
  gl.Pop();
  insert("heard again");
  ASSERT_EQ(heard.size(), 6u);
  EXPECT_EQ(heard[0].type, GLenum{kTypePushGroup});
  EXPECT_EQ(heard[0].id, 5u);
  EXPECT_EQ(heard[0].severity, GLenum{kNotification});
  EXPECT_EQ(heard[1].source, GLenum{kSourceThirdParty});
  EXPECT_EQ(heard[3].type, GLenum{kTypePopGroup});
  EXPECT_EQ(heard[3].source, GLenum{kSourceThirdParty});
  EXPECT_EQ(heard[3].id, 6u);
  EXPECT_EQ(texts(), (std::vector<std::string>{"outer", "inner", "heard", "inner", "outer", "heard again"}));
  EXPECT_EQ(get(kGroupDepth), 1);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  gl.Pop();
  EXPECT_GL_ERROR(GL_STACK_UNDERFLOW);
  gl.Push(kSourceApi, 1, -1, "x");
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  gl.Push(kSourceApplication, 1, -1,
          std::string(static_cast<std::size_t>(get(kMaxMessageLength)), 'x').c_str());
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  const GLint most = get(kMaxGroupDepth);
  for (GLint depth = 1; depth < most; ++depth) gl.Push(kSourceApplication, 1, -1, "deeper");
  EXPECT_GL_ERROR(GL_NO_ERROR);
  gl.Push(kSourceApplication, 1, -1, "too deep");
  EXPECT_GL_ERROR(GL_STACK_OVERFLOW);
  EXPECT_EQ(get(kGroupDepth), most);
}

// Groups, marks and draws mixed, also left open when the context goes.
TEST_F(DebugOutput, GroupsAroundDraws) {
  COMMAND(PFNGLPUSHGROUPMARKEREXTPROC, PushGroupMarkerEXT);
  COMMAND(PFNGLPOPGROUPMARKEREXTPROC, PopGroupMarkerEXT);
  COMMAND(PFNGLINSERTEVENTMARKEREXTPROC, InsertEventMarkerEXT);
  PopGroupMarkerEXT();
  glClear(GL_COLOR_BUFFER_BIT);
  for (int i = 0; i < 3; ++i) {
    gl.Push(kSourceApplication, 1, -1, "frame");
    PushGroupMarkerEXT(0, "quad");
    glColor4f(0, 1, 0, 1);
    drawRect({-1, -1, 0, 1});
    InsertEventMarkerEXT(0, "in the middle");
    insert("and so");
    PopGroupMarkerEXT();
    glFlush();
    if (i < 2) gl.Pop();
    EXPECT_PIXEL(8, 8, {0, 1, 0, 1});
  }
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

}  // namespace
}  // namespace conformance
