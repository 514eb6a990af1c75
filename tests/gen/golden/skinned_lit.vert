// vertex position=float normal=float index=uint weight=float shade=lit normalize lights=1 palette=4
#version 450

layout(push_constant) uniform Push {
  mat4 projection;
};
layout(std140, set = 0, binding = 0) uniform Vertex {
  vec4 sceneColor;
  vec3 light0Direction;
  vec3 light0Diffuse;
};
layout(std140, set = 3, binding = 0) uniform Palette {
  mat3x4 palette[64];
};
layout(location = 0) in vec4 position;
layout(location = 1) in vec3 normal;
layout(location = 12) in uvec4 index;
layout(location = 13) in vec4 weight;
out gl_PerVertex {
  vec4 gl_Position;
};
invariant gl_Position;
layout(location = 0) out vec4 frontColor;

// A unit vector; 0 for 0. Scaled first, so that no square leaves the range of a float.
vec3 safeNormalize(vec3 v) {
  float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
  vec3 scaled = v / largest;
  return largest > 0.0 ? scaled * inversesqrt(dot(scaled, scaled)) : vec3(0.0);
}
// The product of directions of section 2.12.1.
float facing(vec3 a, vec3 b) { return max(dot(a, b), 0.0); }
vec4 saturate(vec4 v) { return clamp(v, 0.0, 1.0); }

vec4 illuminate(vec3 normal) {
  vec3 matte = sceneColor.rgb;
  matte += facing(normal, light0Direction) * light0Diffuse;
  return saturate(vec4(matte, sceneColor.a));
}

void main() {
  uvec4 slot = min(index, 63u);
  mat3x4 skin = weight.x * palette[slot.x] + weight.y * palette[slot.y] + weight.z * palette[slot.z] + weight.w * palette[slot.w];
  vec4 eye = vec4(position * skin, position.w * (weight.x + weight.y + weight.z + weight.w));
  gl_Position = projection * eye;
  vec3 eyeNormal = safeNormalize(normal * mat3(skin));
  frontColor = illuminate(eyeNormal);
}
