// Expects: nothing
// Eye coordinates divided by w.
vec3 eyePoint(vec4 eye) { return eye.w == 1.0 || eye.w == 0.0 ? eye.xyz : eye.xyz / eye.w; }
