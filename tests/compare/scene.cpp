#include "scene.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace comparison {

namespace {

struct Remark {
  std::string_view scene, text;
};

// Where Mesa's native ES 1.1 departs from us, and the section that decides.
struct MesaRemark {
  std::string_view text;
  std::vector<std::string_view> scenes;
};

const std::vector<MesaRemark>& mesaRemarks() {
  static const std::vector<MesaRemark> remarks = {
      // The float64 renderer without this clamp draws what Mesa draws.
      {"2.12.5: a lit colour is clamped at the vertex; Mesa interpolates what lies beyond 1 or below 0",
       {"lighting/specular",
        "lighting/spot",
        "lighting/eight lights",
        "lighting/two-sided",
        "far camera/1e4",
        "far camera/1e6",
        "far camera/1e7",
        "far camera/1e6 turned",
        "far camera/1e7 turned",
        "matrix/world of 1e-18",
        "matrix/world of 1e18",
        "clip plane/at 1e6",
        "shininess/0",
        "shininess/1e-6",
        "spot/exponent 0 cutoff 90",
        "spot/exponent 0 cutoff 180",
        "spot/exponent 128 cutoff 180",
        "attenuation/1e-30",
        "attenuation/quadratic 1e-6",
        "normals/1e-10",
        "normals/1e10",
        "light/at 1e18",
        "light/w 1e-30",
        "light/negative colors"}},
      {"2.12.5: a lit colour is clamped at the vertex; Mesa interpolates infinity, which gives no number",
       {"normals/1e30 as they are"}},
      {"2.12.5, 3.7.12: a lit colour is clamped at the vertex, and what enters a texture function is in "
       "[0, 1]; Mesa multiplies the texture by what lies beyond 1. The value that is no number is not the "
       "cause",
       {"nan/position", "nan/normal", "nan/color", "nan/texture coordinate", "infinity/position",
        "infinity/minus, depth", "infinity/normal", "infinity/color", "infinity/texture coordinate"}},
      {"2.11.4 of OES_texture_cube_map: NORMAL_MAP is the eye normal; Mesa generates something else",
       {"cube map/normal"}},
      {"3.2.1: a pixel's samples are combined into one colour; Mesa's pbuffer shows the first of its four",
       {"fragment/multisample"}},
      {"3.3: the distance is from the eye to the vertex; Mesa takes its depth alone", {"points/attenuated"}},
      {"3.7.7: rho is 1 for a point sprite; Mesa takes its level of detail from the sprite's size",
       {"points/sprites, mipmapped"}},
      {"3.3.1: coverage is the area of the circle inside the pixel; Mesa takes a ramp over the rim",
       {"points/smooth"}},
      {"3.7.8: c is 0.5 for this pair of filters; Mesa switches over at 0", {"mipmaps/switch-over at 0.5"}},
      {"2.1.1: its matrices are float32, which moves far surfaces by more than a step of the depth buffer",
       {"depth/1e-6 to 1e6"}},
      {"2.1.1: its matrices are float32, rounding adds up",
       {"matrix/million rotations", "matrix/million translations"}},
      {"2.1.1: its matrices are float32, far moves do not cancel", {"matrix/stack of far moves"}},
      {"2.10.3: the result is undefined for a singular matrix; ours is the limit",
       {"singular/flattened to 1e-30"}},
      {"2.1.1: division by 0 is undefined; ours leaves the light as it is",
       {"attenuation/0", "light at a vertex/linear"}},
      {"2.10.3: the length is not to matter; its squares leave the range of float32",
       {"normals/1e-30", "normals/1e30"}},
      {"2.12.1: only the direction matters; its squares leave the range of float32",
       {"light/at 1e30", "light/direction 1e-30", "light/direction 1e30"}},
      {"3.8: undefined where start is end; ours is the step that the limit is", {"fog/start is end"}},
      {"2.1.1: division by 0 is undefined; ours is the largest size", {"point size/quadratic at 0"}},
      {"3.7.12: TEXTURE_ENV_COLOR is clamped when it is set, Mesa keeps it", {"environment/color 1e30"}},
  };
  return remarks;
}

constexpr Remark kDeviations[] = {
    {"coordinates/1e9 clamped",
     "2.1.1 asks for texture coordinates up to 2^10 only; beyond 2^31 texels the driver, like Mesa, converts "
     "them to integers before it clamps them. A clamp in every shader would cost all that is textured"},
    {"denormals/positions",
     "2.1.1 asks for magnitudes of 2^32 and an accuracy of 1 in 10^5, not for numbers below 10^-38; the "
     "driver, like "
     "Mesa, flushes them to 0"},
};

}  // namespace

const Scenes& allScenes() {
  static const Scenes scenes = [] {
    Scenes all;
    addLightingScenes(all);
    addTextureScenes(all);
    addFragmentScenes(all);
    addPrimitiveScenes(all);
    addPaletteScenes(all);
    const std::size_t ordinary = all.size();
    addMatrixExtremes(all);
    addLightingExtremes(all);
    addTextureExtremes(all);
    addVertexExtremes(all);
    addPaletteExtremes(all);
    for (std::size_t i = ordinary; i < all.size(); ++i) all[i].extreme = true;
    for (Scene& scene : all) {
      for (const MesaRemark& remark : mesaRemarks())
        if (std::find(remark.scenes.begin(), remark.scenes.end(), scene.name) != remark.scenes.end())
          scene.mesaDiffers = remark.text;
      for (const Remark& remark : kDeviations)
        if (remark.scene == scene.name) scene.deviates = remark.text;
    }
    return all;
  }();
  return scenes;
}

}  // namespace comparison
