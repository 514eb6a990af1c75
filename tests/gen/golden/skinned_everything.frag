// fragment unit0=cube read0=str fog=exp rgb0=modulate(previous,texture0) alpha0=modulate(previous.a,texture0.a)
#version 450

layout(std140, set = 2, binding = 0) uniform Fragment {
  vec3 fogColor;
  float fogDensity;
};
layout(location = 0) out vec4 fragment;
layout(set = 1, binding = 0) uniform samplerCube unit0;
layout(location = 6) in vec3 texCoord0;
layout(location = 0) in vec4 frontColor;
layout(location = 2) in float fogDepth;

// Equation 3.22; density is for powers of 2.
float fogExp(float depth, float density) { return clamp(exp2(-density * abs(depth)), 0.0, 1.0); }

void main() {
  vec4 texel0 = texture(unit0, texCoord0);
  vec4 color = frontColor;
  color = color * texel0;
  color.rgb = mix(fogColor, color.rgb, fogExp(fogDepth, fogDensity));
  fragment = color;
}
