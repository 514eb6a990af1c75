// vertex position=float color=constant shade=unlit point-size=constant point-shape=smooth
#version 450

layout(push_constant) uniform Push {
  mat4 modelviewProjection;
  vec4 color;
};
layout(std140, set = 0, binding = 0) uniform Vertex {
  float size;
};
layout(location = 0) in vec4 position;
out gl_PerVertex {
  vec4 gl_Position;
  float gl_PointSize;
};
invariant gl_Position;
layout(location = 0) out vec4 frontColor;
layout(location = 3) flat out float diameter;

void main() {
  gl_Position = modelviewProjection * position;
  frontColor = color;
  diameter = size;
  gl_PointSize = diameter + 1.0;
}
