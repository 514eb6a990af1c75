#version 450
layout(location = 0) in vec4 interpolated;
layout(location = 0) out vec4 color;

// x is in (0, 1], y in [0, 128]; both are written back, since interpolation may round them.
void main() {
  float x = interpolated.x, y = interpolated.y;
  color = vec4(pow(x, y), exp(-0.125 * y), x, y);
}
