// fragment unit0=2d read0=st unit1=2d read1=st switch-over=1 rgb0=modulate(previous,texture0) alpha0=modulate(previous.a,texture0.a) rgb1=modulate(previous,texture1) alpha1=modulate(previous.a,texture1.a)
#version 450

layout(location = 0) out vec4 fragment;
layout(set = 1, binding = 0) uniform sampler2D unit0;
layout(location = 6) in vec2 texCoord0;
layout(set = 1, binding = 1) uniform sampler2D unit1;
layout(location = 7) in vec2 texCoord1;
layout(location = 0) in vec4 frontColor;

// Section 3.7.8 with c = 0.5: a bias that makes any smaller level of detail one of magnification.
float switchOver(float lod) { return lod > 0.5 ? 0.0 : -1.0; }

void main() {
  vec4 texel0 = texture(unit0, texCoord0, switchOver(textureQueryLod(unit0, texCoord0).y));
  vec4 texel1 = texture(unit1, texCoord1);
  vec4 color = frontColor;
  color = color * texel0;
  color = color * texel1;
  fragment = color;
}
