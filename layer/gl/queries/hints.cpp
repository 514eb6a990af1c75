// Section 5.2: hints. They are kept for queries; the layer always draws its best.
#include "layer/gl/queries/hints.h"

namespace anteroom::gl {

GLenum* hintOf(Context& c, GLenum target) {
  switch (target) {
    case GL_PERSPECTIVE_CORRECTION_HINT:
      return &c.hints.perspectiveCorrection;
    case GL_POINT_SMOOTH_HINT:
      return &c.hints.pointSmooth;
    case GL_LINE_SMOOTH_HINT:
      return &c.hints.lineSmooth;
    case GL_FOG_HINT:
      return &c.hints.fog;
    case GL_GENERATE_MIPMAP_HINT:
      return &c.hints.generateMipmap;
    default:
      return nullptr;
  }
}

}  // namespace anteroom::gl

using namespace anteroom::gl;

GL_API void GL_APIENTRY glHint(GLenum target, GLenum mode) {
  Context* c = current();
  if (!c) return;
  GLenum* hint = hintOf(*c, target);
  if (!hint)
    return c->setError(GL_INVALID_ENUM,
                       wrongEnum("target", target, "Use a name of table 5.1, such as FOG_HINT"));
  if (mode < GL_DONT_CARE || mode > GL_NICEST)
    return c->setError(GL_INVALID_ENUM, wrongEnum("mode", mode, "Use FASTEST, NICEST or DONT_CARE"));
  *hint = mode;
}
