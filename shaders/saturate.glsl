// Expects: nothing
vec4 saturate(vec4 v) { return clamp(v, 0.0, 1.0); }
