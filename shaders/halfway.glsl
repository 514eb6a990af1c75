// Expects: safeNormalize
// Equation 2.3: the viewer is at infinity, on the z axis.
vec3 halfway(vec3 toLight) { return safeNormalize(toLight + vec3(0.0, 0.0, 1.0)); }
