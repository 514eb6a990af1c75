// Expects: nothing
// Equation 3.23; density is for powers of 2.
float fogExp2(float depth, float density) {
  float scaled = density * depth;
  return clamp(exp2(-scaled * scaled), 0.0, 1.0);
}
