#version 450
// The texel under the pixel, whatever the color that is handed in.
layout(location = 0) flat in vec4 flatColor;
layout(set = 1, binding = 0) uniform sampler2D texels;
layout(location = 0) out vec4 color;
void main() { color = texelFetch(texels, ivec2(gl_FragCoord.xy), 0); }
