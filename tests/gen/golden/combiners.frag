// fragment unit0=2d read0=st unit1=2d read1=st unit2=2d read2=st rgb0=interpolate(texture0,previous,texture2.a) alpha0=subtract(texture0.a,1-previous.a) rgb1=addsigned(previous,primary)*2 alpha1=modulate(previous.a,texture1.a) rgb2=interpolate(constant,previous,texture2) alpha2=modulate(previous.a,texture2.a)
#version 450

layout(std140, set = 2, binding = 0) uniform Fragment {
  vec4 constant2;
};
layout(location = 0) out vec4 fragment;
layout(set = 1, binding = 0) uniform sampler2D unit0;
layout(location = 6) in vec2 texCoord0;
layout(set = 1, binding = 1) uniform sampler2D unit1;
layout(location = 7) in vec2 texCoord1;
layout(set = 1, binding = 2) uniform sampler2D unit2;
layout(location = 8) in vec2 texCoord2;
layout(location = 0) in vec4 frontColor;

vec4 saturate(vec4 v) { return clamp(v, 0.0, 1.0); }

void main() {
  vec4 texel0 = texture(unit0, texCoord0);
  vec4 texel1 = texture(unit1, texCoord1);
  vec4 texel2 = texture(unit2, texCoord2);
  vec4 primary = frontColor;
  vec4 color = primary;
  color = vec4(mix(color, texel0, texel2.aaaa).rgb, saturate(texel0 - (1.0 - color)).a);
  color = vec4(saturate(2.0 * (color + primary - 0.5)).rgb, (color * texel1).a);
  color = vec4(mix(color, constant2, texel2).rgb, (color * texel2).a);
  fragment = color;
}
