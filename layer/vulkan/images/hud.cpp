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
