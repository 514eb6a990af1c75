// The HUD: one quad over the picture. Letters and graph are made in its fragment shader, of a block of
// constants that holds the font, too.
#include <algorithm>
#include <cstring>

#include "layer/render/hud.h"
#include "layer/vulkan/context.h"
#include "layer/vulkan/device/device.h"
#include "layer/vulkan/images/hud_font.h"
#include "layer/vulkan/pipelines/shader_library.h"
#include "layer/vulkan/windows/window.h"

namespace anteroom::vulkan {

extern const char kHudFragment[] = R"(#version 450
// Lines of text and a graph on a translucent plate (ANTEROOM_HUD).
layout(set = 2, binding = 0) uniform Hud {
  ivec4 place;   // the plate's upper left corner; pixels of one of its own; height of the picture, 0: row 0 is its top
  ivec4 plate;   // its size in pixels of its own; lines; columns that hold names
  ivec4 graph;   // the line above it, -1: none; columns; y of the mark
  uvec4 font[48];
  uvec4 text[18];
  vec4 samples[36];
};
layout(location = 0) out vec4 color;

const int kPadding = 5, kRow = 12, kColumn = 6, kGraph = 26;
const vec4 kPlate = vec4(0.04, 0.05, 0.07, 0.78), kName = vec4(0.56, 0.69, 0.80, 1), kValue = vec4(0.95, 0.96, 0.97, 1);
const vec4 kMark = vec4(1, 1, 1, 0.35);
const vec4 kGood = vec4(0.40, 0.80, 0.50, 1), kFair = vec4(0.93, 0.75, 0.32, 1), kBad = vec4(0.92, 0.38, 0.33, 1);

uint byteOf(uvec4 words, int i) { return words[i >> 2] >> (8 * (i & 3)) & 0xffu; }

bool inGlyph(uint character, ivec2 at) {
  if (character < 32u || character > 127u || at.x >= 5 || at.y >= 9) return false;
  uvec4 pair = font[(character - 32u) >> 1];
  uvec2 glyph = (character & 1u) == 0u ? pair.xy : pair.zw;
  int bit = at.y * 5 + at.x;
  return ((bit < 32 ? glyph.x >> bit : glyph.y >> (bit - 32)) & 1u) == 1u;
}

// The bar of one sample; its height says how good it is, too.
vec4 graphAt(ivec2 at) {
  float value = samples[at.x >> 2][at.x & 3];
  int y = kGraph - 1 - at.y;
  vec4 under = y == graph.z ? kMark : vec4(kPlate.rgb * 0.5, kPlate.a);
  if (float(y) >= ceil(value * kGraph)) return under;
  float mark = float(graph.z + 1) / kGraph;
  vec4 bar = value <= mark * 1.1 ? kGood : value <= mark * 2.1 ? kFair : kBad;
  return y == graph.z ? mix(bar, vec4(1), 0.4) : bar;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  if (place.w > 0) pixel.y = place.w - 1 - pixel.y;
  ivec2 at = (pixel - place.xy) / place.z;
  ivec2 edge = min(at, plate.xy - 1 - at);
  if (edge.x + edge.y < 2) discard;  // round corners
  color = kPlate;
  at -= kPadding;
  if (at.x < 0 || at.y < 0 || at.x >= graph.y * kColumn) return;
  if (graph.x >= 0 && at.y >= (graph.x + 1) * kRow) {
    int below = at.y - (graph.x + 1) * kRow;
    if (below < kGraph) {
      color = graphAt(ivec2(at.x, below));
      return;
    }
    at.y -= kGraph + 4;
    if (at.y < (graph.x + 1) * kRow) return;
  }
  ivec2 cell = at / ivec2(kColumn, kRow);
  if (cell.y >= plate.z) return;
  int i = cell.y * graph.y + cell.x;
  if (inGlyph(byteOf(text[i >> 4], i & 15), at - cell * ivec2(kColumn, kRow)))
    color = cell.x < plate.w ? kName : kValue;
}
)";

namespace {

using render::Hud;

// As the shader has them.
constexpr int kPadding = 5, kRow = 12, kColumn = 6, kGraph = 26, kGraphGap = 4;
struct Block {
  int32_t place[4], plate[4], graph[4];
  std::array<uint32_t, 192> font;
  std::array<Hud::Line, Hud::kMostLines> text;
  std::array<float, Hud::kSamples> samples;
};
static_assert(sizeof(Block) == 16 * (3 + 48 + 18 + 36));

constexpr std::array<uint32_t, 192> kFont = packedFont();

// Pixels of the picture that one of the plate takes: letters keep their size to the eye.
int scaleFor(const Target& target, int width, int height) {
  const int legible = std::max(1, (target.height + 120) / 360);
  const int fitting = std::min(target.width / width, target.height / height);
  return std::clamp(legible, 1, std::max(1, fitting));
}

}  // namespace

bool VulkanContext::drawHud(const Target& target, const Hud& hud) {
  flushBatch();
  Block block{};
  const int width = 2 * kPadding + Hud::kColumns * kColumn - 1;
  const int height = 2 * kPadding + hud.lines * kRow - 3 + (hud.graphLine < 0 ? 0 : kGraph + kGraphGap);
  const int scale = scaleFor(target, width, height), margin = 4 * scale;
  const int32_t place[] = {margin, margin, scale, target.yDown ? 0 : target.height};
  const int32_t plate[] = {width, height, hud.lines, hud.nameColumns};
  const int32_t graph[] = {hud.graphLine, Hud::kColumns, static_cast<int32_t>(hud.graphMark * kGraph) - 1};
  std::memcpy(block.place, place, sizeof place);
  std::memcpy(block.plate, plate, sizeof plate);
  std::memcpy(block.graph, graph, sizeof graph);
  block.font = kFont;
  block.text = hud.text;
  block.samples = hud.graph;
  const render::Rect rect =
      clipped({margin, target.height - margin - height * scale, width * scale, height * scale}, target);
  if (rect.width <= 0 || rect.height <= 0) return true;

  const StreamPiece piece =
      constants_.allocate(sizeof block, device_.limits().minUniformBufferOffsetAlignment);
  if (!piece) return false;
  std::memcpy(piece.mapped, &block, sizeof block);

  DrawState quad = plainQuad(target);
  quad.scissor = flipped(rect, target);
  quad.fixed.blend = 1;
  quad.fixed.srcRgb = VK_BLEND_FACTOR_SRC_ALPHA;
  quad.fixed.dstRgb = quad.fixed.dstAlpha = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
  quad.fixed.writeMask = writeMask({true, true, true, true}, target);
  const uint64_t passes = pass_.passes();
  if (!bindQuad(target, quad, kHudFragment, false, Counted::No)) return false;
  ownPasses_ += pass_.passes() - passes;
  const VkCommandBuffer commands = commands_.commands();
  const auto offset = static_cast<uint32_t>(piece.offset);
  device_.fn().vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, device_.pipelineLayout(), 2,
                                       1, &piece.constants.fragment, 1, &offset);
  bound_.fragmentConstants = {piece.constants.fragment, offset};
  device_.fn().vkCmdDraw(commands, 3, 1, 0, 0);
  return true;
}

// Over what goes to the screen alone: the picture that a program goes on with may be another image.
bool VulkanContext::drawHud(VulkanWindow& window) {
  render::Framebuffer framebuffer;
  framebuffer.color.image = window.overlay();
  framebuffer.width = framebuffer.color.image->desc().width;
  framebuffer.height = framebuffer.color.image->desc().height;
  framebuffer.yDown = true;
  const bool done = drawHud(targetOf(framebuffer), *window.hud());
  pass_.end();
  vulkan(*framebuffer.color.image).setStore(nullptr);
  return done;
}

void VulkanContext::drawHud(const render::Framebuffer& framebuffer, const Hud& hud) {
  drawHud(targetOf(framebuffer), hud);
}

}  // namespace anteroom::vulkan
