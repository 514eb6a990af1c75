// vertex position=float color=constant size=float shade=unlit point-size=varying point-attenuation
#version 450

layout(push_constant) uniform Push {
  mat4 modelviewProjection;
  vec4 color;
};
layout(std140, set = 0, binding = 0) uniform Vertex {
  mat4 modelview;
  vec2 sizeRange;
  vec3 sizeAttenuation;
};
layout(location = 0) in vec4 position;
layout(location = 3) in float size;
out gl_PerVertex {
  vec4 gl_Position;
  float gl_PointSize;
};
invariant gl_Position;
layout(location = 0) out vec4 frontColor;

// Eye coordinates divided by w.
vec3 eyePoint(vec4 eye) { return eye.w == 1.0 || eye.w == 0.0 ? eye.xyz : eye.xyz / eye.w; }
// Section 2.11: a point is there when its centre is inside the clip volume, whatever its size. Drivers may keep the part
// of it that is inside; they do clip by depth.
vec4 clippedByCenter(vec4 clip) {
  return all(lessThanEqual(abs(clip.xy), clip.ww)) ? clip : vec4(0.0, 0.0, 2.0, 1.0);
}
// Section 3.3; where it has no value it is larger than every point.
float attenuatedSize(float size, vec3 k, float range) {
  float denominator = k.x + (k.y + k.z * range) * range;
  return denominator > 0.0 ? size * inversesqrt(denominator) : 1e30;
}

void main() {
  gl_Position = modelviewProjection * position;
  vec4 eye = modelview * position;
  vec3 point = eyePoint(eye);
  frontColor = color;
  gl_Position = clippedByCenter(gl_Position);
  gl_PointSize = clamp(attenuatedSize(size, sizeAttenuation, length(point)), sizeRange.x, sizeRange.y);
}
