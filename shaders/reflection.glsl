// Expects: safeNormalize
// REFLECTION_MAP_OES: the direction from the eye, reflected.
vec3 reflection(vec3 point, vec3 normal) {
  vec3 u = safeNormalize(point);
  return u - 2.0 * normal * dot(normal, u);
}
