// fragment discard-planes=2
#version 450

layout(location = 0) out vec4 fragment;
layout(location = 0) in vec4 frontColor;
layout(location = 4) in vec4 clipDistances0;

void main() {
  vec4 color = frontColor;
  if (any(lessThan(clipDistances0, vec4(0.0)))) discard;
  fragment = color;
}
