// fragment alpha-test=never
#version 450

layout(location = 0) out vec4 fragment;

void main() {
  fragment = vec4(0.0);
  discard;
}
