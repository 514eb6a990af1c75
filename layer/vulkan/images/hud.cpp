#include "layer/vulkan/images/hud.h"

#include <algorithm>
#include <span>

#include "layer/vulkan/images/attachments.h"
#include "layer/vulkan/images/hud_font.h"
#include "layer/vulkan/recording/recorder.h"

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

bool drawHud(Recorder& recorder, const Target& target, const Hud& hud) {
  const int width = 2 * kPadding + Hud::kColumns * kColumn - 1;
  const int height = 2 * kPadding + hud.lines * kRow - 3 + (hud.graphLine < 0 ? 0 : kGraph + kGraphGap);
  const int scale = scaleFor(target, width, height), margin = 4 * scale;
  const render::Rect rect =
      clipped({margin, target.height - margin - height * scale, width * scale, height * scale}, target);
  if (rect.width <= 0 || rect.height <= 0) return true;
  const Block block{{margin, margin, scale, target.yDown ? 0 : target.height},
                    {width, height, hud.lines, hud.nameColumns},
                    {hud.graphLine, Hud::kColumns, static_cast<int32_t>(hud.graphMark * kGraph) - 1, 0},
                    kFont,
                    hud.text,
                    hud.graph};

  Quad quad(target);
  quad.fragment = &kHudFragment;
  quad.constants = std::as_bytes(std::span(&block, 1));
  quad.counted = Counted::No;
  quad.state.scissor = flipped(rect, target);
  quad.state.fixed.blend = 1;
  quad.state.fixed.srcRgb = VK_BLEND_FACTOR_SRC_ALPHA;
  quad.state.fixed.dstRgb = quad.state.fixed.dstAlpha = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
  quad.state.fixed.writeMask = writeMask({true, true, true, true}, target);
  return loadSamples(recorder, target, Counted::No) && recorder.quad(target, quad);
}

}  // namespace anteroom::vulkan
