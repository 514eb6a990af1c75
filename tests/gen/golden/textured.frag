// fragment unit0=2d read0=st rgb0=modulate(previous,texture0) alpha0=modulate(previous.a,texture0.a)
#version 450

layout(location = 0) out vec4 fragment;
layout(set = 1, binding = 0) uniform sampler2D unit0;
layout(location = 6) in vec2 texCoord0;
layout(location = 0) in vec4 frontColor;

void main() {
  vec4 texel0 = texture(unit0, texCoord0);
  vec4 color = frontColor;
  color = color * texel0;
  fragment = color;
}
