// vertex position=float color=constant coord0=float shade=unlit out0=stq matrix0 q1-0
#version 450

layout(push_constant) uniform Push {
  mat4 modelviewProjection;
  vec4 color;
};
layout(std140, set = 0, binding = 0) uniform Vertex {
  mat3x4 textureMatrix0;
};
layout(location = 0) in vec4 position;
layout(location = 4) in vec4 coord0;
out gl_PerVertex {
  vec4 gl_Position;
};
invariant gl_Position;
layout(location = 0) out vec4 frontColor;
layout(location = 6) out vec3 texCoord0;

void main() {
  gl_Position = modelviewProjection * position;
  frontColor = color;
  texCoord0 = coord0 * textureMatrix0;
}
