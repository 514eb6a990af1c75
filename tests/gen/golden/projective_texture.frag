// fragment unit0=2d read0=stq rgb0=modulate(previous,texture0)
#version 450

layout(location = 0) out vec4 fragment;
layout(set = 1, binding = 0) uniform sampler2D unit0;
layout(location = 6) in vec3 texCoord0;
layout(location = 0) in vec4 frontColor;

// s/q and t/q, finite for every q.
vec2 divideSt(vec3 stq) { return clamp(stq.xy / (stq.z == 0.0 ? 1.0 : stq.z), -1e9, 1e9); }

void main() {
  vec4 texel0 = texture(unit0, divideSt(texCoord0));
  vec4 color = frontColor;
  color.rgb = (color * texel0).rgb;
  fragment = color;
}
