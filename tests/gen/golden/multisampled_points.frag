// fragment point-shape=samples point-fade
#version 450

layout(location = 0) out vec4 fragment;
layout(location = 0) in vec4 frontColor;
layout(location = 3) flat in float diameter;
layout(location = 14) flat in float fade;

// Section 3.3.3 at Vulkan's standard places of 4 samples: a bit for each that lies in the circle.
int samplesInCircle(vec2 coord, float diameter) {
  const vec2 places[4] = vec2[](vec2(-0.125, -0.375), vec2(0.375, -0.125), vec2(-0.375, 0.125), vec2(0.125, 0.375));
  int mask = ~15;
  for (int i = 0; i < 4; ++i)
    if (length((coord - 0.5) * diameter + places[i]) <= 0.5 * diameter) mask |= 1 << i;
  return mask;
}

void main() {
  vec4 color = frontColor;
  gl_SampleMask[0] = samplesInCircle(gl_PointCoord, diameter);
  color.a *= fade;
  fragment = color;
}
