#include "light_vectors.h"

#include <algorithm>

#include "room/transform.h"

namespace lighting {
namespace {

// The light vector, rotated into the vertex's T,B,N frame.
glm::vec4 lightVector(const Spotlight& light, const glm::dvec3& toLight, const room::Vertex& v) {
  const double distance = std::max(glm::length(toLight), 1e-6);
  const glm::dvec3 tangentSpace =
      glm::dvec3(glm::dot(v.tangent, toLight), glm::dot(v.bitangent, toLight), glm::dot(v.normal, toLight)) /
      distance;
  // Bumps must not catch light that comes from behind the surface.
  const double front = std::min(tangentSpace.z, glm::dot(v.side, toLight) / distance);
  const double facing = std::clamp(front * 6.0 + 0.5, 0.0, 1.0);
  return {glm::vec3(tangentSpace * 0.5 + 0.5), static_cast<float>(light.attenuation(distance) * facing)};
}

}  // namespace

void LightVectors::update(const Spotlight& light, bool inCone) {
  parts_.clear();
  for (std::size_t i = 0; i < colors_.size(); ++i) {
    const Part& part = scene_.parts()[i];
    if (part.material == nullptr) continue;
    if (inCone && !light.reaches(centerOf(part), part.radius)) continue;
    parts_.push_back({&part, &colors_[i]});
    if (part.material->space != NormalSpace::Tangent) continue;
    const glm::dvec3 lamp(glm::inverse(part.model) * glm::dvec4(light.position, 1.0));
    colors_[i].clear();
    for (const room::Vertex& v : part.data.vertices) {
      colors_[i].push_back(lightVector(light, lamp - v.position, v));
    }
  }
}

glm::dvec3 centerOf(const Part& part) {
  return glm::dvec3(part.model * glm::dvec4(part.center, 1.0));
}

void place(const Part& part, const glm::dmat4& view) {
  room::loadMatrix(view * part.model);
}

}  // namespace lighting
