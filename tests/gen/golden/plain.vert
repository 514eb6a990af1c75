// vertex position=float color=constant shade=unlit
#version 450

layout(push_constant) uniform Push {
  mat4 modelviewProjection;
  vec4 color;
};
layout(location = 0) in vec4 position;
out gl_PerVertex {
  vec4 gl_Position;
};
invariant gl_Position;
layout(location = 0) out vec4 frontColor;

void main() {
  gl_Position = modelviewProjection * position;
  frontColor = color;
}
