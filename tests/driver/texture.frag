#version 450
layout(location = 0) in vec4 interpolated;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0) uniform sampler2D image;

void main() { color = texture(image, interpolated.xy); }
