// What stands in the atrium.
#include "room/set/furniture.h"

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "atrium.h"
#include "room/noise.h"

namespace water {
namespace {

using glm::dmat4;
using glm::dvec2;
using glm::dvec3;
using room::MeshData;
using room::placed;

MeshData block(const dvec3& center, const dvec3& size, double turn = 0) {
  MeshData mesh;
  mesh.append(room::box(size, 0.25, 0.9, {center.x * 0.37, center.z * 0.21}), placed(center, turn));
  return mesh;
}

// A pointed blade from the origin outwards along x and then up, or, with a negative lift, down at its end.
MeshData blade(double length, double width, double rise, double droop) {
  return room::surface(5, 10, [=](double u, double v) {
    const double along = std::clamp(v, 0.0, 1.0);
    const double half =
        width / 2 * std::pow(std::sin(glm::pi<double>() * std::pow(0.12 + 0.88 * along, 0.8)), 0.8);
    const double side = 1 - 2 * u;
    const double height = rise * along - droop * along * along + 0.35 * std::abs(side) * half;
    return dvec3(length * along, height, side * half);
  });
}

// Blades all around, the inner ones steeper.
MeshData rosette(int blades, double length, double width, double steepest, double droop, int seed) {
  MeshData mesh;
  for (int i = 0; i < blades; ++i) {
    const double inner = static_cast<double>(i) / blades;
    const double random = room::hash(i, seed, 910);
    const double reach = length * (1 - 0.45 * inner) * (0.9 + 0.2 * random);
    const double rise = length * (0.25 + steepest * inner) * (0.9 + 0.2 * random);
    mesh.append(blade(reach, width * (1 - 0.3 * inner), rise, droop * length * (1 - inner)),
                placed({0, 0, 0}, i * 2.39996 + 0.3 * random));
  }
  return mesh;
}

}  // namespace

void Atrium::addColumns() {
  const std::vector<dvec2> base = {{0.30, 0.08},  {0.315, 0.115}, {0.30, 0.15},
                                   {0.26, 0.165}, {0.25, 0.19},   {0.24, 0.20}};
  const std::vector<dvec2> lower = {{0.235, 0.19}, {0.232, 0.7}, {0.226, 1.32}};
  const std::vector<dvec2> band = {{0.226, 1.32}, {0.245, 1.335}, {0.245, 1.365}, {0.224, 1.38}};
  const std::vector<dvec2> upper = {{0.222, 1.38}, {0.212, 2.6},  {0.195, 3.60}, {0.215, 3.62}, {0.215, 3.66},
                                    {0.195, 3.68}, {0.195, 3.78}, {0.27, 3.88},  {0.30, 3.90}};
  for (double z : {kColumnZ.x, kColumnZ.y}) {
    for (double x : {-kColumnX, kColumnX}) {
      const dmat4 where = placed({x, 0, z});
      redMesh_.append(room::lathe(lower, 32, 16, {2, 1.5}), where);
      whiteMesh_.append(room::lathe(band, 32, 8, {2, 0.1}), where);
      whiteMesh_.append(room::lathe(upper, 32, 40, {2, 3}), where);
      marbleMesh_.append(room::lathe(base, 32, 12, {2, 0.3}), where);
      marbleMesh_.append(block({x, 0.04, z}, {0.66, 0.08, 0.66}));
      whiteMesh_.append(block({x, 3.95, z}, {0.64, 0.10, 0.64}));
      light_.add(room::UprightCylinder{{x, 0.01, z}, 0.20, 3.9});
      light_.add(room::Block{{x, 0.04, z}, {0.31, 0.035, 0.31}});
    }
  }
}

// A low kerb of marble about the pool.
void Atrium::addRim() {
  constexpr double kWide = 0.26;
  constexpr double kHigh = 0.07;
  const dvec2 half = kPoolHalf + kWide / 2;
  for (double side : {-1.0, 1.0}) {
    for (int i = 0; i < 3; ++i) {
      const double length = 2 * (kPoolHalf.x + kWide) / 3;
      const double along = (i - 1) * length;
      marbleMesh_.append(block({kPoolCenter.x + along, kHigh / 2, kPoolCenter.y + side * half.y},
                               {length - 0.006, kHigh, kWide}));
      const double inner = 2 * kPoolHalf.y / 3;
      marbleMesh_.append(block({kPoolCenter.x + side * half.x, kHigh / 2, kPoolCenter.y + (i - 1) * inner},
                               {kWide, kHigh, inner - 0.006}));
    }
    light_.add(room::Block{{kPoolCenter.x, kHigh / 2, kPoolCenter.y + side * half.y},
                           {half.x + kWide / 2 - 0.01, kHigh / 2 - 0.01, kWide / 2 - 0.01}});
    light_.add(room::Block{{kPoolCenter.x + side * half.x, kHigh / 2, kPoolCenter.y},
                           {kWide / 2 - 0.01, kHigh / 2 - 0.01, half.y}});
  }
}

void Atrium::addRoofBeams() {
  const dvec3 size = kRoomMax - kRoomMin;
  const double middleZ = (kRoomMin.z + kRoomMax.z) / 2;
  int number = 0;
  const auto beam = [&](const dvec3& center, const dvec3& extent) {
    MeshData mesh;
    mesh.append(room::board(extent, ++number), placed(center));
    woodMesh_.append(mesh);
    light_.add(room::Block{center, extent * 0.5 - 0.012});
  };
  // The great beams rest on the columns, the lesser ones on them.
  for (double z : {kColumnZ.x, kColumnZ.y}) beam({0, 4.13, z}, {size.x, 0.26, 0.26});
  for (double x : {-kColumnX, kColumnX}) beam({x, 4.13, middleZ}, {0.24, 0.24, size.z});
  for (int i = 0; i < 9; ++i) {
    const double x = kRoomMin.x + size.x * (i + 0.5) / 9;
    if (std::abs(std::abs(x) - kColumnX) < 0.3) continue;
    const double back = kRoomMin.z;
    beam({x, 4.22, (back + kColumnZ.x) / 2}, {0.14, 0.16, kColumnZ.x - back});
    beam({x, 4.22, (kColumnZ.y + kRoomMax.z) / 2}, {0.14, 0.16, kRoomMax.z - kColumnZ.y});
  }
  // The inside of the opening.
  const double y = kRoomMax.y + 0.16;
  for (double side : {-1.0, 1.0}) {
    whiteMesh_.append(block({kPoolCenter.x, y, kPoolCenter.y + side * (kPoolHalf.y + 0.06)},
                            {2 * kPoolHalf.x + 0.24, 0.44, 0.12}));
    whiteMesh_.append(block({kPoolCenter.x + side * (kPoolHalf.x + 0.06), y, kPoolCenter.y},
                            {0.12, 0.44, 2 * kPoolHalf.y}));
  }
}

// A marble bowl on a pillar, where the sun reaches the wall.
void Atrium::addUrn() {
  const dvec3 stand(1.05, 0, -4.05);
  marbleMesh_.append(block(stand + dvec3(0, 0.06, 0), {0.62, 0.12, 0.62}));
  marbleMesh_.append(block(stand + dvec3(0, 0.50, 0), {0.46, 0.76, 0.46}));
  marbleMesh_.append(block(stand + dvec3(0, 0.91, 0), {0.58, 0.06, 0.58}));
  const std::vector<dvec2> bowl = {{0.17, 0.0},  {0.17, 0.04},  {0.07, 0.08},  {0.055, 0.14}, {0.09, 0.18},
                                   {0.20, 0.25}, {0.26, 0.36},  {0.235, 0.50}, {0.225, 0.58}, {0.29, 0.66},
                                   {0.30, 0.68}, {0.275, 0.68}, {0.19, 0.60},  {0.0, 0.55}};
  marbleMesh_.append(room::lathe(bowl, 40, 48, {2, 1}), placed(stand + dvec3(0, 0.94, 0)));
  for (double side : {-1.0, 1.0}) {
    const std::vector<dvec3> handle = {
        {side * 0.24, 1.26, 0}, {side * 0.37, 1.30, 0}, {side * 0.36, 1.52, 0}, {side * 0.25, 1.58, 0}};
    marbleMesh_.append(room::tube(handle, 0.022, 0.05, 12, 2), placed({stand.x, 0, stand.z}));
  }
  light_.add(room::Block{stand + dvec3(0, 0.45, 0), {0.22, 0.44, 0.22}});
  light_.add(room::UprightCylinder{stand + dvec3(0, 1.20, 0), 0.23, 0.40});
}

// Agaves in pots.
void Atrium::addPlants() {
  const std::vector<dvec2> pot = {{0.17, 0.0},  {0.20, 0.04},  {0.27, 0.34}, {0.27, 0.37}, {0.31, 0.38},
                                  {0.31, 0.45}, {0.275, 0.45}, {0.26, 0.40}, {0.0, 0.39}};
  int seed = 0;
  for (const dvec3& stand :
       {dvec3(-3.35, 0, -0.15), dvec3(-0.85, 0, -4.0), dvec3(3.45, 0, -3.75), dvec3(-2.5, 0, 3.35)}) {
    const double size = 0.85 + 0.3 * room::hash(seed, 1, 911);
    const dmat4 where = glm::scale(placed(stand, seed * 1.3), dvec3(size));
    clayMesh_.append(room::lathe(pot, 32, 24, {2, 1}), placed(stand));
    leafMesh_.append(rosette(22, 0.72, 0.16, 1.25, 0.45, ++seed),
                     glm::translate(where, dvec3(0, 0.40 / size, 0)));
    light_.add(room::UprightCylinder{stand, 0.16, 0.40});
    light_.add(room::UprightCylinder{stand + dvec3(0, 0.50, 0), 0.10, 0.25});
  }
  // Scaling has made the normals long.
  for (room::Vertex& v : leafMesh_.vertices) v.normal = glm::normalize(v.normal);
}

void Atrium::addAmphorae() {
  const std::vector<dvec2> body = {{0.03, 0.0},   {0.035, 0.05}, {0.07, 0.14},  {0.155, 0.36}, {0.20, 0.60},
                                   {0.17, 0.78},  {0.085, 0.88}, {0.065, 0.94}, {0.065, 1.06}, {0.085, 1.09},
                                   {0.085, 1.12}, {0.055, 1.12}, {0.05, 0.95},  {0.0, 0.93}};
  MeshData amphora = room::lathe(body, 32, 48, {2, 2});
  for (double side : {-1.0, 1.0}) {
    amphora.append(room::tube({{side * 0.06, 1.04, 0}, {side * 0.17, 1.05, 0}, {side * 0.165, 0.76, 0}},
                              0.016, 0.06, 10, 2));
  }
  const auto lean = [&](const dvec3& foot, double turn, double tilt) {
    clayMesh_.append(amphora, glm::rotate(placed(foot, turn), tilt, dvec3(0, 0, 1)));
    // Where the body is widest; more would stick out of it, and its own light would end there.
    light_.add(room::UprightCylinder{foot + dvec3(0.13 * std::cos(turn), 0.36, -0.13 * std::sin(turn)), 0.105,
                                     0.36});
  };
  // Against the wall on the right.
  lean({3.78, 0, -1.35}, 0.0, -0.24);
  lean({3.82, 0, -0.82}, 0.25, -0.22);
  lean({3.80, 0, -0.25}, -0.2, -0.25);
  // One lies where it fell.
  clayMesh_.append(amphora, glm::rotate(placed({2.95, 0.20, 1.1}, 2.5), glm::radians(-86.0), dvec3(0, 0, 1)));
  const auto inside = [this](double along, const dvec3& half) {
    const dvec3 axis(std::cos(2.5), 0, -std::sin(2.5));
    light_.add(room::Block{dvec3(2.95, 0.20 + 0.07 * along, 1.1) + axis * along, half, 2.5});
  };
  inside(0.34, {0.07, 0.06, 0.06});
  inside(0.60, {0.17, 0.11, 0.11});
}

void Atrium::addBench() {
  const dvec3 middle(-3.85, 0, -2.1);
  marbleMesh_.append(block(middle + dvec3(0, 0.43, 0), {0.48, 0.09, 1.9}));
  light_.add(room::Block{middle + dvec3(0, 0.43, 0), {0.23, 0.04, 0.94}});
  for (double z : {-0.7, 0.7}) {
    marbleMesh_.append(block(middle + dvec3(0, 0.19, z), {0.38, 0.38, 0.16}));
    light_.add(room::Block{middle + dvec3(0, 0.19, z), {0.18, 0.18, 0.07}});
  }
  // A folded cloak.
  clothMesh_.append(block(middle + dvec3(0.02, 0.505, 0.45), {0.40, 0.06, 0.5}, 0.1));
  clothMesh_.append(block(middle + dvec3(0.01, 0.55, 0.43), {0.36, 0.04, 0.44}, 0.02));
}

// A tall bronze stand with three oil lamps in the dark corner.
void Atrium::addLampStand() {
  const dvec3 stand(-1.95, 0, -4.1);
  const std::vector<dvec2> shaft = {{0.20, 0.0},   {0.20, 0.03},  {0.05, 0.08}, {0.025, 0.14}, {0.04, 0.24},
                                    {0.022, 0.30}, {0.018, 1.35}, {0.05, 1.40}, {0.02, 1.46},  {0.03, 1.50},
                                    {0.17, 1.54},  {0.17, 1.56},  {0.0, 1.56}};
  bronzeMesh_.append(room::lathe(shaft, 28, 60, {1, 2}), placed(stand));
  const std::vector<dvec2> lamp = {{0.0, 0.0}, {0.045, 0.005}, {0.055, 0.03}, {0.04, 0.05}, {0.0, 0.052}};
  const std::vector<dvec2> flame = {{0.0, 0.0},     {0.013, 0.008}, {0.019, 0.028},
                                    {0.014, 0.052}, {0.006, 0.078}, {0.0, 0.096}};
  for (int i = 0; i < 3; ++i) {
    const double angle = i * glm::two_pi<double>() / 3 + 0.5;
    const dvec3 where = stand + dvec3(0.10 * std::cos(angle), 1.56, 0.10 * std::sin(angle));
    bronzeMesh_.append(room::lathe(lamp, 20, 12), placed(where));
    flameMesh_.append(room::lathe(flame, 12, 12),
                      placed(where + dvec3(0.03 * std::cos(angle), 0.045, 0.03 * std::sin(angle))));
  }
  light_.add(room::Lamp{stand + dvec3(0, 1.74, 0.05), 0.12, {1.25, 0.66, 0.24}});
  light_.add(room::UprightCylinder{stand + dvec3(0, 0.01, 0), 0.02, 1.5});
  light_.add(room::UprightCylinder{stand + dvec3(0, 1.52, 0), 0.15, 0.03});
}

void Atrium::addLily() {
  MeshData leaves;
  const auto pad = [](double radius) {
    return room::surface(24, 3, [=](double u, double v) {
      const double angle = -(0.05 + 0.90 * u) * glm::two_pi<double>();
      const double r = radius * (1 - v);
      return dvec3(r * std::cos(angle), 0.006 + 0.02 * (1 - v) * (1 - v), r * std::sin(angle));
    });
  };
  leaves.append(pad(0.17), placed({0.13, 0, 0.05}));
  leaves.append(pad(0.13), placed({-0.14, 0, 0.10}, 2.0));
  leaves.append(pad(0.11), placed({-0.02, 0, -0.17}, 4.0));
  MeshData petals;
  petals.append(rosette(22, 0.15, 0.062, 1.0, 0.10, 40), placed({0, 0.012, 0}));
  const dvec3 middle(kPoolCenter.x, 0, kPoolCenter.y);
  const auto lit = [&](const MeshData& mesh) {
    std::vector<glm::vec3> light;
    for (const room::Vertex& v : mesh.vertices)
      light.push_back(light_.halfLight(v.position + middle, v.normal));
    return std::make_unique<room::Mesh>(mesh, light);
  };
  lilyLeaves_ = lit(leaves);
  lilyPetals_ = lit(petals);
}

}  // namespace water
