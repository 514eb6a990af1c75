// vertex position=float
#version 450

layout(push_constant) uniform Push {
  mat4 modelviewProjection;
};
layout(location = 0) in vec4 position;
out gl_PerVertex {
  vec4 gl_Position;
};
invariant gl_Position;

void main() {
  gl_Position = modelviewProjection * position;
}
