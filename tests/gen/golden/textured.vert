// vertex position=float color=float coord0=float shade=unlit out0=st q1-0
#version 450

layout(push_constant) uniform Push {
  mat4 modelviewProjection;
};
layout(location = 0) in vec4 position;
layout(location = 2) in vec4 color;
layout(location = 4) in vec4 coord0;
out gl_PerVertex {
  vec4 gl_Position;
};
invariant gl_Position;
layout(location = 0) out vec4 frontColor;
layout(location = 6) out vec2 texCoord0;

vec4 saturate(vec4 v) { return clamp(v, 0.0, 1.0); }

void main() {
  gl_Position = modelviewProjection * position;
  frontColor = saturate(color);
  texCoord0 = coord0.st;
}
