// The commands of OpenGL ES 1.1, as the Khronos registry lists them: written down apart from the layer's own
// table.
#pragma once

namespace anteroom::gl::test {

inline constexpr char kCoreCommands[] =
    "glActiveTexture glAlphaFunc glAlphaFuncx glBindBuffer glBindTexture glBlendFunc glBufferData "
    "glBufferSubData glClear glClearColor glClearColorx glClearDepthf glClearDepthx glClearStencil "
    "glClientActiveTexture glClipPlanef glClipPlanex glColor4f glColor4ub glColor4x glColorMask "
    "glColorPointer glCompressedTexImage2D glCompressedTexSubImage2D glCopyTexImage2D "
    "glCopyTexSubImage2D glCullFace glDeleteBuffers glDeleteTextures glDepthFunc glDepthMask "
    "glDepthRangef glDepthRangex glDisable glDisableClientState glDrawArrays glDrawElements glEnable "
    "glEnableClientState glFinish glFlush glFogf glFogfv glFogx glFogxv glFrontFace glFrustumf "
    "glFrustumx glGenBuffers glGenTextures glGetBooleanv glGetBufferParameteriv glGetClipPlanef "
    "glGetClipPlanex glGetError glGetFixedv glGetFloatv glGetIntegerv glGetLightfv glGetLightxv "
    "glGetMaterialfv glGetMaterialxv glGetPointerv glGetString glGetTexEnvfv glGetTexEnviv "
    "glGetTexEnvxv glGetTexParameterfv glGetTexParameteriv glGetTexParameterxv glHint glIsBuffer "
    "glIsEnabled glIsTexture glLightModelf glLightModelfv glLightModelx glLightModelxv glLightf "
    "glLightfv glLightx glLightxv glLineWidth glLineWidthx glLoadIdentity glLoadMatrixf glLoadMatrixx "
    "glLogicOp glMaterialf glMaterialfv glMaterialx glMaterialxv glMatrixMode glMultMatrixf "
    "glMultMatrixx glMultiTexCoord4f glMultiTexCoord4x glNormal3f glNormal3x glNormalPointer glOrthof "
    "glOrthox glPixelStorei glPointParameterf glPointParameterfv glPointParameterx glPointParameterxv "
    "glPointSize glPointSizex glPolygonOffset glPolygonOffsetx glPopMatrix glPushMatrix glReadPixels "
    "glRotatef glRotatex glSampleCoverage glSampleCoveragex glScalef glScalex glScissor glShadeModel "
    "glStencilFunc glStencilMask glStencilOp glTexCoordPointer glTexEnvf glTexEnvfv glTexEnvi "
    "glTexEnviv glTexEnvx glTexEnvxv glTexImage2D glTexParameterf glTexParameterfv glTexParameteri "
    "glTexParameteriv glTexParameterx glTexParameterxv glTexSubImage2D glTranslatef glTranslatex "
    "glVertexPointer glViewport ";

}  // namespace anteroom::gl::test
