// fragment fog=exp
#version 450

layout(std140, set = 2, binding = 0) uniform Fragment {
  vec3 fogColor;
  float fogDensity;
};
layout(location = 0) out vec4 fragment;
layout(location = 0) in vec4 frontColor;
layout(location = 2) in float fogDepth;

// Equation 3.22; density is for powers of 2.
float fogExp(float depth, float density) { return clamp(exp2(-density * abs(depth)), 0.0, 1.0); }

void main() {
  vec4 color = frontColor;
  color.rgb = mix(fogColor, color.rgb, fogExp(fogDepth, fogDensity));
  fragment = color;
}
