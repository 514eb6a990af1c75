// vertex position=float color=constant shade=unlit fog fog-w
#version 450

layout(push_constant) uniform Push {
  mat4 modelviewProjection;
  vec4 color;
  mat2x4 eyeDepth;
};
layout(location = 0) in vec4 position;
out gl_PerVertex {
  vec4 gl_Position;
};
invariant gl_Position;
layout(location = 0) out vec4 frontColor;
layout(location = 2) out float fogDepth;

// z divided by w of eye coordinates.
float dividedDepth(vec2 zw) { return zw.y == 0.0 ? zw.x : zw.x / zw.y; }

void main() {
  gl_Position = modelviewProjection * position;
  frontColor = color;
  fogDepth = dividedDepth(position * eyeDepth);
}
