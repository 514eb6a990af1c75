// fragment point-shape=smooth
#version 450

layout(location = 0) out vec4 fragment;
layout(location = 0) in vec4 frontColor;
layout(location = 3) flat in float diameter;

// How much of a pixel the circle covers, at most its area; the rasterised square is a pixel wider than the circle.
float pointCoverage(vec2 coord, float diameter) {
  float fromCentre = length(coord - 0.5) * (diameter + 1.0);
  float area = 0.7853982 * diameter * diameter;
  return clamp(0.5 * diameter + 0.5 - fromCentre, 0.0, min(area, 1.0));
}

void main() {
  vec4 color = frontColor;
  color.a *= pointCoverage(gl_PointCoord, diameter);
  fragment = color;
}
