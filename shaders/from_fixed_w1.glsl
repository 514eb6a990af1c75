// Expects: nothing
// GL_FIXED without a fourth component.
vec4 fromFixedW1(ivec4 v) { return vec4(vec3(v.xyz) / 65536.0, 1.0); }
