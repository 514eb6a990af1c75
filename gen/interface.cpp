#include "gen/interface.h"

#include "gen/reduce.h"

namespace anteroom::gen {

bool feeds(const VertexKey& vertex, const FragmentKey& fragment) {
  for (int u = 0; u < kMaxTextureUnits; ++u) {
    const Coordinate read = fragment.units[u].coordinate;
    if (read != Coordinate::None && read != Coordinate::Point && read != vertex.units[u].output) return false;
  }
  if (readsPrimaryColor(fragment) &&
      (vertex.color == VertexColor::None || vertex.twoSided != fragment.twoSided))
    return false;
  const bool readsFog = fragment.fog != FogMode::None || fragment.fogSource != FogMode::None;
  if (readsFog && !vertex.fog) return false;
  if (fragment.pointShape != PointShape::Square && fragment.pointShape != vertex.pointShape) return false;
  if (fragment.pointFade && !vertex.pointFade) return false;
  return fragment.discardPlanes == 0 || (vertex.clipVaryings && fragment.discardPlanes <= vertex.clipPlanes);
}

}  // namespace anteroom::gen
