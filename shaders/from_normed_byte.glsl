// Expects: nothing
// Table 2.7, byte.
vec4 fromNormedByte(ivec4 v) { return (2.0 * vec4(v) + 1.0) / 255.0; }
