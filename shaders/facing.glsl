// Expects: nothing
// The product of directions of section 2.12.1.
float facing(vec3 a, vec3 b) { return max(dot(a, b), 0.0); }
