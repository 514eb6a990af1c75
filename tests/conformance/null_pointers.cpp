// Section 2.5: an enumerant that is not accepted is INVALID_ENUM, whatever the pointer beside it. Every command
// that takes both.
#include "extension_commands.h"
#include "rejections.h"

namespace conformance {
namespace {

class NullPointers : public RejectionTest {
 protected:
  void SetUp() override {
    RejectionTest::SetUp();
    MESA_DISAGREES("2.5", "fixed-point commands read through the pointer first");
  }
};

// What <GLES/glext.h> lacks.
using PointSizePointerProc = void(GL_APIENTRY*)(GLenum, GLsizei, const void*);
using ObjectLabelProc = void(GL_APIENTRY*)(GLenum, GLuint, GLsizei, const char*);
using GetObjectLabelProc = void(GL_APIENTRY*)(GLenum, GLuint, GLsizei, GLsizei*, char*);
using MessageControlProc = void(GL_APIENTRY*)(GLenum, GLenum, GLenum, GLsizei, const GLuint*, GLboolean);
using PushGroupProc = void(GL_APIENTRY*)(GLenum, GLuint, GLsizei, const char*);

#define NULLED(call) REJECT("2.5", call, GL_INVALID_ENUM)

TEST_F(NullPointers, Setters) {
  reject({
      NULLED(glFogfv(kNoEnum, nullptr)),
      NULLED(glFogxv(kNoEnum, nullptr)),
      NULLED(glLightfv(kNoEnum, GL_AMBIENT, nullptr)),
      NULLED(glLightfv(GL_LIGHT0, kNoEnum, nullptr)),
      NULLED(glLightxv(kNoEnum, GL_AMBIENT, nullptr)),
      NULLED(glLightxv(GL_LIGHT0, kNoEnum, nullptr)),
      NULLED(glLightModelfv(kNoEnum, nullptr)),
      NULLED(glLightModelxv(kNoEnum, nullptr)),
      NULLED(glMaterialfv(GL_FRONT, GL_AMBIENT, nullptr)),
      NULLED(glMaterialfv(GL_FRONT_AND_BACK, kNoEnum, nullptr)),
      NULLED(glMaterialxv(GL_FRONT, GL_AMBIENT, nullptr)),
      NULLED(glMaterialxv(GL_FRONT_AND_BACK, kNoEnum, nullptr)),
      NULLED(glPointParameterfv(kNoEnum, nullptr)),
      NULLED(glPointParameterxv(kNoEnum, nullptr)),
      NULLED(glClipPlanef(kNoEnum, nullptr)),
      NULLED(glClipPlanex(kNoEnum, nullptr)),
      NULLED(glTexEnvfv(kNoEnum, GL_TEXTURE_ENV_MODE, nullptr)),
      NULLED(glTexEnvfv(GL_TEXTURE_ENV, kNoEnum, nullptr)),
      NULLED(glTexEnviv(GL_TEXTURE_ENV, kNoEnum, nullptr)),
      NULLED(glTexEnvxv(GL_TEXTURE_ENV, kNoEnum, nullptr)),
      NULLED(glTexEnviv(GL_POINT_SPRITE_OES, GL_TEXTURE_ENV_MODE, nullptr)),
      NULLED(glTexEnviv(GL_TEXTURE_FILTER_CONTROL_EXT, GL_TEXTURE_ENV_MODE, nullptr)),
      NULLED(glTexParameterfv(kNoEnum, GL_TEXTURE_MIN_FILTER, nullptr)),
      NULLED(glTexParameterfv(GL_TEXTURE_2D, kNoEnum, nullptr)),
      NULLED(glTexParameteriv(GL_TEXTURE_2D, kNoEnum, nullptr)),
      NULLED(glTexParameterxv(GL_TEXTURE_2D, kNoEnum, nullptr)),
      NULLED(glTexParameteriv(GL_TEXTURE_2D, GL_REQUIRED_TEXTURE_IMAGE_UNITS_OES, nullptr)),
  });
}

TEST_F(NullPointers, Queries) {
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  reject({
      NULLED(glGetBooleanv(kNoEnum, nullptr)),
      NULLED(glGetIntegerv(kNoEnum, nullptr)),
      NULLED(glGetFloatv(kNoEnum, nullptr)),
      NULLED(glGetFixedv(kNoEnum, nullptr)),
      NULLED(glGetPointerv(kNoEnum, nullptr)),
      NULLED(glGetClipPlanef(kNoEnum, nullptr)),
      NULLED(glGetClipPlanex(kNoEnum, nullptr)),
      NULLED(glGetLightfv(kNoEnum, GL_AMBIENT, nullptr)),
      NULLED(glGetLightfv(GL_LIGHT0, kNoEnum, nullptr)),
      NULLED(glGetLightxv(GL_LIGHT0, kNoEnum, nullptr)),
      NULLED(glGetMaterialfv(kNoEnum, GL_AMBIENT, nullptr)),
      NULLED(glGetMaterialfv(GL_FRONT, kNoEnum, nullptr)),
      NULLED(glGetMaterialxv(GL_FRONT, kNoEnum, nullptr)),
      NULLED(glGetTexEnvfv(kNoEnum, GL_TEXTURE_ENV_MODE, nullptr)),
      NULLED(glGetTexEnvfv(GL_TEXTURE_ENV, kNoEnum, nullptr)),
      NULLED(glGetTexEnviv(GL_TEXTURE_ENV, kNoEnum, nullptr)),
      NULLED(glGetTexEnvxv(GL_TEXTURE_ENV, kNoEnum, nullptr)),
      NULLED(glGetTexEnviv(GL_POINT_SPRITE_OES, GL_TEXTURE_ENV_MODE, nullptr)),
      NULLED(glGetTexParameterfv(kNoEnum, GL_TEXTURE_MIN_FILTER, nullptr)),
      NULLED(glGetTexParameterfv(GL_TEXTURE_2D, kNoEnum, nullptr)),
      NULLED(glGetTexParameteriv(GL_TEXTURE_2D, kNoEnum, nullptr)),
      NULLED(glGetTexParameterxv(GL_TEXTURE_2D, kNoEnum, nullptr)),
      NULLED(glGetBufferParameteriv(kNoEnum, GL_BUFFER_SIZE, nullptr)),
      NULLED(glGetBufferParameteriv(GL_ARRAY_BUFFER, kNoEnum, nullptr)),
  });
  glDeleteBuffers(1, &buffer);
}

TEST_F(NullPointers, ArraysAndImages) {
  reject({
      NULLED(glVertexPointer(2, kNoEnum, 0, nullptr)),
      NULLED(glNormalPointer(kNoEnum, 0, nullptr)),
      NULLED(glColorPointer(4, kNoEnum, 0, nullptr)),
      NULLED(glTexCoordPointer(2, kNoEnum, 0, nullptr)),
      NULLED(glDrawElements(kNoEnum, 3, GL_UNSIGNED_BYTE, nullptr)),
      NULLED(glDrawElements(GL_TRIANGLES, 3, kNoEnum, nullptr)),
      NULLED(glBufferData(kNoEnum, 4, nullptr, GL_STATIC_DRAW)),
      NULLED(glBufferSubData(kNoEnum, 0, 4, nullptr)),
      NULLED(glTexImage2D(kNoEnum, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr)),
      NULLED(glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, kNoEnum, nullptr)),
      NULLED(glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, kNoEnum, GL_UNSIGNED_BYTE, nullptr)),
      NULLED(glTexSubImage2D(kNoEnum, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, nullptr)),
      NULLED(glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, kNoEnum, nullptr)),
      NULLED(glCompressedTexImage2D(kNoEnum, 0, GL_PALETTE4_RGB8_OES, 1, 1, 0, 49, nullptr)),
      NULLED(glCompressedTexImage2D(GL_TEXTURE_2D, 0, kNoEnum, 1, 1, 0, 49, nullptr)),
      NULLED(glCompressedTexSubImage2D(kNoEnum, 0, 0, 0, 1, 1, GL_ETC1_RGB8_OES, 8, nullptr)),
      REJECT("4.3.1", glReadPixels(0, 0, 1, 1, kNoEnum, GL_UNSIGNED_BYTE, nullptr), GL_INVALID_ENUM,
             GL_INVALID_OPERATION),
  });
}

TEST_F(NullPointers, Extensions) {
  COMMAND(PFNGLGETINTEGER64VAPPLEPROC, GetInteger64vAPPLE);
  COMMAND(PFNGLGETBUFFERPOINTERVOESPROC, GetBufferPointervOES);
  COMMAND(PFNGLTEXGENFVOESPROC, TexGenfvOES);
  COMMAND(PFNGLTEXGENIVOESPROC, TexGenivOES);
  COMMAND(PFNGLTEXGENXVOESPROC, TexGenxvOES);
  COMMAND(PFNGLGETTEXGENFVOESPROC, GetTexGenfvOES);
  COMMAND(PFNGLGETTEXGENIVOESPROC, GetTexGenivOES);
  COMMAND(PFNGLGETTEXGENXVOESPROC, GetTexGenxvOES);
  COMMAND(PFNGLMULTIDRAWARRAYSEXTPROC, MultiDrawArraysEXT);
  COMMAND(PFNGLMULTIDRAWELEMENTSEXTPROC, MultiDrawElementsEXT);
  COMMAND(PFNGLMATRIXINDEXPOINTEROESPROC, MatrixIndexPointerOES);
  COMMAND(PFNGLWEIGHTPOINTEROESPROC, WeightPointerOES);
  COMMAND(PointSizePointerProc, PointSizePointerOES);
  COMMAND(PFNGLDISCARDFRAMEBUFFEREXTPROC, DiscardFramebufferEXT);
  COMMAND(ObjectLabelProc, ObjectLabelKHR);
  COMMAND(GetObjectLabelProc, GetObjectLabelKHR);
  COMMAND(MessageControlProc, DebugMessageControlKHR);
  COMMAND(PushGroupProc, PushDebugGroupKHR);
  reject({
      NULLED(GetInteger64vAPPLE(kNoEnum, nullptr)),
      NULLED(GetBufferPointervOES(GL_ARRAY_BUFFER, kNoEnum, nullptr)),
      NULLED(GetBufferPointervOES(kNoEnum, GL_BUFFER_MAP_POINTER_OES, nullptr)),
      NULLED(TexGenfvOES(kNoEnum, GL_TEXTURE_GEN_MODE_OES, nullptr)),
      NULLED(TexGenivOES(GL_TEXTURE_GEN_STR_OES, kNoEnum, nullptr)),
      NULLED(TexGenxvOES(GL_TEXTURE_GEN_STR_OES, kNoEnum, nullptr)),
      NULLED(GetTexGenfvOES(kNoEnum, GL_TEXTURE_GEN_MODE_OES, nullptr)),
      NULLED(GetTexGenivOES(GL_TEXTURE_GEN_STR_OES, kNoEnum, nullptr)),
      NULLED(GetTexGenxvOES(GL_TEXTURE_GEN_STR_OES, kNoEnum, nullptr)),
      NULLED(MultiDrawArraysEXT(kNoEnum, nullptr, nullptr, 1)),
      NULLED(MultiDrawElementsEXT(kNoEnum, nullptr, GL_UNSIGNED_BYTE, nullptr, 1)),
      NULLED(MultiDrawElementsEXT(GL_TRIANGLES, nullptr, kNoEnum, nullptr, 1)),
      NULLED(MatrixIndexPointerOES(1, kNoEnum, 0, nullptr)),
      NULLED(WeightPointerOES(1, kNoEnum, 0, nullptr)),
      NULLED(PointSizePointerOES(kNoEnum, 0, nullptr)),
      NULLED(DiscardFramebufferEXT(kNoEnum, 1, nullptr)),
      NULLED(ObjectLabelKHR(kNoEnum, 1, 0, nullptr)),
      NULLED(GetObjectLabelKHR(kNoEnum, 1, 0, nullptr, nullptr)),
      NULLED(DebugMessageControlKHR(kNoEnum, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_TRUE)),
      NULLED(PushDebugGroupKHR(kNoEnum, 0, 0, nullptr)),
  });
}

// Those whose objects must be there first.
TEST_F(NullPointers, QueriesOfObjects) {
  COMMAND(PFNGLGENFRAMEBUFFERSOESPROC, GenFramebuffersOES);
  COMMAND(PFNGLBINDFRAMEBUFFEROESPROC, BindFramebufferOES);
  COMMAND(PFNGLDELETEFRAMEBUFFERSOESPROC, DeleteFramebuffersOES);
  COMMAND(PFNGLGETFRAMEBUFFERATTACHMENTPARAMETERIVOESPROC, GetFramebufferAttachmentParameterivOES);
  COMMAND(PFNGLBINDRENDERBUFFEROESPROC, BindRenderbufferOES);
  COMMAND(PFNGLDELETERENDERBUFFERSOESPROC, DeleteRenderbuffersOES);
  COMMAND(PFNGLGETRENDERBUFFERPARAMETERIVOESPROC, GetRenderbufferParameterivOES);
  COMMAND(PFNGLSETFENCENVPROC, SetFenceNV);
  COMMAND(PFNGLGETFENCEIVNVPROC, GetFenceivNV);
  COMMAND(PFNGLDELETEFENCESNVPROC, DeleteFencesNV);
  COMMAND(PFNGLFENCESYNCAPPLEPROC, FenceSyncAPPLE);
  COMMAND(PFNGLGETSYNCIVAPPLEPROC, GetSyncivAPPLE);
  COMMAND(PFNGLDELETESYNCAPPLEPROC, DeleteSyncAPPLE);
  GLuint framebuffer = 0;
  GenFramebuffersOES(1, &framebuffer);
  BindFramebufferOES(GL_FRAMEBUFFER_OES, framebuffer);
  const GLuint renderbuffer = 1, fence = 1;
  BindRenderbufferOES(GL_RENDERBUFFER_OES, renderbuffer);
  SetFenceNV(fence, GL_ALL_COMPLETED_NV);
  const GLsync sync = FenceSyncAPPLE(GL_SYNC_GPU_COMMANDS_COMPLETE_APPLE, 0);
  reject({
      NULLED(GetFramebufferAttachmentParameterivOES(kNoEnum, GL_COLOR_ATTACHMENT0_OES,
                                                    GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE_OES, nullptr)),
      NULLED(GetFramebufferAttachmentParameterivOES(GL_FRAMEBUFFER_OES, kNoEnum,
                                                    GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE_OES, nullptr)),
      NULLED(GetFramebufferAttachmentParameterivOES(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, kNoEnum,
                                                    nullptr)),
      NULLED(GetRenderbufferParameterivOES(kNoEnum, GL_RENDERBUFFER_WIDTH_OES, nullptr)),
      NULLED(GetRenderbufferParameterivOES(GL_RENDERBUFFER_OES, kNoEnum, nullptr)),
      NULLED(GetFenceivNV(fence, kNoEnum, nullptr)),
      NULLED(GetSyncivAPPLE(sync, kNoEnum, 0, nullptr, nullptr)),
  });
  DeleteSyncAPPLE(sync);
  DeleteFencesNV(1, &fence);
  DeleteRenderbuffersOES(1, &renderbuffer);
  DeleteFramebuffersOES(1, &framebuffer);
  EXPECT_GL_ERROR(GL_NO_ERROR);
}

// NULL beside right enumerants: nothing is read, written or set.
TEST_F(NullPointers, NothingToReadOrWrite) {
  const GLfloat density = 0.5f;
  glFogfv(GL_FOG_DENSITY, &density);
  glFogfv(GL_FOG_DENSITY, nullptr);
  glLightfv(GL_LIGHT0, GL_POSITION, nullptr);
  glMaterialxv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, nullptr);
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, nullptr);
  glPointParameterfv(GL_POINT_SIZE_MIN, nullptr);
  glClipPlanef(GL_CLIP_PLANE0, nullptr);
  glClipPlanex(GL_CLIP_PLANE0, nullptr);
  glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, nullptr);
  glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, nullptr);
  glGetClipPlanef(GL_CLIP_PLANE0, nullptr);
  glGetIntegerv(GL_VIEWPORT, nullptr);
  glGetFloatv(GL_MODELVIEW_MATRIX, nullptr);
  glGetBooleanv(GL_FOG, nullptr);
  glGetFixedv(GL_FOG_HINT, nullptr);
  glGetPointerv(GL_VERTEX_ARRAY_POINTER, nullptr);
  glGetLightfv(GL_LIGHT0, GL_POSITION, nullptr);
  glGetMaterialfv(GL_FRONT, GL_AMBIENT, nullptr);
  glGetTexEnviv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, nullptr);
  glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, nullptr);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  GLfloat kept = 0;
  glGetFloatv(GL_FOG_DENSITY, &kept);
  EXPECT_EQ(kept, density);
}

}  // namespace
}  // namespace conformance
