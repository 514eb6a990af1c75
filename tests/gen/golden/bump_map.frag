// fragment unit0=2d read0=st unit1=2d read1=st rgb0=dot3(previous,texture0) rgb1=modulate(previous,texture1)
#version 450

layout(location = 0) out vec4 fragment;
layout(set = 1, binding = 0) uniform sampler2D unit0;
layout(location = 6) in vec2 texCoord0;
layout(set = 1, binding = 1) uniform sampler2D unit1;
layout(location = 7) in vec2 texCoord1;
layout(location = 0) in vec4 frontColor;

// DOT3_RGB and DOT3_RGBA, table 3.17.
vec4 dot3(vec4 a, vec4 b) { return vec4(4.0 * dot(a.rgb - 0.5, b.rgb - 0.5)); }
vec4 saturate(vec4 v) { return clamp(v, 0.0, 1.0); }

void main() {
  vec4 texel0 = texture(unit0, texCoord0);
  vec4 texel1 = texture(unit1, texCoord1);
  vec4 color = frontColor;
  color.rgb = saturate(dot3(color, texel0)).rgb;
  color.rgb = (color * texel1).rgb;
  fragment = color;
}
