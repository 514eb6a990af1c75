// Expects: nothing
// DOT3_RGB and DOT3_RGBA, table 3.17.
vec4 dot3(vec4 a, vec4 b) { return vec4(4.0 * dot(a.rgb - 0.5, b.rgb - 0.5)); }
