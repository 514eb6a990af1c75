#include "scene.h"

#include <string_view>

namespace comparison {

namespace {

struct Remark {
  std::string_view scene, text;
};

// Where Mesa's native ES 1.1 departs from us, and the section that decides.
constexpr Remark kMesaDiffers[] = {
    {"matrix/million rotations", "2.1.1: its matrices are float32, rounding adds up"},
    {"matrix/million translations", "2.1.1: its matrices are float32, rounding adds up"},
    {"matrix/stack of far moves", "2.1.1: its matrices are float32, far moves do not cancel"},
    {"singular/flattened to 1e-30",
     "2.10.3: the result is undefined for a singular matrix; ours is the limit"},
    {"attenuation/0", "2.1.1: division by 0 is undefined; ours leaves the light as it is"},
    {"light at a vertex/linear", "2.1.1: division by 0 is undefined; ours leaves the light as it is"},
    {"normals/1e-30", "2.10.3: the length is not to matter; its squares leave the range of float32"},
    {"normals/1e30", "2.10.3: the length is not to matter; its squares leave the range of float32"},
    {"light/at 1e30", "2.12.1: only the direction matters; its squares leave the range of float32"},
    {"light/direction 1e-30", "2.12.1: only the direction matters; its squares leave the range of float32"},
    {"light/direction 1e30", "2.12.1: only the direction matters; its squares leave the range of float32"},
    {"fog/start is end", "3.8: undefined where start is end; ours is the step that the limit is"},
    {"point size/quadratic at 0", "2.1.1: division by 0 is undefined; ours is the largest size"},
    {"environment/color 1e30", "3.7.12: TEXTURE_ENV_COLOR is clamped when it is set, Mesa keeps it"},
};

constexpr Remark kDeviations[] = {
    {"mipmaps/switch-over at 0.5",
     "3.7.7 has c = 0.5 for this pair of filters; Vulkan (and Mesa) switch over at 0"},
    {"points/smooth", "3.3 wants the covered area; ours takes the distance of the centre from the rim"},
    {"coordinates/1e9 clamped",
     "the driver converts texel coordinates to 32-bit integers before it clamps them"},
    {"denormals/positions", "2.1.1 leaves the result open; the driver flushes denormals to 0"},
};

}  // namespace

const Scenes& allScenes() {
  static const Scenes scenes = [] {
    Scenes all;
    addDriverScenes(all);
    addLightingScenes(all);
    addTextureScenes(all);
    addFragmentScenes(all);
    addPrimitiveScenes(all);
    const std::size_t ordinary = all.size();
    addMatrixExtremes(all);
    addLightingExtremes(all);
    addTextureExtremes(all);
    addVertexExtremes(all);
    for (std::size_t i = ordinary; i < all.size(); ++i) all[i].extreme = true;
    for (Scene& scene : all) {
      for (const Remark& remark : kMesaDiffers)
        if (remark.scene == scene.name) scene.mesaDiffers = remark.text;
      for (const Remark& remark : kDeviations)
        if (remark.scene == scene.name) scene.deviates = remark.text;
    }
    return all;
  }();
  return scenes;
}

}  // namespace comparison
