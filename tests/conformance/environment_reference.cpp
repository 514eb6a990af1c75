#include "environment_reference.h"

#include "ati.h"

namespace conformance {

namespace {

Vec4 source(const Inputs& in, GLenum name) {
  if (name == GL_ZERO) return {0, 0, 0, 0};
  if (name == GL_ONE) return {1, 1, 1, 1};
  return name == GL_TEXTURE         ? in.texture
         : name == GL_CONSTANT      ? in.constant
         : name == GL_PRIMARY_COLOR ? in.primary
                                    : in.previous;
}

// Tables 3.18, 3.19
Vec3 argument(const Inputs& in, GLenum name, GLenum operand) {
  const Vec4 c = source(in, name);
  switch (operand) {
    case GL_SRC_COLOR:
      return {c[0], c[1], c[2]};
    case GL_ONE_MINUS_SRC_COLOR:
      return {1 - c[0], 1 - c[1], 1 - c[2]};
    case GL_SRC_ALPHA:
      return {c[3], c[3], c[3]};
    default:
      return {1 - c[3], 1 - c[3], 1 - c[3]};
  }
}

double combined(GLenum function, double a, double b, double c) {
  switch (function) {
    case GL_REPLACE:
      return a;
    case GL_MODULATE:
      return a * b;
    case GL_ADD:
      return a + b;
    case GL_ADD_SIGNED:
      return a + b - 0.5;
    case GL_INTERPOLATE:
      return a * c + b * (1 - c);
    case GL_MODULATE_ADD_ATI:
      return a * c + b;
    case GL_MODULATE_SIGNED_ADD_ATI:
      return a * c + b - 0.5;
    case GL_MODULATE_SUBTRACT_ATI:
      return a * c - b;
    default:
      return a - b;
  }
}

}  // namespace

Vec4 sourceColor(GLenum format, const Texel& texel) {
  const double c[4] = {texel[0] / 255.0, texel[1] / 255.0, texel[2] / 255.0, texel[3] / 255.0};
  switch (format) {
    case GL_ALPHA:
      return {0, 0, 0, c[0]};
    case GL_LUMINANCE:
      return {c[0], c[0], c[0], 1};
    case GL_LUMINANCE_ALPHA:
      return {c[0], c[0], c[0], c[1]};
    case GL_RGB:
      return {c[0], c[1], c[2], 1};
    default:
      return {c[0], c[1], c[2], c[3]};
  }
}

Vec4 environment(GLenum mode, GLenum format, const Vec4& p, const Vec4& s, const Vec4& c) {
  const bool hasColor = format != GL_ALPHA, hasAlpha = format != GL_LUMINANCE && format != GL_RGB;
  Vec4 v = p;
  for (std::size_t i = 0; i < 3 && hasColor; ++i) {
    switch (mode) {
      case GL_REPLACE:
        v[i] = s[i];
        break;
      case GL_MODULATE:
        v[i] = p[i] * s[i];
        break;
      case GL_DECAL:
        v[i] = format == GL_RGB ? s[i] : p[i] * (1 - s[3]) + s[i] * s[3];
        break;
      case GL_BLEND:
        v[i] = p[i] * (1 - s[i]) + c[i] * s[i];
        break;
      case GL_ADD:
        v[i] = p[i] + s[i];
        break;
      default:
        ADD_FAILURE();
    }
  }
  if (hasAlpha && mode != GL_DECAL) v[3] = mode == GL_REPLACE ? s[3] : p[3] * s[3];
  return clamp01(v);
}

Vec4 combine(const Combiner& combiner, const Inputs& in) {
  Vec3 arguments[2][3];
  for (int half = 0; half < 2; ++half) {
    for (int i = 0; i < 3; ++i)
      arguments[half][i] = argument(in, combiner.source[half][i], combiner.operand[half][i]);
  }
  const auto& [rgb, alpha] = arguments;
  Vec4 v{};
  v[3] = combined(combiner.function[1], alpha[0][0], alpha[1][0], alpha[2][0]) * combiner.scale[1];
  if (combiner.function[0] == GL_DOT3_RGB || combiner.function[0] == GL_DOT3_RGBA) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += (rgb[0][i] - 0.5) * (rgb[1][i] - 0.5);
    v[0] = v[1] = v[2] = 4 * sum * combiner.scale[0];
    if (combiner.function[0] == GL_DOT3_RGBA) v[3] = 4 * sum * combiner.scale[1];
  } else {
    for (std::size_t i = 0; i < 3; ++i) {
      v[i] = combined(combiner.function[0], rgb[0][i], rgb[1][i], rgb[2][i]) * combiner.scale[0];
    }
  }
  return clamp01(v);
}

void setEnvironment(GLenum name, GLenum value) {
  glTexEnvi(GL_TEXTURE_ENV, name, static_cast<GLint>(value));
}

void apply(const Combiner& c) {
  setEnvironment(GL_TEXTURE_ENV_MODE, GL_COMBINE);
  setEnvironment(GL_COMBINE_RGB, c.function[0]);
  setEnvironment(GL_COMBINE_ALPHA, c.function[1]);
  for (GLenum i = 0; i < 3; ++i) {
    setEnvironment(GL_SRC0_RGB + i, c.source[0][i]);
    setEnvironment(GL_SRC0_ALPHA + i, c.source[1][i]);
    setEnvironment(GL_OPERAND0_RGB + i, c.operand[0][i]);
    setEnvironment(GL_OPERAND0_ALPHA + i, c.operand[1][i]);
  }
  glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, static_cast<GLfloat>(c.scale[0]));
  glTexEnvf(GL_TEXTURE_ENV, GL_ALPHA_SCALE, static_cast<GLfloat>(c.scale[1]));
}

}  // namespace conformance
