// vertex position=float normal=float color=float shade=lit two-sided color-material specular shininess lights=2 positional=2 attenuated=2 spot=2 spot-exponent=2
#version 450

layout(push_constant) uniform Push {
  mat4 modelviewProjection;
  mat4 modelview;
};
layout(std140, set = 0, binding = 0) uniform Vertex {
  mat3 normalMatrix;
  vec3 sceneAmbient;
  vec3 emission;
  float shininess;
  vec3 light0Direction;
  vec3 light0Half;
  vec3 light0Diffuse;
  vec3 light0Specular;
  vec3 light1Position;
  float light1CosCutoff;
  vec3 light1SpotDirection;
  float light1SpotExponent;
  vec3 light1Attenuation;
  vec3 light1Ambient;
  vec3 light1Diffuse;
  vec3 light1Specular;
};
layout(location = 0) in vec4 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 color;
out gl_PerVertex {
  vec4 gl_Position;
};
invariant gl_Position;
layout(location = 0) out vec4 frontColor;
layout(location = 1) out vec4 backColor;

// Eye coordinates divided by w.
vec3 eyePoint(vec4 eye) { return eye.w == 1.0 || eye.w == 0.0 ? eye.xyz : eye.xyz / eye.w; }
// The product of directions of section 2.12.1.
float facing(vec3 a, vec3 b) { return max(dot(a, b), 0.0); }
// The specular factor: only where the light is in front of the surface.
float highlight(vec3 normal, vec3 toLight, vec3 halfVector, float shininess) {
  return facing(normal, toLight) != 0.0 ? pow(facing(normal, halfVector), shininess) : 0.0;
}
// A unit vector; 0 for 0. Scaled first, so that no square leaves the range of a float.
vec3 safeNormalize(vec3 v) {
  float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
  vec3 scaled = v / largest;
  return largest > 0.0 ? scaled * inversesqrt(dot(scaled, scaled)) : vec3(0.0);
}
// Equation 2.4; no attenuation where it has no value.
float attenuation(vec3 k, float range) {
  float denominator = k.x + (k.y + k.z * range) * range;
  return denominator > 0.0 ? 1.0 / denominator : 1.0;
}
// Equation 2.5.
float spot(vec3 toLight, vec3 direction, float cosCutoff, float exponent) {
  float cosine = facing(-toLight, direction);
  return cosine >= cosCutoff ? pow(cosine, exponent) : 0.0;
}
// Equation 2.3: the viewer is at infinity, on the z axis.
vec3 halfway(vec3 toLight) { return safeNormalize(toLight + vec3(0.0, 0.0, 1.0)); }
vec4 saturate(vec4 v) { return clamp(v, 0.0, 1.0); }

vec4 illuminate(vec3 normal, vec3 point, vec4 color) {
  vec3 matte = sceneAmbient;
  vec3 shiny = vec3(0.0);
  matte += facing(normal, light0Direction) * light0Diffuse;
  shiny += highlight(normal, light0Direction, light0Half, shininess) * light0Specular;
  vec3 offset1 = light1Position - point;
  vec3 toLight1 = safeNormalize(offset1);
  float factor1 = attenuation(light1Attenuation, length(offset1));
  factor1 *= spot(toLight1, light1SpotDirection, light1CosCutoff, light1SpotExponent);
  matte += factor1 * (light1Ambient + facing(normal, toLight1) * light1Diffuse);
  shiny += factor1 * highlight(normal, toLight1, halfway(toLight1), shininess) * light1Specular;
  return saturate(vec4(emission + color.rgb * matte + shiny, color.a));
}

void main() {
  gl_Position = modelviewProjection * position;
  vec4 eye = modelview * position;
  vec3 point = eyePoint(eye);
  vec3 eyeNormal = normalMatrix * normal;
  frontColor = illuminate(eyeNormal, point, color);
  backColor = illuminate(-eyeNormal, point, color);
}
