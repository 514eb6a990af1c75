// fragment
#version 450

layout(location = 0) out vec4 fragment;
layout(location = 0) in vec4 frontColor;

void main() {
  vec4 color = frontColor;
  fragment = color;
}
