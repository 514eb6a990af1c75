// Expects: nothing
// s/q and t/q, finite for every q.
vec2 divideSt(vec3 stq) { return clamp(stq.xy / (stq.z == 0.0 ? 1.0 : stq.z), -1e9, 1e9); }
