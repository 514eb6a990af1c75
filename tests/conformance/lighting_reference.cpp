#include "lighting_reference.h"

#include <algorithm>

namespace conformance {

namespace {

struct Direction {
  Vec3 unit;
  double distance;
};

// P1P2 of 2.12.1: the unit vector from one homogeneous point to another.
Direction direction(const Vec4& from, const Vec4& to) {
  const Vec3 a = {from[0], from[1], from[2]}, b = {to[0], to[1], to[2]};
  if (to[3] == 0 && from[3] != 0) return {normalised(b), 0};
  if (to[3] != 0 && from[3] == 0) return {scaled(normalised(a), -1), 0};
  if (to[3] == 0) return {normalised(added(b, scaled(a, -1))), 0};
  const Vec3 difference = added(scaled(b, 1 / to[3]), scaled(a, -1 / from[3]));
  return {normalised(difference), length(difference)};
}

double raised(double base, double exponent) {
  return exponent == 0 ? 1 : std::pow(base, exponent);
}

double spot(const LightParameters& light, const Vec3& toLight) {
  if (light.spotCutoff == 180) return 1;
  const double cosine = std::max(dot(scaled(toLight, -1), normalised(light.spotDirection)), 0.0);
  // cos(90 degrees) is 0 and not the rounding error of pi / 2.
  const double edge = light.spotCutoff == 90 ? 0 : std::cos(light.spotCutoff * std::numbers::pi / 180);
  return cosine >= edge ? raised(cosine, light.spotExponent) : 0;
}

}  // namespace

Vec4 litColor(const MaterialParameters& material, const Vec4& sceneAmbient,
              std::span<const LightParameters> lights, const Vec4& vertex, const Vec3& normal) {
  Vec4 color = material.emission;
  for (std::size_t c = 0; c < 3; ++c) color[c] += material.ambient[c] * sceneAmbient[c];
  for (const LightParameters& light : lights) {
    const auto [toLight, distance] = direction(vertex, light.position);
    const double attenuation = light.position[3] != 0
                                   ? 1 / (light.constantAttenuation + light.linearAttenuation * distance +
                                          light.quadraticAttenuation * distance * distance)
                                   : 1;
    const double diffuse = std::max(dot(normal, toLight), 0.0);
    const Vec3 half = normalised(added(toLight, {0, 0, 1}));
    const double specular = diffuse != 0 ? raised(std::max(dot(normal, half), 0.0), material.shininess) : 0;
    const double factor = attenuation * spot(light, toLight);
    for (std::size_t c = 0; c < 3; ++c) {
      color[c] += factor *
                  (material.ambient[c] * light.ambient[c] + diffuse * material.diffuse[c] * light.diffuse[c] +
                   specular * material.specular[c] * light.specular[c]);
    }
  }
  color[3] = material.diffuse[3];
  return clamp01(color);
}

namespace {
std::array<GLfloat, 4> floats(const Vec4& v) {
  return {static_cast<GLfloat>(v[0]), static_cast<GLfloat>(v[1]), static_cast<GLfloat>(v[2]),
          static_cast<GLfloat>(v[3])};
}
}  // namespace

void applyLights(std::span<const LightParameters> lights) {
  for (std::size_t i = 0; i < 8; ++i) {
    const GLenum name = GL_LIGHT0 + static_cast<GLenum>(i);
    if (i >= lights.size()) {
      glDisable(name);
      continue;
    }
    const LightParameters& light = lights[i];
    glLightfv(name, GL_AMBIENT, floats(light.ambient).data());
    glLightfv(name, GL_DIFFUSE, floats(light.diffuse).data());
    glLightfv(name, GL_SPECULAR, floats(light.specular).data());
    glLightfv(name, GL_POSITION, floats(light.position).data());
    const Vec3& d = light.spotDirection;
    glLightfv(name, GL_SPOT_DIRECTION, floats({d[0], d[1], d[2], 0}).data());
    glLightf(name, GL_SPOT_EXPONENT, static_cast<GLfloat>(light.spotExponent));
    glLightf(name, GL_SPOT_CUTOFF, static_cast<GLfloat>(light.spotCutoff));
    glLightf(name, GL_CONSTANT_ATTENUATION, static_cast<GLfloat>(light.constantAttenuation));
    glLightf(name, GL_LINEAR_ATTENUATION, static_cast<GLfloat>(light.linearAttenuation));
    glLightf(name, GL_QUADRATIC_ATTENUATION, static_cast<GLfloat>(light.quadraticAttenuation));
    glEnable(name);
  }
}

void applyMaterial(const MaterialParameters& material) {
  glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, floats(material.ambient).data());
  glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, floats(material.diffuse).data());
  glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, floats(material.specular).data());
  glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, floats(material.emission).data());
  glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, static_cast<GLfloat>(material.shininess));
}

void applySceneAmbient(const Vec4& ambient) {
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, floats(ambient).data());
}

}  // namespace conformance
