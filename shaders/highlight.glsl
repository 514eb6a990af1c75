// Expects: facing
// The specular factor: only where the light is in front of the surface.
float highlight(vec3 normal, vec3 toLight, vec3 halfVector, float shininess) {
  return facing(normal, toLight) != 0.0 ? pow(facing(normal, halfVector), shininess) : 0.0;
}
