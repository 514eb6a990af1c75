// Sections 3.3 to 3.5: points, lines, polygons.
#include "layer/gl/context/forms.h"

using namespace anteroom::gl;
namespace gen = anteroom::gen;

namespace {

constexpr const char* kPointNames =
    "Use POINT_SIZE_MIN, POINT_SIZE_MAX, POINT_FADE_THRESHOLD_SIZE or POINT_DISTANCE_ATTENUATION";

void setPointParameter(GLenum pname, const Params& params, const char* command = __builtin_FUNCTION()) {
  Context* c = current();
  if (!c) return;
  if (pname < GL_POINT_SIZE_MIN || pname > GL_POINT_DISTANCE_ATTENUATION)
    return c->setError(GL_INVALID_ENUM, wrongEnum("pname", pname, kPointNames), command);
  if (params.null()) return;
  gen::Points& points = c->state.fixed.points;
  if (pname == GL_POINT_DISTANCE_ATTENUATION) {
    if (!params.vector())
      return c->setError(GL_INVALID_ENUM,
                         wrongEnum("pname", pname, "It has three values: use a command that takes a pointer"),
                         command);
    return c->set(points.distanceAttenuation, params.vec3(), gen::kGroupPoints);
  }
  if (!(params.number() >= 0))
    return c->setError(GL_INVALID_VALUE, wrongNumber("param", params.number(), "Give a size from 0 on"),
                       command);
  float& field = pname == GL_POINT_SIZE_MIN   ? points.sizeMin
                 : pname == GL_POINT_SIZE_MAX ? points.sizeMax
                                              : points.fadeThreshold;
  c->set(field, params.number(), gen::kGroupPoints);
}

}  // namespace

GL_API void GL_APIENTRY glPointSize(GLfloat size) {
  Context* c = current();
  if (!c) return;
  if (!(size > 0)) return c->setError(GL_INVALID_VALUE, wrongNumber("size", size, "Give a size above 0"));
  c->set(c->state.fixed.points.size, size, gen::kGroupPoints);
}
GL_API void GL_APIENTRY glPointSizex(GLfixed size) {
  glPointSize(fromFixed(size));
}

ANTEROOM_SETTERS(glPointParameter, , (GLenum pname), setPointParameter(pname, params))

GL_API void GL_APIENTRY glLineWidth(GLfloat width) {
  Context* c = current();
  if (!c) return;
  if (!(width > 0)) return c->setError(GL_INVALID_VALUE, wrongNumber("width", width, "Give a width above 0"));
  c->set(c->state.raster.lineWidth, width, gen::kGroupRaster);
}
GL_API void GL_APIENTRY glLineWidthx(GLfixed width) {
  glLineWidth(fromFixed(width));
}

GL_API void GL_APIENTRY glCullFace(GLenum mode) {
  Context* c = current();
  if (!c) return;
  if (mode != GL_FRONT && mode != GL_BACK && mode != GL_FRONT_AND_BACK)
    return c->setError(GL_INVALID_ENUM, wrongEnum("mode", mode, "Use FRONT, BACK or FRONT_AND_BACK"));
  c->set(c->state.raster.cullFaceMode, mode, gen::kGroupRaster);
}

GL_API void GL_APIENTRY glFrontFace(GLenum mode) {
  Context* c = current();
  if (!c) return;
  if (mode != GL_CW && mode != GL_CCW)
    return c->setError(GL_INVALID_ENUM, wrongEnum("mode", mode, "Use CW or CCW"));
  c->set(c->state.raster.frontFace, mode, gen::kGroupRaster);
}

GL_API void GL_APIENTRY glPolygonOffsetClampEXT(GLfloat factor, GLfloat units, GLfloat clamp) {
  Context* c = current();
  if (!c) return;
  c->set(c->state.raster.polygonOffsetFactor, factor, gen::kGroupRaster);
  c->set(c->state.raster.polygonOffsetUnits, units, gen::kGroupRaster);
  c->set(c->state.raster.polygonOffsetClamp, clamp, gen::kGroupRaster);
}
GL_API void GL_APIENTRY glPolygonOffset(GLfloat factor, GLfloat units) {
  glPolygonOffsetClampEXT(factor, units, 0);
}
GL_API void GL_APIENTRY glPolygonOffsetx(GLfixed factor, GLfixed units) {
  glPolygonOffset(fromFixed(factor), fromFixed(units));
}
