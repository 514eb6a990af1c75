// Expects: nothing
// Section 3.3; where it has no value it is larger than every point.
float attenuatedSize(float size, vec3 k, float range) {
  float denominator = k.x + (k.y + k.z * range) * range;
  return denominator > 0.0 ? size * inversesqrt(denominator) : 1e30;
}
