#version 450
layout(location = 0) in vec4 interpolated;  // a seed, and how many bits a component has
layout(location = 0) out vec4 color;

uint scramble(uint x) {
  x = (x ^ (x >> 16)) * 0x7feb352du;
  x = (x ^ (x >> 15)) * 0x846ca68bu;
  return x ^ (x >> 16);
}

void main() {
  uint pixel = uint(gl_FragCoord.y) * 64u + uint(gl_FragCoord.x);
  uint most = (1u << uint(interpolated.y)) - 1u;
  for (uint i = 0u; i < 4u; ++i)
    color[i] = float(scramble((pixel * 4u + i) * 2u + uint(interpolated.x)) & most) / float(most);
}
