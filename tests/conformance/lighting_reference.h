// The lighting equation of section 2.12.1 in float64, term by term as the text prints it.
#pragma once

#include <span>

#include "reference_math.h"

namespace conformance {

struct LightParameters {
  Vec4 ambient = {0, 0, 0, 1}, diffuse = {0, 0, 0, 1}, specular = {0, 0, 0, 1};
  Vec4 position = {0, 0, 1, 0};
  Vec3 spotDirection = {0, 0, -1};
  double spotExponent = 0, spotCutoff = 180;
  double constantAttenuation = 1, linearAttenuation = 0, quadraticAttenuation = 0;
};

struct MaterialParameters {
  Vec4 ambient = {0.2, 0.2, 0.2, 1}, diffuse = {0.8, 0.8, 0.8, 1}, specular = {0, 0, 0, 1},
       emission = {0, 0, 0, 1};
  double shininess = 0;
};

// Light positions and directions, the vertex and the normal all in eye coordinates; the result clamped
// (2.12.5).
Vec4 litColor(const MaterialParameters& material, const Vec4& sceneAmbient,
              std::span<const LightParameters> lights, const Vec4& vertex, const Vec3& normal);

// Sets the same in the current context, light by light from LIGHT0, and enables them.
void applyLights(std::span<const LightParameters> lights);
void applyMaterial(const MaterialParameters& material);
void applySceneAmbient(const Vec4& ambient);

}  // namespace conformance
