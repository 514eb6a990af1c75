// Expects: facing
// Equation 2.5 with exponent 0.
float spotCone(vec3 toLight, vec3 direction, float cosCutoff) {
  return facing(-toLight, direction) >= cosCutoff ? 1.0 : 0.0;
}
