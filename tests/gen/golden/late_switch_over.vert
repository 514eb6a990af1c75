// vertex position=float color=constant coord0=float coord1=float shade=unlit out0=st q1-0 out1=st q1-1
#version 450

layout(push_constant) uniform Push {
  mat4 modelviewProjection;
  vec4 color;
};
layout(location = 0) in vec4 position;
layout(location = 4) in vec4 coord0;
layout(location = 5) in vec4 coord1;
out gl_PerVertex {
  vec4 gl_Position;
};
invariant gl_Position;
layout(location = 0) out vec4 frontColor;
layout(location = 6) out vec2 texCoord0;
layout(location = 7) out vec2 texCoord1;

void main() {
  gl_Position = modelviewProjection * position;
  frontColor = color;
  texCoord0 = coord0.st;
  texCoord1 = coord1.st;
}
