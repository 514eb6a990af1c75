// Expects: nothing
// Equation 3.24; scale is 1 / (end - start).
float fogLinear(float depth, float end, float scale) { return clamp((end - abs(depth)) * scale, 0.0, 1.0); }
