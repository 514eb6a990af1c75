// Expects: nothing
// Integers without a fourth component.
vec4 fromIntW1(ivec4 v) { return vec4(vec3(v.xyz), 1.0); }
