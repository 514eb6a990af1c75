// vertex position=float normal=float shade=lit lights=1 fog own-values
#version 450

layout(location = 16) in mat4 modelviewProjection;
layout(location = 20) in vec4 eyeDepth;
layout(location = 21) in mat3 normalMatrix;
layout(std140, set = 0, binding = 0) uniform Vertex {
  vec4 sceneColor;
  vec3 light0Direction;
  vec3 light0Diffuse;
};
layout(location = 0) in vec4 position;
layout(location = 1) in vec3 normal;
out gl_PerVertex {
  vec4 gl_Position;
};
invariant gl_Position;
layout(location = 0) out vec4 frontColor;
layout(location = 2) out float fogDepth;

// The product of directions of section 2.12.1.
float facing(vec3 a, vec3 b) { return max(dot(a, b), 0.0); }
vec4 saturate(vec4 v) { return clamp(v, 0.0, 1.0); }

vec4 illuminate(vec3 normal) {
  vec3 matte = sceneColor.rgb;
  matte += facing(normal, light0Direction) * light0Diffuse;
  return saturate(vec4(matte, sceneColor.a));
}

void main() {
  gl_Position = modelviewProjection * position;
  vec3 eyeNormal = normalMatrix * normal;
  frontColor = illuminate(eyeNormal);
  fogDepth = dot(eyeDepth, position);
}
