// vertex position=float color=constant coord0=float shade=unlit fog out0=st q1-0
#version 450

layout(push_constant) uniform Push {
  mat4 modelviewProjection;
  vec4 color;
  vec4 eyeDepth;
};
layout(location = 0) in vec4 position;
layout(location = 4) in vec4 coord0;
out gl_PerVertex {
  vec4 gl_Position;
};
invariant gl_Position;
layout(location = 0) out vec4 frontColor;
layout(location = 2) out float fogDepth;
layout(location = 6) out vec2 texCoord0;

void main() {
  gl_Position = modelviewProjection * position;
  frontColor = color;
  fogDepth = dot(eyeDepth, position);
  texCoord0 = coord0.st;
}
