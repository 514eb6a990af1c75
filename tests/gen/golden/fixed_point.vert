// vertex position=fixed-w1 color=fixed coord0=fixed-w1 shade=unlit out0=st q1-0
#version 450

layout(push_constant) uniform Push {
  mat4 modelviewProjection;
};
layout(location = 0) in ivec4 positionArray;
layout(location = 2) in ivec4 colorArray;
layout(location = 4) in ivec4 coord0Array;
out gl_PerVertex {
  vec4 gl_Position;
};
invariant gl_Position;
layout(location = 0) out vec4 frontColor;
layout(location = 6) out vec2 texCoord0;

// GL_FIXED without a fourth component.
vec4 fromFixedW1(ivec4 v) { return vec4(vec3(v.xyz) / 65536.0, 1.0); }
// GL_FIXED, section 2.3.
vec4 fromFixed(ivec4 v) { return vec4(v) / 65536.0; }
vec4 saturate(vec4 v) { return clamp(v, 0.0, 1.0); }

void main() {
  vec4 position = fromFixedW1(positionArray);
  vec4 color = fromFixed(colorArray);
  vec4 coord0 = fromFixedW1(coord0Array);
  gl_Position = modelviewProjection * position;
  frontColor = saturate(color);
  texCoord0 = coord0.st;
}
