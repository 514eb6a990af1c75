// fragment unit0=cube read0=str rgb0=add(previous,texture0) alpha0=modulate(previous.a,texture0.a)
#version 450

layout(location = 0) out vec4 fragment;
layout(set = 1, binding = 0) uniform samplerCube unit0;
layout(location = 6) in vec3 texCoord0;
layout(location = 0) in vec4 frontColor;

vec4 saturate(vec4 v) { return clamp(v, 0.0, 1.0); }

void main() {
  vec4 texel0 = texture(unit0, texCoord0);
  vec4 color = frontColor;
  color = vec4(saturate(color + texel0).rgb, (color * texel0).a);
  fragment = color;
}
