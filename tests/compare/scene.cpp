#include "scene.h"

namespace comparison {

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
    return all;
  }();
  return scenes;
}

}  // namespace comparison
