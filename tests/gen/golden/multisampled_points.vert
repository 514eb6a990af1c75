// vertex position=float color=constant shade=unlit point-size=constant point-shape=samples point-fade
#version 450

layout(push_constant) uniform Push {
  mat4 modelviewProjection;
  vec4 color;
};
layout(std140, set = 0, binding = 0) uniform Vertex {
  float size;
  float fadeThreshold;
};
layout(location = 0) in vec4 position;
out gl_PerVertex {
  vec4 gl_Position;
  float gl_PointSize;
};
invariant gl_Position;
layout(location = 0) out vec4 frontColor;
layout(location = 14) flat out float fade;
layout(location = 3) flat out float diameter;

// Equation 3.2.
float pointFade(float derived, float threshold) {
  float ratio = min(derived / threshold, 1.0);
  return ratio * ratio;
}

void main() {
  gl_Position = modelviewProjection * position;
  frontColor = color;
  float derived = size;
  fade = pointFade(derived, fadeThreshold);
  diameter = max(derived, fadeThreshold);
  gl_PointSize = diameter;
}
