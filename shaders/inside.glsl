// Expects: nothing
// How much of a linear filter about a coordinate lies in [-1, 1]; size: texels in [0, 1].
float inside(float coordinate, float size) { return clamp(size * (1.0 - abs(coordinate)) + 0.5, 0.0, 1.0); }
