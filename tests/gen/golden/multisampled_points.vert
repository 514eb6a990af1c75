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

// Section 2.11: a point is there when its centre is inside the clip volume, whatever its size. Drivers may keep the part
// of it that is inside; they do clip by depth.
vec4 clippedByCenter(vec4 clip) {
  return all(lessThanEqual(abs(clip.xy), clip.ww)) ? clip : vec4(0.0, 0.0, 2.0, 1.0);
}
// Equation 3.2.
float pointFade(float derived, float threshold) {
  float ratio = min(derived / threshold, 1.0);
  return ratio * ratio;
}

void main() {
  gl_Position = modelviewProjection * position;
  frontColor = color;
  gl_Position = clippedByCenter(gl_Position);
  float derived = size;
  fade = pointFade(derived, fadeThreshold);
  diameter = max(derived, fadeThreshold);
  gl_PointSize = diameter;
}
