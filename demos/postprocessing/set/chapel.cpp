#include "chapel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "measures.h"
#include "room/noise.h"
#include "room/set/materials.h"

namespace postprocessing {
namespace {

using glm::dvec2;
using glm::dvec3;
using room::MeshData;

constexpr double kCell = 0.22;         // tessellation of the walls, metres
constexpr double kGlassRecess = 0.34;  // of the glass behind the face of the wall
constexpr double kSplay = 0.16;        // by which openings are wider than their glass
constexpr int kSunMapSize = 512;
constexpr dvec3 kToSun(-0.07, 0.60, -0.80);

constexpr double kShaftMargin = 1.4;  // of a shaft's slices, times the size of the glass
constexpr double kShaftLength = 7.5;  // metres
constexpr int kShaftSlices = 60;
constexpr double kDust = 0.030;  // of the light, what a slice of it scatters

constexpr std::array<Lancet, 3> kLancets = {
    {{-1.62, 0.84, 2.0, 3.25}, {0.0, 1.30, 1.75, 3.95}, {1.62, 0.84, 2.0, 3.25}}};

double gableAt(double x) {
  return glm::mix(kRidge, kEaves, std::abs(x) / kRoomMax.x);
}

Lancet openingOf(const Lancet& glass) {
  return {glass.center, glass.width + 2 * kSplay, glass.sill - 1.4 * kSplay, glass.spring};
}

// The outline from the sill's left end round to it again: sill, jamb, two arcs, jamb. u in [0,1].
dvec2 outline(const Lancet& lancet, int piece, double u) {
  const double left = lancet.center - lancet.width / 2;
  const double right = lancet.center + lancet.width / 2;
  const double third = glm::pi<double>() / 3;
  switch (piece) {
    case 0:
      return {glm::mix(left, right, u), lancet.sill};
    case 1:
      return {right, glm::mix(lancet.sill, lancet.spring, u)};
    case 2:
      return dvec2(left, lancet.spring) + lancet.width * dvec2(std::cos(third * u), std::sin(third * u));
    case 3:
      return dvec2(right, lancet.spring) +
             lancet.width * dvec2(std::cos(third * (2 + u)), std::sin(third * (2 + u)));
    default:
      return {left, glm::mix(lancet.spring, lancet.sill, u)};
  }
}

// A piece of the gable wall between two curves over x, in metres of texture.
MeshData wallPiece(double x0, double x1, const std::function<double(double)>& low,
                   const std::function<double(double)>& high) {
  const int columns = std::max(2, static_cast<int>(std::ceil((x1 - x0) / 0.1)));
  const int rows = std::max(2, static_cast<int>(std::ceil((high(x0) - low(x0)) / kCell)));
  MeshData mesh = room::surface(columns, rows, [&](double u, double v) {
    // Denser at both ends, where arches are steep.
    const double x = glm::mix(x0, x1, 0.5 - 0.5 * std::cos(glm::pi<double>() * std::clamp(u, 0.0, 1.0)));
    return dvec3(x, glm::mix(low(x), high(x), v), kRoomMin.z);
  });
  for (room::Vertex& v : mesh.vertices) {
    v.tangent = {1, 0, 0};  // where the columns are densest, differences are too small to tell
    v.bitangent = {0, 1, 0};
    v.normal = v.side = {0, 0, 1};
    v.uv = dvec2(v.position) / kAshlarExtent;
  }
  return mesh;
}

room::Texel cloth(double u, double v, dvec3 color) {
  room::Texel t;
  t.color = color * (0.95 + 0.12 * room::fractalNoise(u, v, 6, 6, 4, 651) +
                     0.04 * std::sin(u * 128 * glm::pi<double>()) * std::sin(v * 128 * glm::pi<double>()));
  return t;
}

// What a window throws into dusty air: its colors run together, smooth at the edges, with a margin.
room::Image softened(const GlazedLancet& window) {
  const Lancet& lancet = window.lancet;
  const double height = lancet.top() - lancet.sill;
  return room::generate(32, 64, 3, [&](double u, double v, float* out) {
    constexpr int kSamples = 8;
    dvec3 sum(0);
    for (int k = 0; k < kSamples * kSamples; ++k) {
      const dvec2 offset = (dvec2(k % kSamples, k / kSamples) + 0.5) / double{kSamples} - 0.5;
      const dvec2 p =
          ((dvec2(u, v) - 0.5) * kShaftMargin + 0.5) * dvec2(lancet.width, height) + offset * 0.22;
      if (lancet.inset(p.x - lancet.width / 2, p.y + lancet.sill) > 0) {
        sum += stainedGlass(lancet, p.x / lancet.width, p.y / height);
      }
    }
    for (int i = 0; i < 3; ++i) out[i] = static_cast<float>(sum[i] / (kSamples * kSamples));
  });
}

}  // namespace

Chapel::Chapel() {
  makeMaterials();
  addShell();
  addRoof();
  addColumns();
  addRoodBeam();
  addPews();
  addAltar();
  addLamp();
  addShafts();
  light();
}

void Chapel::makeMaterials() {
  ashlar_ = room::materialTexture(1024, ashlar);
  flagstones_ = room::materialTexture(1024, flagstones);
  wood_ = room::materialTexture(512, room::wood);
  darkWood_ = room::materialTexture(512, [](double u, double v) {
    room::Texel t = room::wood(u, v);
    t.color *= dvec3(0.52, 0.47, 0.44);
    return t;
  });
  brass_ = room::materialTexture(128, brass);
  iron_ = room::materialTexture(
      256, [](double u, double v) { return room::paintedMetal(u, v, dvec3(0.13, 0.13, 0.14)); });
  linen_ =
      room::materialTexture(256, [](double u, double v) { return cloth(u, v, dvec3(0.90, 0.87, 0.80)); });
  velvet_ =
      room::materialTexture(256, [](double u, double v) { return cloth(u, v, dvec3(0.55, 0.08, 0.09)); });
  for (const Lancet& lancet : kLancets) {
    GlazedLancet window{lancet, room::generate(256, 1024, 3, [&](double u, double v, float* out) {
                          const dvec3 color = stainedGlass(lancet, u, v);
                          for (int i = 0; i < 3; ++i) out[i] = static_cast<float>(color[i]);
                        })};
    glass_.push_back(room::makeTexture(window.glass, room::Filter::Mipmapped, GL_CLAMP_TO_EDGE));
    softGlass_.push_back(room::makeTexture(softened(window), room::Filter::Linear, GL_CLAMP_TO_EDGE));
    windows_.push_back(std::move(window));
  }
}

Part& Chapel::add(const room::Texture& texture, MeshData data, Surface surface) {
  Part& part = parts_.emplace_back();
  part.surface = surface;
  part.texture = &texture;
  part.data = std::move(data);
  return part;
}

void Chapel::addBlock(MeshData& mesh, dvec3 center, dvec3 size, int number) {
  mesh.append(
      room::box(size, 0.18, 1 / room::kWoodExtent, {room::hash(number, 1, 7), room::hash(number, 2, 7)}),
      glm::translate(glm::dmat4(1.0), center));
  blocks_.push_back({center, size * 0.5});
}

void Chapel::addShell() {
  const dvec3 size = kRoomMax - kRoomMin;
  const dvec3 x(size.x, 0, 0);
  const dvec3 y(0, kEaves, 0);
  const dvec3 z(0, 0, size.z);
  add(flagstones_, room::rectangle({kRoomMin.x, 0, kRoomMax.z}, x, -z, kCell, 1 / kFlagstoneExtent),
      Surface::Floor);
  MeshData stone;
  stone.append(room::rectangle({kRoomMin.x, 0, kRoomMax.z}, -z, y, kCell, 1 / kAshlarExtent));
  stone.append(room::rectangle({kRoomMax.x, 0, kRoomMin.z}, z, y, kCell, 1 / kAshlarExtent));
  // Not seen, but they take light away from the corners.
  const auto block = [this](const dvec3& low, const dvec3& high) {
    blocks_.push_back({(low + high) * 0.5, (high - low) * 0.5});
  };
  block({kRoomMin.x - 1, -1, kRoomMin.z}, {kRoomMin.x - 0.01, kEaves, kRoomMax.z});
  block({kRoomMax.x + 0.01, -1, kRoomMin.z}, {kRoomMax.x + 1, kEaves, kRoomMax.z});
  block({kRoomMin.x, -1, kRoomMin.z}, {kRoomMax.x, -0.01, kRoomMax.z});
  addGable(stone);
  MeshData frame;
  for (const GlazedLancet& window : windows_) addWindow(window, stone, frame);
  add(ashlar_, std::move(stone));
  add(ashlar_, std::move(frame));
}

void Chapel::addGable(MeshData& stone) {
  const auto floor = [](double) { return 0.0; };
  double from = kRoomMin.x;
  for (const Lancet& glass : kLancets) {
    const Lancet opening = openingOf(glass);
    const double left = opening.center - opening.width / 2;
    const double right = opening.center + opening.width / 2;
    stone.append(wallPiece(from, left, floor, gableAt));
    stone.append(wallPiece(left, right, floor, [&](double) { return opening.sill; }));
    stone.append(wallPiece(
        left, right, [&](double x) { return opening.archAt(x - opening.center); }, gableAt));
    from = right;
  }
  stone.append(wallPiece(from, kRoomMax.x, floor, gableAt));
}

void Chapel::addWindow(const GlazedLancet& window, MeshData& stone, MeshData& frame) {
  const Lancet& glass = window.lancet;
  const Lancet opening = openingOf(glass);
  std::vector<dvec3> path;
  for (int piece = 0; piece < 5; ++piece) {
    const bool arc = piece == 2 || piece == 3;
    stone.append(room::surface(arc ? 14 : 10, 3,
                               [&](double u, double v) {
                                 const double along = std::clamp(u, 0.0, 1.0);
                                 return dvec3(glm::mix(outline(opening, piece, along),
                                                       outline(glass, piece, along), v),
                                              kRoomMin.z - kGlassRecess * v);
                               },
                               {0.5, 0.15}));
    const int steps = arc ? 14 : 1;
    for (int i = 0; i < steps && piece > 0; ++i) {
      path.emplace_back(outline(opening, piece, static_cast<double>(i) / steps), kRoomMin.z);
    }
  }
  path.emplace_back(outline(opening, 4, 1.0), kRoomMin.z);
  frame.append(room::tube(path, 0.055, 0.02, 10, 1 / kAshlarExtent));

  Part& pane =
      add(glass_[static_cast<std::size_t>(&window - windows_.data())],
          room::surface(1, 1,
                        [&](double u, double v) {
                          return dvec3(glass.center + (u - 0.5) * glass.width,
                                       glm::mix(glass.sill, glass.top(), v), kRoomMin.z - kGlassRecess);
                        }),
          Surface::Glass);
  pane.colors.resize(pane.data.vertices.size(), glm::vec3(1));
}

// The dusty air that the sun shines through: slices of it, parallel to the windows.
void Chapel::addShafts() {
  for (const GlazedLancet& window : windows_) {
    const Lancet& glass = window.lancet;
    const dvec2 size = kShaftMargin * dvec2(glass.width, glass.top() - glass.sill);
    Part part;
    for (int i = 0; i < kShaftSlices; ++i) {
      const double along = (i + 0.5) / kShaftSlices;
      const dvec3 center = dvec3(glass.center, (glass.sill + glass.top()) / 2, kRoomMin.z - kGlassRecess) -
                           glm::normalize(kToSun) * (kShaftLength * along);
      part.data.append(room::surface(
          1, 1, [&](double u, double v) { return center + dvec3((dvec2(u, v) - 0.5) * size, 0); }));
      part.colors.resize(part.data.vertices.size(), glm::vec3(static_cast<float>(kDust * (1 - along))));
    }
    part.surface = Surface::Dust;
    part.texture = &softGlass_[static_cast<std::size_t>(&window - windows_.data())];
    parts_.push_back(std::move(part));
  }
}

glm::dmat4 Chapel::floorProjection() {
  const dvec3 size = kRoomMax - kRoomMin;
  glm::dmat4 m(0.0);
  m[0][0] = 1 / size.x;
  m[2][1] = 1 / size.z;
  m[3] = glm::dvec4(-kRoomMin.x / size.x, -kRoomMin.z / size.z, 0, 1);
  return m;
}

glm::dmat4 Chapel::lampAt(double time) {
  const double turn = glm::two_pi<double>() * time;
  glm::dmat4 m = glm::translate(glm::dmat4(1.0), kLampPivot);
  m = glm::rotate(m, 0.060 * std::sin(turn / 3.9), dvec3(0, 0, 1));
  m = glm::rotate(m, 0.025 * std::sin(turn / 3.9 + 0.9), dvec3(1, 0, 0));
  return glm::rotate(m, 0.5 * std::sin(turn / 31.0), dvec3(0, 1, 0));
}

void Chapel::light() {
  const Daylight daylight(windows_, kRoomMin.z - kGlassRecess, kToSun);
  const auto bake = [&](bool sky, bool sun) {
    room::LightBake light({2e-3, sky ? room::opennessByRays(1.3, 24) : nullptr, room::halfGamma});
    for (const room::Block& block : blocks_) light.add(block);
    if (sky) light.add([&](const auto& at, const auto& obstacles) { return daylight.sky(at, obstacles); });
    if (sun) light.add([&](const auto& at, const auto& obstacles) { return daylight.sun(at, obstacles); });
    return light;
  };
  const room::LightBake sky = bake(true, false);
  const room::LightBake skyAndSun = bake(true, true);
  for (Part& part : parts_) {
    if (part.colors.empty()) {
      const room::LightBake& light = part.surface == Surface::Solid ? skyAndSun : sky;
      part.colors = light.vertexLight(part.data, part.swings ? lampAt(0) : glm::dmat4(1.0));
    }
    part.mesh = std::make_unique<room::Mesh>(part.data, part.colors);
  }
  // Row 0 lies at the windows.
  const dvec3 size = kRoomMax - kRoomMin;
  const room::LightBake sun = bake(false, true);
  const room::Image onFloor =
      room::generate(kSunMapSize, kSunMapSize, 3, [&](double u, double v, float* out) {
        const glm::vec3 color =
            sun.halfLight({kRoomMin.x + u * size.x, 0, kRoomMin.z + v * size.z}, dvec3(0, 1, 0));
        for (int i = 0; i < 3; ++i) out[i] = color[i];
      });
  sunOnFloor_ = room::makeTexture(onFloor, room::Filter::Mipmapped, GL_CLAMP_TO_EDGE);
}

}  // namespace postprocessing
