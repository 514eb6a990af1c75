#include "scene.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "can.h"
#include "room/set/materials.h"

namespace lighting {
namespace {

constexpr glm::dvec3 kPendantPivot{0.1, 2.9, -0.55};
constexpr double kCordLength = 0.88;
constexpr glm::dvec3 kFixturePivot{-2.55, 2.42, 0.55};

// What little light there is without the lamps: bluish from above, warm back from the floor, less in corners.
glm::vec3 ambientAt(const glm::dvec3& p, const glm::dvec3& n) {
  double open = 1;
  for (int axis = 0; axis < 3; ++axis) {
    for (double distance : {p[axis] - kRoomMin[axis], kRoomMax[axis] - p[axis]}) {
      const bool ownPlane = std::abs(n[axis]) > 0.9 && distance < 0.02;
      if (!ownPlane) open *= 1 - 0.42 * std::exp(-std::max(distance, 0.0) / 0.30);
    }
  }
  const glm::dvec3 sky = glm::dvec3(0.23, 0.26, 0.36) * (0.75 + 0.25 * n.y);
  const double near = std::exp(-(p.x * p.x + p.y * p.y + (p.z + 0.6) * (p.z + 0.6)) / 9.0);
  const glm::dvec3 bounce = glm::dvec3(0.20, 0.13, 0.07) * near * (0.8 - 0.5 * n.y);
  return glm::vec3((sky + bounce) * open);
}

Material makeMaterial(const room::BakedTexels& texels, const room::Image& normals, NormalSpace space) {
  return {room::makeTexture(texels.color, room::Filter::Mipmapped, GL_REPEAT),
          room::makeTexture(normals, room::Filter::Mipmapped, GL_REPEAT),
          room::makeTexture(texels.gloss, room::Filter::Mipmapped, GL_REPEAT), space};
}

Material tangentMaterial(int width, int height, glm::dvec2 extent, const room::TexelFunction& texel) {
  const room::BakedTexels texels = room::bake(width, height, texel);
  return makeMaterial(texels, room::tangentNormals(texels.height, extent), NormalSpace::Tangent);
}

Material objectMaterial(int width, int height, const room::SurfaceFunction& surface,
                        const room::TexelFunction& texel) {
  const room::BakedTexels texels = room::bake(width, height, texel);
  return makeMaterial(texels, room::objectNormals(texels.height, surface), NormalSpace::Object);
}

}  // namespace

glm::dvec4 planeOf(Receiver receiver) {
  switch (receiver) {
    case Receiver::Floor:
      return {0, 1, 0, -kRoomMin.y};
    case Receiver::Back:
      return {0, 0, 1, -kRoomMin.z};
    case Receiver::Left:
      return {1, 0, 0, -kRoomMin.x};
    case Receiver::Right:
      return {-1, 0, 0, kRoomMax.x};
    case Receiver::None:
      break;
  }
  return glm::dvec4(0);
}

Scene::Scene() {
  makeMaterials();
  addShell();
  addSkirting();
  addCan();
  addCrates();
  addBench();
  addPipes();
  addPoster();
  addPaper();
  addLamps();
  animate(0);
  for (Part& part : parts_) {
    if (part.mesh) continue;
    std::vector<glm::vec3> ambient;
    ambient.reserve(part.data.vertices.size());
    for (const room::Vertex& v : part.data.vertices) {
      ambient.push_back(
          ambientAt(glm::dvec3(part.model * glm::dvec4(v.position, 1.0)), glm::dmat3(part.model) * v.normal));
    }
    part.mesh = std::make_unique<room::Mesh>(part.data, ambient);
  }
}

void Scene::makeMaterials() {
  using glm::dvec2;
  using glm::dvec3;
  const auto square = [](double extent) { return dvec2(extent); };
  brick_ = tangentMaterial(1024, 1024, square(room::kBrickExtent), room::brick);
  tiles_ = tangentMaterial(1024, 1024, square(room::kTileExtent), room::checkerTiles);
  plaster_ = tangentMaterial(512, 512, square(room::kPlasterExtent), room::plaster);
  wood_ = tangentMaterial(512, 512, square(room::kWoodExtent), room::wood);
  paintedWood_ = tangentMaterial(512, 512, square(room::kWoodExtent), [](double u, double v) {
    return room::paintedWood(u, v, dvec3(0.20, 0.33, 0.31));
  });
  pipePaint_ = tangentMaterial(256, 256, square(room::kMetalExtent), [](double u, double v) {
    return room::paintedMetal(u, v, dvec3(0.40, 0.42, 0.40));
  });
  enamel_ = tangentMaterial(256, 256, square(room::kMetalExtent), [](double u, double v) {
    return room::paintedMetal(u, v, dvec3(0.10, 0.27, 0.21));
  });
  iron_ = tangentMaterial(256, 256, square(room::kMetalExtent), [](double u, double v) {
    return room::paintedMetal(u, v, dvec3(0.13, 0.13, 0.14));
  });
  paper_ = tangentMaterial(128, 128, square(room::kPaperExtent), room::paper);
  poster_ = tangentMaterial(512, 512, dvec2(0.84, 1.2), room::poster);
  can_ = objectMaterial(1024, 1024, canSurface(), canTexel);
  lid_ = objectMaterial(512, 512, lidSurface(), lidTexel);
}

Part& Scene::add(const Material& material, room::MeshData data, const Options& options) {
  Part& part = parts_.emplace_back();
  part.material = &material;
  part.receiver = options.receiver;
  part.castsFor = options.castsFor;
  part.shine = options.shine;
  part.data = std::move(data);
  glm::dvec3 low(1e9);
  glm::dvec3 high(-1e9);
  for (const room::Vertex& v : part.data.vertices) {
    low = glm::min(low, v.position);
    high = glm::max(high, v.position);
  }
  part.center = (low + high) * 0.5;
  part.radius = glm::distance(low, high) * 0.5;
  return part;
}

Part& Scene::addGlowing(room::MeshData data, glm::vec3 color) {
  Part& part = parts_.emplace_back();
  part.mesh = std::make_unique<room::Mesh>(data, color);
  part.data = std::move(data);
  return part;
}

// A swinging lamp, warm, and a stage light in the corner, cold, that wanders over the scene.
void Scene::animate(double time) {
  const double turn = glm::two_pi<double>() * time;
  const double swingX = 0.20 * std::sin(turn / 5.2);
  const double swingZ = 0.13 * std::sin(turn / 5.2 + 1.3);
  glm::dmat4 pendant = glm::translate(glm::dmat4(1.0), kPendantPivot);
  pendant = glm::rotate(pendant, swingZ, glm::dvec3(1, 0, 0));
  pendant = glm::rotate(pendant, swingX, glm::dvec3(0, 0, 1));
  pendant = glm::translate(pendant, glm::dvec3(0, -kCordLength, 0));
  for (std::size_t i : pendant_) parts_[i].model = pendant;

  Spotlight& warm = lights_[0];
  warm.position = glm::dvec3(pendant[3]);
  warm.direction = -glm::dvec3(pendant[1]);
  warm.up = glm::dvec3(pendant[2]);
  warm.color = {1.12, 0.86, 0.54};
  warm.halfAngle = glm::radians(62.0);
  warm.near = 0.06;
  warm.range = 6.0;
  warm.reach = 3.6;

  const glm::dvec3 aim(0.55 + 1.05 * std::sin(turn / 12.5 + 0.2), 0.95 + 0.35 * std::sin(turn / 8.3), -1.7);
  Spotlight& cold = lights_[1];
  const glm::dvec3 direction = glm::normalize(aim - kFixturePivot);
  cold.position = kFixturePivot + direction * 0.12;
  cold.direction = direction;
  cold.up = {0, 1, 0};
  cold.color = {0.62, 0.98, 1.55};
  cold.beam = 0.13;
  cold.halfAngle = glm::radians(20.0);
  cold.near = 0.12;
  cold.range = 9.0;
  cold.reach = 9.0;

  const glm::dvec3 right = glm::normalize(glm::cross(direction, glm::dvec3(0, 1, 0)));
  glm::dmat4 fixture(1.0);
  fixture[0] = glm::dvec4(-right, 0);
  fixture[1] = glm::dvec4(glm::cross(right, direction), 0);
  fixture[2] = glm::dvec4(direction, 0);
  fixture[3] = glm::dvec4(kFixturePivot, 1);
  for (std::size_t i : fixture_) parts_[i].model = fixture;
}

}  // namespace lighting
