// Expects: nothing
// z divided by w of eye coordinates.
float dividedDepth(vec2 zw) { return zw.y == 0.0 ? zw.x : zw.x / zw.y; }
