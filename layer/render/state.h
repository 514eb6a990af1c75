// Everything that a draw or a clear depends on, as plain data. The GL front end owns one State a context,
// alone writes into it; a renderer reads it. Which groups changed is told beside it (renderer.h).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "gen/state.h"
#include "layer/render/format.h"

namespace anteroom::render {

class Buffer;
class Image;
class Window;

using gen::Rect;

// One face (cube maps: +X, -X, +Y, -Y, +Z, -Z; else 0; 3D images: a slice) of one level of an image.
struct Attachment {
  std::shared_ptr<Image> image;
  int level = 0;
  int layer = 0;
};

// Where drawing goes. Images may be allocated only when they are first used: a framebuffer whose depth image
// is never read or written costs no depth memory. depth and stencil may be the same image.
struct Framebuffer {
  Attachment color, depth, stencil;
  // Where there is one, it has one sample a pixel and always holds the mean of color's samples. color then is
  // an image of its own, of the same format and size, whose samples start with what `resolve` holds, and do
  // so again whenever something else has written to it.
  Attachment resolve;
  int width = 0, height = 0;
  int samples = 1;
  // Row 0 of the images is the top row (windows); otherwise it is GL's row 0, and nothing is flipped
  // anywhere.
  bool yDown = false;
  // Whose next picture the images are (window.h): they hold while it is ready. Null: they stay.
  Window* window = nullptr;

  // Where pixels are read from.
  const Attachment& readable() const { return resolve.image ? resolve : color; }
};

// Section 3.7.4 and the extensions about samplers.
struct Sampler {
  GLenum minFilter = GL_NEAREST_MIPMAP_LINEAR;
  GLenum magFilter = GL_LINEAR;
  GLenum wrapS = GL_REPEAT;
  GLenum wrapT = GL_REPEAT;
  GLenum wrapR = GL_REPEAT;
  float maxAnisotropy = 1;
  int maxLevel = 1000;
  bool operator==(const Sampler&) const = default;
};

// Read for a unit whose gen::TextureUnit::target is not None: the image is complete for this sampler.
struct TextureBinding {
  Image* image = nullptr;
  Sampler sampler;
  // A part of the image, sampled as a flat image of one level would be: this level of this cube face. -1: all
  // of it.
  int onlyLevel = -1;
  int onlyLayer = 0;
};

// Where an enabled array's data lie: `buffer` null: `pointer` is client memory; otherwise it is an offset in
// bytes.
struct VertexArray {
  Buffer* buffer = nullptr;
  const void* pointer = nullptr;
  uint32_t stride = 0;  // bytes from one element to the next, never 0 for an enabled array
};

struct Raster {
  bool cullFace = false;
  GLenum cullFaceMode = GL_BACK;
  GLenum frontFace = GL_CCW;
  bool polygonOffsetFill = false;
  float polygonOffsetFactor = 0;
  float polygonOffsetUnits = 0;
  float polygonOffsetClamp = 0;  // EXT_polygon_offset_clamp; 0, NaN, infinite: none
  float lineWidth = 1;
};

struct FragmentOps {
  bool depthTest = false;
  GLenum depthFunc = GL_LESS;
  bool depthMask = true;

  bool stencilTest = false;
  GLenum stencilFunc = GL_ALWAYS;
  int stencilRef = 0;
  uint32_t stencilValueMask = ~0u;
  uint32_t stencilWriteMask = ~0u;
  GLenum stencilFail = GL_KEEP;
  GLenum stencilDepthFail = GL_KEEP;
  GLenum stencilDepthPass = GL_KEEP;

  bool blend = false;
  GLenum blendSrcRgb = GL_ONE, blendDstRgb = GL_ZERO;
  GLenum blendSrcAlpha = GL_ONE, blendDstAlpha = GL_ZERO;
  GLenum blendEquationRgb = GL_FUNC_ADD_OES, blendEquationAlpha = GL_FUNC_ADD_OES;
  bool logicOpEnabled = false;  // disables blending (section 4.1.8)
  GLenum logicOp = GL_COPY;
  std::array<bool, 4> colorMask{true, true, true, true};
  bool dither = true;

  bool multisample = true;
  bool sampleAlphaToCoverage = false;
  bool sampleAlphaToOne = false;
  bool sampleCoverage = false;
  float sampleCoverageValue = 1;
  bool sampleCoverageInvert = false;
};

struct ClearValues {
  glm::vec4 color{0, 0, 0, 0};
  float depth = 1;
  int stencil = 0;
};

struct State {
  gen::State fixed;
  std::array<VertexArray, gen::kAttributeCount> arrays;
  std::array<TextureBinding, gen::kMaxTextureUnits> textures;
  Raster raster;
  FragmentOps ops;
  float depthNear = 0, depthFar = 1;
  bool scissorTest = false;
  Rect scissor;
  ClearValues clear;
  Framebuffer framebuffer;
};

// glDrawArrays and glDrawElements, validated: count > 0, the mode and type are legal. Section 2.8.
struct DrawCall {
  GLenum mode = GL_TRIANGLES;  // GL_POINTS ... GL_TRIANGLE_FAN
  int first = 0;               // without indices
  int count = 0;
  GLenum indexType = 0;  // 0: no indices; GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT
  Buffer* indexBuffer = nullptr;
  const void* indices = nullptr;  // client memory, or the offset in indexBuffer
};

}  // namespace anteroom::render
