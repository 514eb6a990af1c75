// Expects: nothing
// Equation 2.4; no attenuation where it has no value.
float attenuation(vec3 k, float range) {
  float denominator = k.x + (k.y + k.z * range) * range;
  return denominator > 0.0 ? 1.0 / denominator : 1.0;
}
