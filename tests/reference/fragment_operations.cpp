#include "tests/reference/fragment_operations.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "tests/reference/texture_environment.h"
#include "tests/reference/texture_sampling.h"

namespace anteroom::reference {

namespace {

template <typename T>
bool compare(GLenum func, const T& a, const T& b) {
  switch (func) {
    case GL_NEVER:
      return false;
    case GL_LESS:
      return a < b;
    case GL_LEQUAL:
      return a <= b;
    case GL_EQUAL:
      return a == b;
    case GL_GEQUAL:
      return a >= b;
    case GL_GREATER:
      return a > b;
    case GL_NOTEQUAL:
      return a != b;
    default:
      return true;
  }
}

// Section 3.8. Where start and end meet, the ramp is a step.
double fogFactor(const gen::Fog& fog, double distance) {
  double f = 1;
  switch (fog.mode) {
    case GL_EXP:
      f = std::exp(-double(fog.density) * distance);
      break;
    case GL_EXP2: {
      const double x = double(fog.density) * distance;
      f = std::exp(-x * x);
      break;
    }
    default:
      if (fog.end == fog.start)
        f = distance <= double(fog.end) ? 1 : 0;
      else
        f = (double(fog.end) - distance) / (double(fog.end) - double(fog.start));
  }
  return f > 0 ? std::min(f, 1.0) : 0.0;
}

int stencilOperation(GLenum op, int value, int reference, int largest) {
  switch (op) {
    case GL_ZERO:
      return 0;
    case GL_REPLACE:
      return reference;
    case GL_INCR:
      return std::min(value + 1, largest);
    case GL_DECR:
      return std::max(value - 1, 0);
    case GL_INCR_WRAP_OES:
      return (value + 1) & largest;
    case GL_DECR_WRAP_OES:
      return (value - 1) & largest;
    case GL_INVERT:
      return ~value & largest;
    default:
      return value;
  }
}

// Tables 4.1 and 4.2.
glm::dvec4 blendFactor(GLenum factor, const glm::dvec4& s, const glm::dvec4& d) {
  switch (factor) {
    case GL_ZERO:
      return glm::dvec4(0);
    case GL_ONE:
      return glm::dvec4(1);
    case GL_SRC_COLOR:
      return s;
    case GL_ONE_MINUS_SRC_COLOR:
      return 1.0 - s;
    case GL_DST_COLOR:
      return d;
    case GL_ONE_MINUS_DST_COLOR:
      return 1.0 - d;
    case GL_SRC_ALPHA:
      return glm::dvec4(s.a);
    case GL_ONE_MINUS_SRC_ALPHA:
      return glm::dvec4(1 - s.a);
    case GL_DST_ALPHA:
      return glm::dvec4(d.a);
    case GL_ONE_MINUS_DST_ALPHA:
      return glm::dvec4(1 - d.a);
    default:
      return {glm::dvec3(std::min(s.a, 1 - d.a)), 1};  // GL_SRC_ALPHA_SATURATE
  }
}

// Of the colors and their products with the factors.
glm::dvec4 blendEquation(GLenum equation, const glm::dvec4& s, const glm::dvec4& scaledS, const glm::dvec4& d,
                         const glm::dvec4& scaledD) {
  switch (equation) {
    case GL_FUNC_SUBTRACT_OES:
      return scaledS - scaledD;
    case GL_FUNC_REVERSE_SUBTRACT_OES:
      return scaledD - scaledS;
    case GL_MIN_EXT:
      return glm::min(s, d);
    case GL_MAX_EXT:
      return glm::max(s, d);
    default:
      return scaledS + scaledD;
  }
}

bool blendsInSteps() {
  static const bool result = [] {
    const char* mode = std::getenv("ANTEROOM_REFERENCE_BLENDING");
    return mode != nullptr && std::string_view(mode) == "steps";
  }();
  return result;
}

// Table 4.3 on one component of `largest` + 1 values.
unsigned logicOperation(GLenum op, unsigned s, unsigned d, unsigned largest) {
  switch (op) {
    case GL_CLEAR:
      return 0;
    case GL_AND:
      return s & d;
    case GL_AND_REVERSE:
      return s & ~d & largest;
    case GL_COPY:
      return s;
    case GL_AND_INVERTED:
      return ~s & d & largest;
    case GL_NOOP:
      return d;
    case GL_XOR:
      return s ^ d;
    case GL_OR:
      return s | d;
    case GL_NOR:
      return ~(s | d) & largest;
    case GL_EQUIV:
      return ~(s ^ d) & largest;
    case GL_INVERT:
      return ~d & largest;
    case GL_OR_REVERSE:
      return (s | ~d) & largest;
    case GL_COPY_INVERTED:
      return ~s & largest;
    case GL_OR_INVERTED:
      return (~s | d) & largest;
    case GL_NAND:
      return ~(s & d) & largest;
    default:
      return largest;  // GL_SET
  }
}

// Encoded colors have no bits to combine: the operation is without effect, as in Vulkan.
glm::dvec4 logicOp(GLenum op, const glm::dvec4& s, const glm::dvec4& d, render::Format format) {
  if (render::isSrgb(format)) return s;
  const render::FormatInfo& bits = render::info(format);
  const int count[4] = {bits.red, bits.green, bits.blue, bits.alpha};
  glm::dvec4 result(0, 0, 0, 1);
  for (int i = 0; i < 4; ++i) {
    if (count[i] == 0) continue;
    const unsigned largest = (1u << count[i]) - 1;
    const auto field = [largest](double v) { return static_cast<unsigned>(std::floor(v * largest + 0.5)); };
    result[i] = double(logicOperation(op, field(std::clamp(s[i], 0.0, 1.0)), field(d[i]), largest)) / largest;
  }
  return result;
}

StoredImage* stored(const render::Attachment& attachment) {
  return static_cast<StoredImage*>(attachment.image.get());
}

}  // namespace

int memoryRow(const render::Framebuffer& framebuffer, int y) {
  return framebuffer.yDown ? framebuffer.height - 1 - y : y;
}

FragmentStage::FragmentStage(const render::State& state)
    : state_(state),
      color_(stored(state.framebuffer.color)),
      depth_(stored(state.framebuffer.depth)),
      stencil_(stored(state.framebuffer.stencil)) {
  if (stencil_ != nullptr) stencilMax_ = (1 << render::info(stencil_->desc().format).stencil) - 1;
}

glm::dvec4 FragmentStage::shade(const Fragment& fragment) const {
  std::array<glm::dvec4, gen::kMaxTextureUnits> samples{};
  for (int unit = 0; unit < gen::kMaxTextureUnits; ++unit)
    if (state_.fixed.units[static_cast<size_t>(unit)].target != gen::TextureTarget::None)
      samples[static_cast<size_t>(unit)] = sampleTexture(state_, unit, fragment);
  const gen::Fog& fog = state_.fixed.fog;
  const double f = fogFactor(fog, fragment.fogDistance);
  glm::dvec4 color = applyTextures(state_, fragment.color, samples, f);
  if (fog.enabled) {
    const glm::dvec3 fogColor = glm::clamp(glm::dvec3(fog.color), glm::dvec3(0), glm::dvec3(1));
    color = {f * glm::dvec3(color) + (1 - f) * fogColor, color.a};
  }
  color.a *= fragment.coverage;  // section 3.9
  return color;
}

// Section 4.1.4: at the precision of the framebuffer's alpha.
bool FragmentStage::alphaTest(double alpha) const {
  if (!state_.fixed.alphaTest) return true;
  const int bits = state_.fixed.alphaBits != 0 ? state_.fixed.alphaBits : 8;
  const double largest = std::ldexp(1.0, bits) - 1;
  const auto rounded = [largest](double v) { return std::floor(std::clamp(v, 0.0, 1.0) * largest + 0.5); };
  return compare(state_.fixed.alphaFunc, rounded(alpha), rounded(double(state_.fixed.alphaRef)));
}

// Section 4.1.3. Which samples a coverage value takes is the implementation's choice: the first ones.
uint32_t FragmentStage::coverageMask(const Fragment& fragment, double alpha) const {
  uint32_t mask = fragment.samples;
  if (!state_.fixed.multisample) return mask;
  const int samples = state_.framebuffer.samples;
  const auto first = [samples](double value) {
    return (1u << static_cast<int>(std::floor(std::clamp(value, 0.0, 1.0) * samples + 0.5))) - 1;
  };
  if (state_.ops.sampleAlphaToCoverage) mask &= first(alpha);
  if (state_.ops.sampleCoverage) {
    const uint32_t covered = first(double(state_.ops.sampleCoverageValue));
    mask &= state_.ops.sampleCoverageInvert ? ~covered : covered;
  }
  return mask;
}

// Sections 4.1.5 and 4.1.6. True: the fragment lives on.
bool FragmentStage::depthAndStencil(const Fragment& fragment, int sample) const {
  const render::FragmentOps& ops = state_.ops;
  const int row = memoryRow(state_.framebuffer, fragment.y);
  uint8_t* stencil = nullptr;
  if (stencil_ != nullptr && ops.stencilTest) {
    const render::Attachment& at = state_.framebuffer.stencil;
    stencil =
        &stencil_->level(at.level).stencil[stencil_->index(at.level, fragment.x, row, at.layer, sample)];
  }
  const int reference = std::clamp(ops.stencilRef, 0, stencilMax_);
  const auto update = [&](GLenum op) {
    if (stencil == nullptr) return;
    const int value = stencilOperation(op, *stencil, reference, stencilMax_);
    const int mask = static_cast<int>(ops.stencilWriteMask) & stencilMax_;
    *stencil = static_cast<uint8_t>((*stencil & ~mask) | (value & mask));
  };
  if (stencil != nullptr) {
    const int mask = static_cast<int>(ops.stencilValueMask) & stencilMax_;
    if (!compare(ops.stencilFunc, reference & mask, *stencil & mask)) {
      update(ops.stencilFail);
      return false;
    }
  }
  if (depth_ != nullptr && ops.depthTest) {
    const render::Attachment& at = state_.framebuffer.depth;
    double& z = depth_->level(at.level).z[depth_->index(at.level, fragment.x, row, at.layer, sample)];
    const double incoming = quantiseDepth(depth_->desc().format, fragment.z[static_cast<size_t>(sample)]);
    if (!compare(ops.depthFunc, incoming, z)) {
      update(ops.stencilDepthFail);
      return false;
    }
    update(ops.stencilDepthPass);
    if (ops.depthMask) z = incoming;
    return true;
  }
  update(ops.stencilDepthPass);
  return true;
}

glm::dvec4 FragmentStage::blend(const glm::dvec4& source, const glm::dvec4& destination) const {
  const render::FragmentOps& ops = state_.ops;
  if (ops.logicOpEnabled) return logicOp(ops.logicOp, source, destination, color_->desc().format);
  if (!ops.blend) return source;
  const auto stepped = [this](const glm::dvec4& v) {
    return blendsInSteps() ? quantise(color_->desc().format, v) : v;
  };
  const glm::dvec4 s = stepped(source);
  const auto scaled = [&](const glm::dvec4& color, GLenum factor) {
    return stepped(color * stepped(blendFactor(factor, s, destination)));
  };
  const glm::dvec4 rgb = blendEquation(ops.blendEquationRgb, s, scaled(s, ops.blendSrcRgb), destination,
                                       scaled(destination, ops.blendDstRgb));
  const glm::dvec4 alpha = blendEquation(ops.blendEquationAlpha, s, scaled(s, ops.blendSrcAlpha), destination,
                                         scaled(destination, ops.blendDstAlpha));
  return glm::clamp(glm::dvec4(glm::dvec3(rgb), alpha.a), glm::dvec4(0), glm::dvec4(1));
}

void FragmentStage::process(const Fragment& fragment) const {
  glm::dvec4 color = shade(fragment);
  if (!alphaTest(color.a)) return;
  const uint32_t mask = coverageMask(fragment, color.a);
  if (state_.fixed.multisample && state_.ops.sampleAlphaToOne) color.a = 1;
  const int row = memoryRow(state_.framebuffer, fragment.y);
  for (int sample = 0; sample < state_.framebuffer.samples; ++sample) {
    if ((mask & (1u << sample)) == 0 || !depthAndStencil(fragment, sample)) continue;
    if (color_ == nullptr) continue;
    const render::Attachment& at = state_.framebuffer.color;
    glm::dvec4& pixel =
        color_->level(at.level).color[color_->index(at.level, fragment.x, row, at.layer, sample)];
    const glm::dvec4 result = blend(color, pixel);
    for (int i = 0; i < 4; ++i)
      if (state_.ops.colorMask[static_cast<size_t>(i)]) pixel[i] = result[i];
    if (render::info(color_->desc().format).alpha == 0) pixel.a = 1;
  }
}

void quantiseColor(const render::Framebuffer& framebuffer, int fromRow, int toRow) {
  StoredImage* image = stored(framebuffer.color);
  if (image == nullptr) return;
  const render::Attachment& at = framebuffer.color;
  Level& level = image->level(at.level);
  for (int y = std::max(fromRow, 0); y < std::min(toRow, level.height); ++y) {
    const size_t start = image->index(at.level, 0, memoryRow(framebuffer, y), at.layer);
    const size_t count = static_cast<size_t>(level.width) * static_cast<size_t>(image->desc().samples);
    for (size_t i = 0; i < count; ++i)
      level.color[start + i] = quantise(image->desc().format, level.color[start + i]);
  }
}

}  // namespace anteroom::reference
