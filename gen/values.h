// The values behind constants, computed from the state in float64 and rounded once.
#pragma once

#include "gen/state.h"

namespace anteroom::gen {

// To clip coordinates with Vulkan's depth range, z' = (z + w) / 2: from eye and from object coordinates.
glm::dmat4 clipProjection(const State& state);
glm::dmat4 modelviewProjection(const State& state);

// Eye normals: section 2.10.3 with the rescale factor, finite for every matrix.
glm::dmat3 normalMatrix(const glm::dmat4& matrix, bool rescale);
// By the modelview matrix. Under NORMALIZE its length is arbitrary.
glm::dmat3 normalMatrix(const State& state);
// The current normal in eye coordinates, normalised if NORMALIZE is enabled.
glm::dvec3 currentEyeNormal(const State& state);

// A plane in eye and in object coordinates, scaled so that its largest coefficient is 1: only signs and
// ratios matter.
glm::dvec4 eyePlane(const ClipPlane& plane);
glm::dvec4 objectPlane(const State& state, const ClipPlane& plane);
const ClipPlane& enabledPlane(const State& state, int index);

// The current texture coordinates of a unit, transformed and divided by q.
glm::dvec4 currentTexCoord(const State& state, int unit);

const Light& enabledLight(const State& state, int index);
glm::dvec3 lightPosition(const Light& light);   // divided by w
glm::dvec3 lightDirection(const Light& light);  // of a light at infinity: a unit vector, or 0
glm::dvec3 spotDirection(const Light& light);   // a unit vector, or 0
glm::dvec3 halfVector(const Light& light);      // of a light at infinity
// What a light at infinity loses to its cone: the same for all vertices.
double constantSpot(const Light& light);
double cosCutoff(const Light& light);
// Whether a light's contribution is scaled by vertex: its ambient part cannot be added up beforehand.
bool variesByVertex(const Light& light);

// Ambient light that no vertex changes: of the scene and of lights that do not vary.
glm::dvec3 constantAmbient(const State& state);

// From normalised device to window coordinates (section 2.10.1): the centre in pixels, and half the size.
glm::dvec4 viewportTransform(const Rect& viewport);

// Limits of a derived point size: the user's range within the device's.
glm::dvec2 pointSizeRange(const Points& points);

// Equation of section 3.3 for a point that is not attenuated, in pixels.
float constantPointSize(const State& state);
// The least that it can derive, in pixels.
float smallestPointSize(const State& state);

}  // namespace anteroom::gen
