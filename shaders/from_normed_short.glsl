// Expects: nothing
// Table 2.7, short.
vec4 fromNormedShort(ivec4 v) { return (2.0 * vec4(v) + 1.0) / 65535.0; }
