// vertex position=float color=constant shade=unlit clip=2 clip-varyings
#version 450

layout(push_constant) uniform Push {
  mat4 modelviewProjection;
  vec4 color;
};
layout(std140, set = 0, binding = 0) uniform Vertex {
  vec4 clipPlane0;
  vec4 clipPlane1;
};
layout(location = 0) in vec4 position;
out gl_PerVertex {
  vec4 gl_Position;
};
invariant gl_Position;
layout(location = 0) out vec4 frontColor;
layout(location = 4) out vec4 clipDistances0;

void main() {
  gl_Position = modelviewProjection * position;
  frontColor = color;
  clipDistances0 = vec4(dot(clipPlane0, position), dot(clipPlane1, position), 0.0, 0.0);
}
