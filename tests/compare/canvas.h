// What scenes draw with.
#pragma once

#include <EGL/egl.h>
#include <GLES/gl.h>
#include <GLES/glext.h>

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace comparison {

// The worker moves all geometry by (x, y) pixels; scenes keep it through projection() and viewport().
void setShift(double x, double y);
// Replaces glLoadIdentity for the projection matrix, which it makes current.
void projection();
// glViewport, and the projection of that size. The modelview matrix is current afterwards.
void viewport(int x, int y, int width, int height);
// A perspective projection of 60 degrees; the modelview matrix is current afterwards.
void perspective(double nearPlane = 1, double farPlane = 10);

// An extension's command. Throws std::runtime_error when the implementation has none of the name.
template <class Command>
Command command(const char* name) {
  const auto found = reinterpret_cast<Command>(eglGetProcAddress(name));
  if (!found) throw std::runtime_error(std::string("no ") + name);
  return found;
}

void clear(float red, float green, float blue, float alpha);

using Texel = std::array<std::uint8_t, 4>;

struct Mesh {
  std::vector<GLfloat> positions, normals, texCoords;  // three, three, two a vertex; each may be empty
  std::vector<GLfloat> colors;                         // four a vertex
  std::vector<GLushort> indices;                       // empty: in order
  void draw(GLenum mode = GL_TRIANGLES) const;
};

Mesh rectangle(double x0, double y0, double x1, double y1, double z = 0);
// (x, y) in [-1, 1], texture coordinates in [0, 1], normals to +z.
Mesh plane(int cells);
Mesh sphere(int slices, int stacks);
// A full-screen rectangle whose texture coordinates run from (s0, t0) to (s1, t1).
Mesh textured(double s0, double t0, double s1, double t1);

// A textured floor that runs from magnification to strong minification.
void drawFloor();

// Makes and binds a texture of the active unit, enabled, NEAREST, REPEAT; texels as RGBA, reduced to
// `format`.
GLuint texture(int width, int height, Texel (*texel)(int x, int y), GLenum format = GL_RGBA);
void level(int level, int width, int height, Texel (*texel)(int x, int y), GLenum format = GL_RGBA,
           GLenum target = GL_TEXTURE_2D);
void filter(GLenum minFilter, GLenum magFilter, GLenum target = GL_TEXTURE_2D);
void wrap(GLenum s, GLenum t);
void environment(GLenum mode);

Texel checker(int x, int y);
Texel noise(int x, int y);
Texel ramp(int x, int y);

// LIGHT0 with these diffuse and specular grey levels at a position in eye coordinates.
void light(std::array<float, 4> position, float diffuse = 0.8f, float specular = 0, GLenum name = GL_LIGHT0);
void material(std::array<float, 4> diffuse, float specular = 0, float shininess = 0);

}  // namespace comparison
