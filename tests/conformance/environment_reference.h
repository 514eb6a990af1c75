// The texture functions of section 3.7.12 in float64, from tables 3.14-3.19 and ATI_texture_env_combine3.
#pragma once

#include "harness.h"

namespace conformance {

using Texel = std::array<std::uint8_t, 4>;

// Table 3.14 for a texel given in the components of its base format.
Vec4 sourceColor(GLenum format, const Texel& texel);
// Tables 3.15 and 3.16: p is the colour of the previous unit, s the source colour, c the environment colour.
Vec4 environment(GLenum mode, GLenum format, const Vec4& p, const Vec4& s, const Vec4& c);

// The combiner of one unit.
struct Combiner {
  GLenum function[2] = {GL_MODULATE, GL_MODULATE};  // RGB, alpha
  GLenum source[2][3] = {{GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT}, {GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT}};
  GLenum operand[2][3] = {{GL_SRC_COLOR, GL_SRC_COLOR, GL_SRC_ALPHA},
                          {GL_SRC_ALPHA, GL_SRC_ALPHA, GL_SRC_ALPHA}};
  double scale[2] = {1, 1};
};

struct Inputs {
  Vec4 texture, constant, primary, previous;
};

// Table 3.17 with the arguments of 3.18 and 3.19, the scales and the clamp.
Vec4 combine(const Combiner& combiner, const Inputs& in);

// Set the same for the active unit.
void setEnvironment(GLenum name, GLenum value);
void apply(const Combiner& combiner);

}  // namespace conformance
