// Expects: nothing
// A unit vector; 0 for 0.
vec3 safeNormalize(vec3 v) {
  float squared = dot(v, v);
  return squared > 0.0 ? v * inversesqrt(squared) : vec3(0.0);
}
