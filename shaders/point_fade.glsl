// Expects: nothing
// Equation 3.2.
float pointFade(float derived, float threshold) {
  float ratio = min(derived / threshold, 1.0);
  return ratio * ratio;
}
