// vertex position=float color=constant index=uint weight=float shade=unlit fog palette=2
#version 450

layout(push_constant) uniform Push {
  mat4 projection;
  vec4 color;
};
layout(std140, set = 3, binding = 0) uniform Palette {
  mat3x4 palette[64];
};
layout(location = 0) in vec4 position;
layout(location = 12) in uvec4 index;
layout(location = 13) in vec4 weight;
out gl_PerVertex {
  vec4 gl_Position;
};
invariant gl_Position;
layout(location = 0) out vec4 frontColor;
layout(location = 2) out float fogDepth;

// z divided by w of eye coordinates.
float dividedDepth(vec2 zw) { return zw.y == 0.0 ? zw.x : zw.x / zw.y; }

void main() {
  uvec4 slot = min(index, 63u);
  mat3x4 skin = weight.x * palette[slot.x] + weight.y * palette[slot.y];
  vec4 eye = vec4(position * skin, position.w * (weight.x + weight.y));
  gl_Position = projection * eye;
  frontColor = color;
  fogDepth = dividedDepth(eye.zw);
}
