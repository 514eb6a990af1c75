// Expects: facing
// The specular factor with shininess 0.
float flatHighlight(vec3 normal, vec3 toLight) { return facing(normal, toLight) != 0.0 ? 1.0 : 0.0; }
