// Expects: facing
// Equation 2.5.
float spot(vec3 toLight, vec3 direction, float cosCutoff, float exponent) {
  float cosine = facing(-toLight, direction);
  return cosine >= cosCutoff ? pow(cosine, exponent) : 0.0;
}
