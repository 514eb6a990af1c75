// Expects: nothing
// s/q, t/q and r/q, finite for every q.
vec3 divideStr(vec4 strq) { return clamp(strq.xyz / (strq.w == 0.0 ? 1.0 : strq.w), -1e9, 1e9); }
