#include "tests/reference/vertex_processing.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "layer/render/renderer.h"

namespace anteroom::reference {

using gen::kMaxClipPlanes;
using gen::kMaxTextureUnits;

namespace {

// The unit vector in v's direction; the zero vector for a zero (or not finite) one. Scaled first, so that
// neither 10^-200 nor 10^200 is lost.
glm::dvec3 unit(const glm::dvec3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(largest > 0) || !std::isfinite(largest)) return glm::dvec3(0);
  const glm::dvec3 scaled = v / largest;
  return scaled / glm::length(scaled);
}

// The product of section 2.12.1: never negative.
double dot0(const glm::dvec3& a, const glm::dvec3& b) {
  return std::max(glm::dot(a, b), 0.0);
}

// 0^0 = 1 (section 2.1.1).
double power(double base, double exponent) {
  return exponent == 0 ? 1.0 : std::pow(base, exponent);
}

glm::dvec3 rgb(const glm::vec4& color) {
  return glm::dvec3(color);
}

template <typename T>
double element(const std::byte* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return static_cast<double>(value);
}

size_t sizeOf(GLenum type) {
  switch (type) {
    case GL_BYTE:
    case GL_UNSIGNED_BYTE:
      return 1;
    case GL_SHORT:
    case GL_UNSIGNED_SHORT:
      return 2;
    default:
      return 4;
  }
}

// Table 2.7 where the attribute is a color or a normal; as it is elsewhere.
double component(GLenum type, const std::byte* at, bool normalised) {
  switch (type) {
    case GL_BYTE:
      return normalised ? (2 * element<int8_t>(at) + 1) / 255 : element<int8_t>(at);
    case GL_UNSIGNED_BYTE:
      return normalised ? element<uint8_t>(at) / 255 : element<uint8_t>(at);
    case GL_SHORT:
      return normalised ? (2 * element<int16_t>(at) + 1) / 65535 : element<int16_t>(at);
    case GL_UNSIGNED_SHORT:
      return normalised ? element<uint16_t>(at) / 65535 : element<uint16_t>(at);
    case GL_FIXED:
      return element<int32_t>(at) / 65536;
    default:
      return element<float>(at);
  }
}

// Section 2.10.3. Of a singular matrix the cofactors give the direction, which is all that NORMALIZE needs.
glm::dmat3 normalMatrix(const glm::dmat4& matrix, bool rescale) {
  const glm::dmat3 m(matrix);
  const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
  const double determinant = glm::dot(m[0], cofactors[0]);
  const bool invertible = std::isnormal(determinant) && std::isfinite(1 / determinant);
  const glm::dmat3 result = invertible ? cofactors * (1 / determinant) : cofactors;
  if (!rescale) return result;
  // The third row of the inverse is the third column of its transpose.
  const double length = glm::length(result[2]);
  return length > 0 && std::isfinite(1 / length) ? result * (1 / length) : result;
}

// NaN becomes 0.
glm::dvec4 clampColor(const glm::dvec4& c) {
  glm::dvec4 result;
  for (int i = 0; i < 4; ++i) result[i] = c[i] > 0 ? std::min(c[i], 1.0) : 0.0;
  return result;
}

}  // namespace

Vertex mix(const Vertex& a, const Vertex& b, double t) {
  Vertex result;
  const auto between = [t](const auto& x, const auto& y) { return x * (1 - t) + y * t; };
  result.clip = between(a.clip, b.clip);
  result.front = between(a.front, b.front);
  result.back = between(a.back, b.back);
  for (size_t i = 0; i < kMaxTextureUnits; ++i) result.texCoord[i] = between(a.texCoord[i], b.texCoord[i]);
  for (size_t i = 0; i < kMaxClipPlanes; ++i)
    result.planeDistance[i] = between(a.planeDistance[i], b.planeDistance[i]);
  result.fogDistance = between(a.fogDistance, b.fogDistance);
  result.pointSize = between(a.pointSize, b.pointSize);
  return result;
}

VertexStage::VertexStage(const render::State& state) : state_(state) {
  const bool rescale = state.fixed.lighting.rescaleNormal;
  normalMatrix_ = normalMatrix(state.fixed.modelview, rescale);
  if (!state.fixed.palette) return;
  for (const glm::dmat4& matrix : state.fixed.palette->matrices)
    paletteNormals_.push_back(normalMatrix(matrix, rescale));
}

glm::dvec4 VertexStage::attribute(gen::Attribute which, int64_t index) const {
  const gen::AttributeState& attribute = state_.fixed.attributes[which];
  if (!attribute.array) return attribute.current;
  const render::VertexArray& array = state_.arrays[which];
  const size_t size = sizeOf(attribute.type);
  const uint64_t offset = static_cast<uint64_t>(index) * array.stride;
  const std::byte* base = nullptr;
  if (array.buffer != nullptr) {
    const uint64_t start = reinterpret_cast<uintptr_t>(array.pointer), total = array.buffer->size();
    const uint64_t needed = size * static_cast<size_t>(attribute.size);
    // Sums of what a program may pass could wrap around.
    if (needed > total || offset > total - needed || start > total - needed - offset) return {0, 0, 0, 1};
    base = array.buffer->contents() + start + offset;
  } else {
    base = static_cast<const std::byte*>(array.pointer) + offset;
  }
  const bool normalised = which == gen::kColor || which == gen::kNormal;
  glm::dvec4 value(0, 0, 0, 1);
  for (int i = 0; i < attribute.size; ++i)
    value[i] = component(attribute.type, base + static_cast<size_t>(i) * size, normalised);
  return value;
}

// OES_matrix_palette: a vertex's weighted matrices, term by term. Missing weights are 0, and indices beyond
// the palette name its last matrix.
template <class Term>
void VertexStage::blend(int64_t index, Term term) const {
  const auto& attributes = state_.fixed.attributes;
  const glm::dvec4 indices = attribute(gen::kMatrixIndex, index), weights = attribute(gen::kWeight, index);
  const int units = std::min(attributes[gen::kMatrixIndex].size, attributes[gen::kWeight].size);
  for (int i = 0; i < units; ++i)
    term(weights[i], std::min(static_cast<size_t>(indices[i]), size_t{gen::kPaletteMatrices - 1}));
}

glm::dvec4 VertexStage::eyePosition(int64_t index) const {
  const glm::dvec4 position = attribute(gen::kPosition, index);
  const gen::Palette* palette = state_.fixed.palette;
  if (!palette) return state_.fixed.modelview * position;
  glm::dvec4 sum(0);
  blend(index, [&](double weight, size_t i) { sum += weight * (palette->matrices[i] * position); });
  return sum;
}

glm::dvec3 VertexStage::eyeNormal(int64_t index) const {
  const glm::dvec3 normal(attribute(gen::kNormal, index));
  glm::dvec3 transformed(0);
  if (state_.fixed.palette)
    blend(index, [&](double weight, size_t i) { transformed += weight * (paletteNormals_[i] * normal); });
  else
    transformed = normalMatrix_ * normal;
  return state_.fixed.lighting.normalize ? unit(transformed) : transformed;
}

// Equation 2.1 and what follows it.
glm::dvec4 VertexStage::light(const glm::dvec4& eye, const glm::dvec3& normal,
                              const glm::dvec4& color) const {
  const gen::Lighting& lighting = state_.fixed.lighting;
  const gen::Material& material = lighting.material;
  const glm::dvec4 diffuse = lighting.colorMaterial ? color : glm::dvec4(material.diffuse);
  const glm::dvec3 ambient = lighting.colorMaterial ? glm::dvec3(color) : rgb(material.ambient);
  const glm::dvec3 position = eye.w != 0 ? glm::dvec3(eye) / eye.w : glm::dvec3(eye);

  glm::dvec3 sum = rgb(material.emission) + ambient * rgb(lighting.modelAmbient);
  for (const gen::Light& light : lighting.lights) {
    if (!light.enabled) continue;
    const bool positional = light.position.w != 0;
    const glm::dvec3 toLight =
        positional ? glm::dvec3(light.position) / light.position.w - position : glm::dvec3(light.position);
    const glm::dvec3 direction = unit(toLight);
    double strength = 1;
    if (positional) {
      const double d = glm::length(toLight);
      const double denominator =
          double(light.attenuation.x) + light.attenuation.y * d + light.attenuation.z * d * d;
      if (denominator > 0) strength = 1 / denominator;
    }
    if (light.spotCutoff != 180) {
      const double cosine = dot0(-direction, unit(light.spotDirection));
      const double limit = light.spotCutoff == 90 ? 0.0 : std::cos(light.spotCutoff * (M_PI / 180));
      strength *= cosine >= limit ? power(cosine, light.spotExponent) : 0.0;
    }
    const double nDotL = dot0(normal, direction);
    glm::dvec3 term = ambient * rgb(light.ambient) + nDotL * glm::dvec3(diffuse) * rgb(light.diffuse);
    if (nDotL != 0) {
      const glm::dvec3 half = unit(direction + glm::dvec3(0, 0, 1));
      term += power(dot0(normal, half), material.shininess) * rgb(material.specular) * rgb(light.specular);
    }
    if (strength != 0) sum += strength * term;
  }
  return {sum, diffuse.a};
}

glm::dvec4 VertexStage::textureCoordinate(int unitIndex, int64_t index, const glm::dvec4& eye,
                                          const glm::dvec3& normal) const {
  const gen::TextureUnit& unitState = state_.fixed.units[static_cast<size_t>(unitIndex)];
  glm::dvec4 coordinate = attribute(gen::texCoord(unitIndex), index);
  if (unitState.texGen) {  // OES_texture_cube_map: s, t and r
    glm::dvec3 generated = normal;
    if (unitState.texGenMode == GL_REFLECTION_MAP_OES) {
      const glm::dvec3 u = unit(eye.w != 0 ? glm::dvec3(eye) / eye.w : glm::dvec3(eye));
      generated = u - 2.0 * glm::dot(normal, u) * normal;
    }
    coordinate = glm::dvec4(generated, coordinate.w);
  }
  return unitState.matrix * coordinate;
}

Vertex VertexStage::process(int64_t index) const {
  const gen::State& fixed = state_.fixed;
  Vertex vertex;
  const glm::dvec4 eye = eyePosition(index);
  vertex.clip = fixed.projection * eye;
  const glm::dvec3 normal = eyeNormal(index);
  const glm::dvec4 color = attribute(gen::kColor, index);
  vertex.front = clampColor(fixed.lighting.enabled ? light(eye, normal, color) : color);
  vertex.back = vertex.front;
  if (fixed.lighting.enabled && fixed.lighting.twoSided) vertex.back = clampColor(light(eye, -normal, color));

  for (int i = 0; i < kMaxTextureUnits; ++i)
    if (fixed.units[static_cast<size_t>(i)].target != gen::TextureTarget::None)
      vertex.texCoord[static_cast<size_t>(i)] = textureCoordinate(i, index, eye, normal);
  for (size_t i = 0; i < kMaxClipPlanes; ++i)
    if (fixed.clipPlanes[i].enabled) vertex.planeDistance[i] = glm::dot(fixed.clipPlanes[i].equation, eye);
  vertex.fogDistance = std::abs(eye.w != 0 ? eye.z / eye.w : eye.z);

  if (fixed.primitive == gen::PrimitiveClass::Points) {  // section 3.3
    const gen::Points& points = fixed.points;
    const double size =
        fixed.attributes[gen::kPointSize].array ? attribute(gen::kPointSize, index).x : points.size;
    const double d = glm::length(eye.w != 0 ? glm::dvec3(eye) / eye.w : glm::dvec3(eye));
    const glm::dvec3 k(points.distanceAttenuation);
    const double denominator = k.x + k.y * d + k.z * d * d;
    double derived = denominator > 0 ? size / std::sqrt(denominator) : points.sizeMax;
    derived = std::min(std::max(derived, double(points.sizeMin)), double(points.sizeMax));
    vertex.pointSize = std::min(std::max(derived, double(points.deviceMin)), double(points.deviceMax));
  }
  return vertex;
}

}  // namespace anteroom::reference
