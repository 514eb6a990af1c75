// Expects: nothing
// GL_FIXED, section 2.3.
vec4 fromFixed(ivec4 v) { return vec4(v) / 65536.0; }
