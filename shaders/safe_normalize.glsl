// Expects: nothing
// A unit vector; 0 for 0. Scaled first, so that no square leaves the range of a float.
vec3 safeNormalize(vec3 v) {
  float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
  vec3 scaled = v / largest;
  return largest > 0.0 ? scaled * inversesqrt(dot(scaled, scaled)) : vec3(0.0);
}
