// fragment flat two-sided
#version 450

layout(location = 0) out vec4 fragment;
layout(location = 0) flat in vec4 frontColor;
layout(location = 1) flat in vec4 backColor;

void main() {
  vec4 color = gl_FrontFacing ? frontColor : backColor;
  fragment = color;
}
