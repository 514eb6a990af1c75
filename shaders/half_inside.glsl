// Expects: inside
// The same when the coordinate is clamped to [-1, 1] first.
float halfInside(float coordinate, float size) { return max(inside(coordinate, size), 0.5); }
