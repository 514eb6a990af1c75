#version 450
// One triangle that covers the target, in one color.
layout(push_constant) uniform Push { vec4 color; };
layout(location = 0) flat out vec4 flatColor;
void main() {
  flatColor = color;
  gl_Position = vec4(vec2(gl_VertexIndex & 1, gl_VertexIndex >> 1) * 4.0 - 1.0, 0.0, 1.0);
}
