// vertex position=float normal=float index=uint weight=fixed shade=lit lights=1 positional=1 fog clip=1 palette=2 palette-w palette-normals out0=str texgen0=reflection q1-0
#version 450

layout(push_constant) uniform Push {
  mat4 projection;
};
layout(std140, set = 0, binding = 0) uniform Vertex {
  vec4 sceneColor;
  vec3 light0Position;
  vec3 light0Diffuse;
  vec4 clipPlane0;
};
layout(std140, set = 3, binding = 0) uniform Palette {
  mat4 palette[64];
  mat3 paletteNormals[64];
};
layout(location = 0) in vec4 position;
layout(location = 1) in vec3 normal;
layout(location = 12) in uvec4 index;
layout(location = 13) in ivec4 weightArray;
out gl_PerVertex {
  vec4 gl_Position;
  float gl_ClipDistance[1];
};
invariant gl_Position;
layout(location = 0) out vec4 frontColor;
layout(location = 2) out float fogDepth;
layout(location = 6) out vec3 texCoord0;

// GL_FIXED, section 2.3.
vec4 fromFixed(ivec4 v) { return vec4(v) / 65536.0; }
// Eye coordinates divided by w.
vec3 eyePoint(vec4 eye) { return eye.w == 1.0 || eye.w == 0.0 ? eye.xyz : eye.xyz / eye.w; }
// A unit vector; 0 for 0. Scaled first, so that no square leaves the range of a float.
vec3 safeNormalize(vec3 v) {
  float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
  vec3 scaled = v / largest;
  return largest > 0.0 ? scaled * inversesqrt(dot(scaled, scaled)) : vec3(0.0);
}
// The product of directions of section 2.12.1.
float facing(vec3 a, vec3 b) { return max(dot(a, b), 0.0); }
vec4 saturate(vec4 v) { return clamp(v, 0.0, 1.0); }
// REFLECTION_MAP_OES: the direction from the eye, reflected.
vec3 reflection(vec3 point, vec3 normal) {
  vec3 u = safeNormalize(point);
  return u - 2.0 * normal * dot(normal, u);
}

vec4 illuminate(vec3 normal, vec3 point) {
  vec3 matte = sceneColor.rgb;
  vec3 offset0 = light0Position - point;
  vec3 toLight0 = safeNormalize(offset0);
  matte += facing(normal, toLight0) * light0Diffuse;
  return saturate(vec4(matte, sceneColor.a));
}

void main() {
  vec4 weight = fromFixed(weightArray);
  uvec4 slot = min(index, 63u);
  mat4 skin = weight.x * palette[slot.x] + weight.y * palette[slot.y];
  vec4 eye = position * skin;
  gl_Position = projection * eye;
  vec3 point = eyePoint(eye);
  vec3 eyeNormal = (weight.x * paletteNormals[slot.x] + weight.y * paletteNormals[slot.y]) * normal;
  frontColor = illuminate(eyeNormal, point);
  fogDepth = point.z;
  texCoord0 = vec4(reflection(point, eyeNormal), 1.0).stp;
  gl_ClipDistance[0] = dot(clipPlane0, eye);
}
