// Ordinary fragment operations: chapter 4.
#include "canvas.h"
#include "scene.h"

namespace comparison {

namespace {

Mesh colored(double x0, double y0, double x1, double y1, double z, float alpha) {
  Mesh mesh = rectangle(x0, y0, x1, y1, z);
  for (std::size_t i = 0; i < 6; ++i) {
    const float x = mesh.positions[3 * i] * 0.5f + 0.5f, y = mesh.positions[3 * i + 1] * 0.5f + 0.5f;
    mesh.colors.insert(mesh.colors.end(), {x, 1 - y, y, alpha * (1 - 0.5f * x)});
  }
  return mesh;
}

void drawTwo() {
  colored(-1, -1, 0.4, 0.5, 0, 1).draw();
  colored(-0.5, -0.6, 1, 1, 0, 0.8f).draw();
}

void blendOver() {
  clear(0.3f, 0.4f, 0.5f, 0.6f);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  drawTwo();
}

// Two passes of colours that 8 bits hold exactly, without interpolation: only the blending rounds.
void blendExact() {
  clear(51 / 255.0f, 102 / 255.0f, 153 / 255.0f, 204 / 255.0f);
  texture(16, 16, noise);
  environment(GL_REPLACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  textured(0, 0, 1, 1).draw();
  textured(0.5, 0.25, 1.5, 1.25).draw();
}

void blendMany() {
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  for (int i = 0; i < 6; ++i) colored(-1, -1, 1, 1, 0, 0.3f + 0.1f * static_cast<float>(i)).draw();
}

void blendSubtract() {
  clear(0.7f, 0.8f, 0.9f, 1);
  glEnable(GL_BLEND);
  command<PFNGLBLENDEQUATIONOESPROC>("glBlendEquationOES")(GL_FUNC_REVERSE_SUBTRACT_OES);
  glBlendFunc(GL_ONE, GL_DST_ALPHA);
  drawTwo();
}

void blendSeparate() {
  clear(0.7f, 0.3f, 0.9f, 0.4f);
  glEnable(GL_BLEND);
  command<PFNGLBLENDFUNCSEPARATEOESPROC>("glBlendFuncSeparateOES")(GL_DST_COLOR, GL_ONE_MINUS_DST_ALPHA,
                                                                   GL_ZERO, GL_SRC_ALPHA);
  // One pass: these factors are as large as 2, and would double what the driver's 8 bits lose in a pass
  // before.
  colored(-0.5, -0.6, 1, 1, 0, 0.8f).draw();
}

void stencil() {
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_ALWAYS, 1, 0xff);
  glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
  drawTwo();
  glStencilFunc(GL_EQUAL, 2, 0xff);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  glColor4f(1, 1, 1, 1);
  rectangle(-1, -1, 1, 1).draw();
}

void alphaTest() {
  glEnable(GL_ALPHA_TEST);
  glAlphaFunc(GL_GREATER, 0.75f);
  colored(-1, -1, 1, 1, 0, 1).draw();
}

void logicOp() {
  clear(0.8f, 0.2f, 0.6f, 0.4f);
  glEnable(GL_COLOR_LOGIC_OP);
  glLogicOp(GL_XOR);
  // A step's difference in a colour is 255 in its bits: both are whole steps.
  glColor4f(85 / 255.0f, 170 / 255.0f, 15 / 255.0f, 1);
  rectangle(-0.7, -0.7, 0.2, 0.3).draw();
  glColor4f(240 / 255.0f, 51 / 255.0f, 204 / 255.0f, 60 / 255.0f);
  rectangle(-0.4, -0.3, 0.8, 0.9).draw();
}

void colorMask() {
  clear(0.7f, 0.3f, 0.9f, 0.4f);
  glColorMask(1, 0, 1, 0);
  drawTwo();
}

void scissor() {
  glEnable(GL_SCISSOR_TEST);
  glScissor(11, 7, 33, 41);
  drawTwo();
}

void depthIntersection() {
  glEnable(GL_DEPTH_TEST);
  perspective();
  glTranslatef(0, 0, -2.6f);
  for (int i = 0; i < 3; ++i) {
    glRotatef(50, 1, 0.7f, 0.2f);
    colored(-1, -1, 1, 1, 0, 1).draw();
  }
}

void polygonOffset() {
  glEnable(GL_DEPTH_TEST);
  perspective();
  glTranslatef(0, 0, -2.6f);
  glRotatef(50, 1, 0.7f, 0.2f);
  colored(-1, -1, 1, 1, 0, 1).draw();
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(-1, -2);
  glColor4f(1, 1, 1, 1);
  rectangle(-0.5, -0.5, 0.5, 0.5).draw();
  glPolygonOffset(1, 2);
  glColor4f(1, 0, 0, 1);
  rectangle(-0.9, -0.9, -0.6, 0.9).draw();
}

// Opaque triangles only: how a driver places its samples shows at edges alone.
void multisample() {
  glColor4f(1, 0.8f, 0.2f, 1);
  glRotatef(20, 0, 0, 1);
  rectangle(-0.7, -0.6, 0.6, 0.7).draw();
}

void lowColors() {
  glDisable(GL_DITHER);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  drawTwo();
}

}  // namespace

void addFragmentScenes(Scenes& scenes) {
  scenes.insert(scenes.end(),
                {
                    {"blend/over", "4.1.7", blendOver, {}, 2, Driver::kBlend},
                    {"blend/exact colors", "4.1.7", blendExact, {}, 2, Driver::kBlend},
                    {"blend/six passes", "4.1.7", blendMany, {}, 6, Driver::kBlend},
                    {"blend/reverse subtract", "OES_blend_subtract", blendSubtract, {}, 2, Driver::kBlend},
                    {"blend/separate", "OES_blend_func_separate", blendSeparate, {}, 2, Driver::kBlend},
                    {"fragment/stencil", "4.1.5", stencil},
                    {"fragment/alpha test", "4.1.4", alphaTest},
                    {"fragment/logic op", "4.1.9", logicOp},
                    {"fragment/color mask", "4.2.2", colorMask},
                    {"fragment/scissor", "4.1.2", scissor},
                    {"fragment/depth", "4.1.6", depthIntersection, {96, 96}},
                    {"fragment/polygon offset", "3.5.2", polygonOffset, {96, 96}},
                    {"fragment/multisample", "3.2.1", multisample, {64, 64, 4}},
                    {"fragment/565", "4.1.8", lowColors, {64, 64, 0, true}},
                });
}

}  // namespace comparison
