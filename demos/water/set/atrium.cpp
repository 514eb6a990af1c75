#include "atrium.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "painted_stone.h"
#include "room/noise.h"
#include "room/set/materials.h"
#include "water/refraction.h"

namespace water {
namespace {

using glm::dvec2;
using glm::dvec3;
using room::MeshData;

constexpr double kCell = 0.35;        // tessellation of the floor, metres
constexpr double kSkyHeight = 5.2;    // of the sky's picture
constexpr double kOpeningRim = 0.35;  // thickness of the roof
constexpr dvec3 kToSun(-0.36, 0.80, 0.92);

struct Rectangle {
  dvec2 low;
  dvec2 high;
};

// The room's outline less the pool's, in x and z.
std::array<Rectangle, 4> aroundPool() {
  const dvec2 low = kPoolCenter - kPoolHalf;
  const dvec2 high = kPoolCenter + kPoolHalf;
  return {{{{kRoomMin.x, kRoomMin.z}, {kRoomMax.x, low.y}},
           {{kRoomMin.x, high.y}, {kRoomMax.x, kRoomMax.z}},
           {{kRoomMin.x, low.y}, {low.x, high.y}},
           {{high.x, low.y}, {kRoomMax.x, high.y}}}};
}

// A point of the pool's inside and its place when the walls are folded down: side 4 is the bottom.
struct PoolPoint {
  dvec3 position;
  dvec3 normal;
};
PoolPoint poolPoint(dvec2 unfolded) {
  const dvec2 middle = glm::clamp(unfolded, -kPoolHalf, kPoolHalf);
  const dvec2 beyond = unfolded - middle;
  const double up = std::abs(beyond.x) + std::abs(beyond.y);
  dvec3 normal(0, 1, 0);
  if (std::abs(beyond.x) > std::abs(beyond.y)) normal = {beyond.x > 0 ? -1 : 1, 0, 0};
  if (std::abs(beyond.y) > std::abs(beyond.x)) normal = {0, 0, beyond.y > 0 ? -1 : 1};
  return {{kPoolCenter.x + middle.x, std::min(kPoolBottom + up, 0.0), kPoolCenter.y + middle.y}, normal};
}

}  // namespace

Atrium::Atrium() {
  light_.addAmbient({0.17, 0.150, 0.135});
  light_.add(room::Sun{kToSun, 0.02, {2.7, 2.05, 1.28}});
  makeMaterials();
  addColumns();
  addRim();
  addRoofBeams();
  addUrn();
  addPlants();
  addAmphorae();
  addBench();
  addLampStand();
  addCeiling();
  addFloor();
  addWalls();
  finish(marble_, marbleMesh_);
  finish(white_, whiteMesh_);
  finish(red_, redMesh_);
  finish(wood_, woodMesh_);
  finish(terracotta_, clayMesh_);
  finish(bronze_, bronzeMesh_);
  finish(cloth_, clothMesh_);
  finish(leaf_, leafMesh_, true);
  addPool();
  addSky();
  addShaft();
  addLily();
}

void Atrium::makeMaterials() {
  const room::BakedTexels wall = room::bake(512, 1024, fresco);
  fresco_ = room::makeTexture(wall.color, room::Filter::Mipmapped, GL_REPEAT);
  const room::Image floor = room::generate(1024, 1024, 4, [](double u, double v, float* out) {
    const room::Texel t = slabs(u, v);
    for (int i = 0; i < 3; ++i) out[i] = static_cast<float>(t.color[i]);
    out[3] = static_cast<float>(puddle(u, v));
  });
  slabs_ = room::makeTexture(floor, room::Filter::Mipmapped, GL_REPEAT);
  marble_ = room::materialTexture(256, marble);
  white_ =
      room::materialTexture(256, [](double u, double v) { return stucco(u, v, dvec3(0.84, 0.79, 0.68)); });
  red_ = room::materialTexture(256, [](double u, double v) { return stucco(u, v, dvec3(0.55, 0.15, 0.10)); });
  wood_ = room::materialTexture(256, [](double u, double v) {
    room::Texel t = room::wood(u, v);
    t.color *= dvec3(0.62, 0.55, 0.48);
    return t;
  });
  terracotta_ = room::materialTexture(128, terracotta);
  bronze_ = room::materialTexture(128, bronze);
  leaf_ = room::materialTexture(128, leafTexel);
  petal_ = room::materialTexture(64, petalTexel);
  sky_ = room::materialTexture(256, skyTexel);
  cloth_ =
      room::materialTexture(64, [](double u, double v) { return stucco(u, v, dvec3(0.20, 0.30, 0.52)); });
}

Surface& Atrium::addSurface(std::vector<Surface>& to, const room::Texture& base, MeshData data) {
  Surface& surface = to.emplace_back();
  surface.mesh = std::make_unique<room::Mesh>(data);
  surface.data = std::move(data);
  surface.base = &base;
  return surface;
}

const room::Texture& Atrium::addLightmap(int width, int height, dvec3 origin, dvec3 a, dvec3 b) {
  return *lightmaps_.emplace_back(std::make_unique<room::Texture>(room::makeTexture(
      light_.lightmap(width, height, origin, a, b), room::Filter::Linear, GL_CLAMP_TO_EDGE)));
}

void Atrium::setLightmap(Surface& surface, const room::Texture& lightmap, dvec3 origin, dvec3 a, dvec3 b) {
  surface.lightmap = &lightmap;
  surface.toLightmap = room::rectangleCoordinates(origin, a, b);
}

void Atrium::addFloor() {
  const dvec3 origin(kRoomMin.x, 0, kRoomMax.z);
  const dvec3 a(kRoomMax.x - kRoomMin.x, 0, 0);
  const dvec3 b(0, 0, kRoomMin.z - kRoomMax.z);
  const room::Texture& lightmap = addLightmap(256, 256, origin, a, b);
  for (const Rectangle& r : aroundPool()) {
    MeshData data = room::rectangle({r.low.x, 0, r.high.y}, {r.high.x - r.low.x, 0, 0},
                                    {0, 0, r.low.y - r.high.y}, kCell, 1);
    for (room::Vertex& v : data.vertices) v.uv = dvec2(v.position.x, v.position.z) / kFloorExtent;
    setLightmap(addSurface(floor_, slabs_, std::move(data)), lightmap, origin, a, b);
  }
}

void Atrium::addWalls() {
  const dvec3 size = kRoomMax - kRoomMin;
  const dvec3 y(0, size.y, 0);
  const auto wall = [&](const dvec3& origin, const dvec3& along) {
    Surface& surface =
        addSurface(walls_, fresco_,
                   room::surface(10, 6, [&](double u, double v) { return origin + along * u + y * v; },
                                 {glm::length(along) / kPanel, 1}));
    setLightmap(surface, addLightmap(128, 64, origin, along, y), origin, along, y);
  };
  wall(kRoomMin, {size.x, 0, 0});
  wall({kRoomMin.x, 0, kRoomMax.z}, {0, 0, -size.z});
  wall({kRoomMax.x, 0, kRoomMin.z}, {0, 0, size.z});
  wall({kRoomMax.x, 0, kRoomMax.z}, {-size.x, 0, 0});
}

void Atrium::addCeiling() {
  const double top = kRoomMax.y;
  const dvec3 origin(kRoomMin.x, top, kRoomMin.z);
  const dvec3 a(kRoomMax.x - kRoomMin.x, 0, 0);
  const dvec3 b(0, 0, kRoomMax.z - kRoomMin.z);
  const double middle = top + kOpeningRim / 2;
  for (const Rectangle& r : aroundPool()) {
    const dvec2 center = (r.low + r.high) * 0.5;
    const dvec2 half = (r.high - r.low) * 0.5;
    light_.add(
        room::Block{{center.x, middle, center.y}, {half.x + 0.02, kOpeningRim / 2 - 0.01, half.y + 0.02}});
    // The ground, which the pool is dug into.
    light_.add(room::Block{{center.x, -0.40, center.y}, {half.x - 0.02, 0.38, half.y - 0.02}});
  }
  // The walls hold the sky's and the sun's light off.
  const dvec3 half = (kRoomMax - kRoomMin) * 0.5;
  const dvec3 room = (kRoomMax + kRoomMin) * 0.5;
  for (double side : {-1.0, 1.0}) {
    light_.add(room::Block{room + dvec3(side * (half.x + 0.51), 0, 0), {0.5, half.y + 1, half.z + 1}});
    light_.add(room::Block{room + dvec3(0, 0, side * (half.z + 0.51)), {half.x + 1, half.y + 1, 0.5}});
  }
  light_.add(room::Opening{{kPoolCenter.x - kPoolHalf.x, top, kPoolCenter.y - kPoolHalf.y},
                           {2 * kPoolHalf.x, 0, 0},
                           {0, 0, 2 * kPoolHalf.y},
                           {1.35, 1.55, 1.85}});
  // What the sunlit wall throws back.
  light_.add(room::Lamp{{1.6, 1.2, -4.3}, 0.8, {0.62, 0.30, 0.17}, false});

  const room::Texture& lightmap = addLightmap(64, 64, origin, a, b);
  for (const Rectangle& r : aroundPool()) {
    MeshData data = room::rectangle({r.low.x, top, r.low.y}, {r.high.x - r.low.x, 0, 0},
                                    {0, 0, r.high.y - r.low.y}, 2, 0.8);
    setLightmap(addSurface(walls_, wood_, std::move(data)), lightmap, origin, a, b);
  }
}

// Seen over the water's edge, and where there is none.
void Atrium::addPool() {
  MeshData mesh;
  const auto piece = [&](const Rectangle& r) {
    MeshData data = room::surface(12, 12, [&](double u, double v) {
      // Folded out, x and -z are the two directions of a floor that is seen from above.
      return poolPoint({glm::mix(r.low.x, r.high.x, u), glm::mix(r.high.y, r.low.y, v)}).position;
    });
    for (room::Vertex& v : data.vertices) {
      v.uv = poolTexCoord({glm::mix(r.low.x, r.high.x, v.uv.x), glm::mix(r.high.y, r.low.y, v.uv.y)});
    }
    mesh.append(data);
  };
  const dvec2 h = kPoolHalf;
  piece({-h, h});
  piece({{-kUnfoldedPool, -h.y}, {-h.x, h.y}});
  piece({{h.x, -h.y}, {kUnfoldedPool, h.y}});
  piece({{-h.x, -kUnfoldedPool}, {h.x, -h.y}});
  piece({{-h.x, h.y}, {h.x, kUnfoldedPool}});
  pool_ = std::make_unique<room::Mesh>(mesh);

  // The light, from a coarse picture of it.
  constexpr int kCoarse = 128;
  const auto unfoldedAt = [](double u, double v) { return (dvec2(u, v) - 0.5) * (2 * kUnfoldedPool); };
  const room::Image lit = room::generate(kCoarse, kCoarse, 3, [&](double u, double v, float* out) {
    const PoolPoint p = poolPoint(unfoldedAt(u, v));
    const glm::vec3 half = light_.halfLight(p.position, p.normal);
    for (int i = 0; i < 3; ++i) out[i] = half[i];
  });
  const room::Image picture = room::generate(1024, 1024, 3, [&](double u, double v, float* out) {
    std::array<float, 3> light{};
    lit.interppixel(static_cast<float>(u * kCoarse), static_cast<float>(v * kCoarse), light.data(),
                    OIIO::ImageBuf::WrapClamp);
    const dvec3 stone = poolMosaic(unfoldedAt(u, v));
    for (std::size_t i = 0; i < 3; ++i) out[i] = static_cast<float>(stone[static_cast<int>(i)]) * light[i];
  });
  poolTexture_ = room::makeTexture(picture, room::Filter::Mipmapped, GL_CLAMP_TO_EDGE);
}

void Atrium::addSky() {
  constexpr double kHalf = 6;
  addGlowing(sky_,
             room::rectangle({-kHalf, kSkyHeight, -kHalf}, {2 * kHalf, 0, 0}, {0, 0, 2 * kHalf}, 20, 0.125),
             glm::vec3(1));
  // The flames are small, white and in no need of a texture's details.
  addGlowing(white_, flameMesh_, {1.0F, 0.86F, 0.55F});
}

// Upright slices of the sun's light, from the back wall to where it comes in.
void Atrium::addShaft() {
  constexpr int kSlices = 32;
  constexpr double kDust = 0.028;
  constexpr double kFront = 1.6;  // z of the nearest slice
  const dvec3 step = -kToSun / kToSun.y;
  const double top = kRoomMax.y + kOpeningRim;
  MeshData mesh;
  std::vector<glm::vec3> colors;
  for (int i = 0; i < kSlices; ++i) {
    const double z = glm::mix(kRoomMin.z, kFront, (i + 0.5) / kSlices);
    // v runs through the opening from its far edge to its near one, as far as that is between floor and roof.
    const auto fallen = [&](double v) {
      const double entered = kPoolCenter.y + (2 * v - 1) * kPoolHalf.y;
      return std::clamp((z - entered) / step.z, 0.0, top);
    };
    MeshData slice = room::surface(1, 8, [&](double u, double v) {
      const double down = fallen(v);
      return dvec3(kPoolCenter.x + (2 * u - 1) * kPoolHalf.x + step.x * down, top - down, z);
    });
    mesh.append(slice);
    for (const room::Vertex& v : slice.vertices) {
      const double thin = 1 - 0.6 * (top - v.position.y) / top;
      colors.emplace_back(dvec3(1.0, 0.82, 0.56) * (kDust * thin));
    }
  }
  shaft_ = std::make_unique<room::Mesh>(mesh, colors);
  const room::Image soft = room::generate(64, 64, 1, [](double u, double v, float* out) {
    const double edge = 0.5 - std::max(std::abs(u - 0.5), std::abs(v - 0.5));
    *out = static_cast<float>(room::smoothStep(0.0, 0.10, edge));
  });
  shaftTexture_ = room::makeTexture(soft, room::Filter::Linear, GL_CLAMP_TO_EDGE);
}

void Atrium::finish(const room::Texture& base, const MeshData& data, bool twoSided) {
  furniture_.push_back(
      {std::make_unique<room::Mesh>(data, light_.vertexLight(data)), &base, kLightScale, twoSided});
}

void Atrium::addGlowing(const room::Texture& base, const MeshData& data, glm::vec3 color) {
  furniture_.push_back({std::make_unique<room::Mesh>(data, color), &base, 1, false});
}

}  // namespace water
