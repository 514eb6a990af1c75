// fragment unit0=2d read0=st fog=linear alpha-test=greater rgb0=modulate(previous,texture0) alpha0=modulate(previous.a,texture0.a)
#version 450

layout(std140, set = 2, binding = 0) uniform Fragment {
  vec3 fogColor;
  float fogEnd;
  float fogScale;
  float alphaScale;
  float alphaReference;
};
layout(location = 0) out vec4 fragment;
layout(set = 1, binding = 0) uniform sampler2D unit0;
layout(location = 6) in vec2 texCoord0;
layout(location = 0) in vec4 frontColor;
layout(location = 2) in float fogDepth;

// Equation 3.24; scale is 1 / (end - start).
float fogLinear(float depth, float end, float scale) { return clamp((end - abs(depth)) * scale, 0.0, 1.0); }
// Section 4.1.4: alpha as the framebuffer holds it.
float roundedAlpha(float alpha, float scale) { return floor(alpha * scale + 0.5); }

void main() {
  vec4 texel0 = texture(unit0, texCoord0);
  vec4 color = frontColor;
  color = color * texel0;
  color.rgb = mix(fogColor, color.rgb, fogLinear(fogDepth, fogEnd, fogScale));
  if (!(roundedAlpha(color.a, alphaScale) > alphaReference)) discard;
  fragment = color;
}
