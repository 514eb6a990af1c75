// fragment point-shape=smooth
#version 450

layout(location = 0) out vec4 fragment;
layout(location = 0) in vec4 frontColor;
layout(location = 3) flat in float diameter;

// Section 3.3.1: the part of a pixel that lies inside the circle, by 16 columns; the rasterised square is a pixel wider
// than the circle. Turned so that the rim is flattest over the columns.
float pointCoverage(vec2 coord, float diameter) {
  vec2 pixel = abs(coord - 0.5) * (diameter + 1.0);
  if (pixel.x > pixel.y) pixel = pixel.yx;
  float area = 0.0;
  for (int i = 0; i < 16; ++i) {
    float x = pixel.x + (float(i) + 0.5) / 16.0 - 0.5;
    float rim = sqrt(max(0.25 * diameter * diameter - x * x, 0.0));
    area += max(min(pixel.y + 0.5, rim) - max(pixel.y - 0.5, -rim), 0.0) / 16.0;
  }
  return area;
}

void main() {
  vec4 color = frontColor;
  color.a *= pointCoverage(gl_PointCoord, diameter);
  fragment = color;
}
