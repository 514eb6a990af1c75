#include "canvas.h"

#include <cmath>
#include <numbers>

namespace comparison {

namespace {

struct View {
  double shiftX = 0, shiftY = 0;  // pixels
  int width = 1, height = 1;
};
View view;

std::vector<std::uint8_t> reduced(int width, int height, Texel (*texel)(int, int), GLenum format) {
  std::vector<std::uint8_t> result;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Texel t = texel(x, y);
      switch (format) {
        case GL_ALPHA:
          result.push_back(t[3]);
          break;
        case GL_LUMINANCE:
          result.push_back(t[0]);
          break;
        case GL_LUMINANCE_ALPHA:
          result.insert(result.end(), {t[0], t[3]});
          break;
        case GL_RGB:
          result.insert(result.end(), {t[0], t[1], t[2]});
          break;
        default:
          result.insert(result.end(), t.begin(), t.end());
      }
    }
  }
  return result;
}

}  // namespace

void setShift(double x, double y) {
  view.shiftX = x;
  view.shiftY = y;
}

void projection() {
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  if (view.shiftX == 0 && view.shiftY == 0) return;
  glTranslatef(static_cast<GLfloat>(2 * view.shiftX / view.width),
               static_cast<GLfloat>(2 * view.shiftY / view.height), 0);
}

void viewport(int x, int y, int width, int height) {
  glViewport(x, y, width, height);
  view.width = width;
  view.height = height;
  projection();
  glMatrixMode(GL_MODELVIEW);
}

void perspective(double nearPlane, double farPlane) {
  projection();
  const double half = nearPlane * std::tan(std::numbers::pi / 6);
  const auto side = static_cast<GLfloat>(half);
  glFrustumf(-side, side, -side, side, static_cast<GLfloat>(nearPlane), static_cast<GLfloat>(farPlane));
  glMatrixMode(GL_MODELVIEW);
}

void clear(float red, float green, float blue, float alpha) {
  glClearColor(red, green, blue, alpha);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

void Mesh::draw(GLenum mode) const {
  const auto use = [](GLenum array, const std::vector<GLfloat>& values) {
    values.empty() ? glDisableClientState(array) : glEnableClientState(array);
  };
  use(GL_VERTEX_ARRAY, positions);
  use(GL_NORMAL_ARRAY, normals);
  use(GL_TEXTURE_COORD_ARRAY, texCoords);
  use(GL_COLOR_ARRAY, colors);
  glVertexPointer(3, GL_FLOAT, 0, positions.data());
  if (!normals.empty()) glNormalPointer(GL_FLOAT, 0, normals.data());
  if (!texCoords.empty()) glTexCoordPointer(2, GL_FLOAT, 0, texCoords.data());
  if (!colors.empty()) glColorPointer(4, GL_FLOAT, 0, colors.data());
  if (indices.empty())
    glDrawArrays(mode, 0, static_cast<GLsizei>(positions.size() / 3));
  else
    glDrawElements(mode, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_SHORT, indices.data());
}

Mesh rectangle(double x0, double y0, double x1, double y1, double z) {
  const auto a = static_cast<GLfloat>(x0), b = static_cast<GLfloat>(y0), c = static_cast<GLfloat>(x1),
             d = static_cast<GLfloat>(y1), e = static_cast<GLfloat>(z);
  Mesh mesh;
  mesh.positions = {a, b, e, c, b, e, c, d, e, a, b, e, c, d, e, a, d, e};
  return mesh;
}

// Vertices on a grid of (columns + 1) x (rows + 1), two triangles a cell.
static void addGridIndices(Mesh& mesh, int columns, int rows) {
  const auto at = [columns](int x, int y) { return static_cast<GLushort>(y * (columns + 1) + x); };
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      mesh.indices.insert(mesh.indices.end(), {at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y),
                                               at(x + 1, y + 1), at(x, y + 1)});
    }
  }
}

Mesh plane(int cells) {
  Mesh mesh;
  for (int y = 0; y <= cells; ++y) {
    for (int x = 0; x <= cells; ++x) {
      const float s = static_cast<float>(x) / static_cast<float>(cells);
      const float t = static_cast<float>(y) / static_cast<float>(cells);
      mesh.positions.insert(mesh.positions.end(), {2 * s - 1, 2 * t - 1, 0});
      mesh.normals.insert(mesh.normals.end(), {0, 0, 1});
      mesh.texCoords.insert(mesh.texCoords.end(), {s, t});
    }
  }
  addGridIndices(mesh, cells, cells);
  return mesh;
}

Mesh sphere(int slices, int stacks) {
  Mesh mesh;
  for (int y = 0; y <= stacks; ++y) {
    for (int x = 0; x <= slices; ++x) {
      const double s = static_cast<double>(x) / slices, t = static_cast<double>(y) / stacks;
      const double a = 2 * std::numbers::pi * s, b = std::numbers::pi * (t - 0.5);
      const auto px = static_cast<GLfloat>(std::cos(b) * std::sin(a));
      const auto py = static_cast<GLfloat>(std::sin(b));
      const auto pz = static_cast<GLfloat>(std::cos(b) * std::cos(a));
      mesh.positions.insert(mesh.positions.end(), {px, py, pz});
      mesh.normals.insert(mesh.normals.end(), {px, py, pz});
      mesh.texCoords.insert(mesh.texCoords.end(), {static_cast<GLfloat>(s), static_cast<GLfloat>(t)});
    }
  }
  addGridIndices(mesh, slices, stacks);
  return mesh;
}

void drawFloor() {
  perspective(0.5, 60);
  glTranslatef(0, -0.6f, -8);
  glRotatef(-80, 1, 0, 0);
  glScalef(8, 8, 1);
  Mesh mesh = plane(1);
  for (GLfloat& t : mesh.texCoords) t *= 8;
  mesh.draw();
}

Mesh textured(double s0, double t0, double s1, double t1) {
  Mesh mesh = rectangle(-1, -1, 1, 1);
  const auto a = static_cast<GLfloat>(s0), b = static_cast<GLfloat>(t0), c = static_cast<GLfloat>(s1),
             d = static_cast<GLfloat>(t1);
  mesh.texCoords = {a, b, c, b, c, d, a, b, c, d, a, d};
  return mesh;
}

GLuint texture(int width, int height, Texel (*texel)(int x, int y), GLenum format) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  filter(GL_NEAREST, GL_NEAREST);
  level(0, width, height, texel, format);
  glEnable(GL_TEXTURE_2D);
  return name;
}

void level(int level, int width, int height, Texel (*texel)(int x, int y), GLenum format, GLenum target) {
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(target, level, static_cast<GLint>(format), width, height, 0, format, GL_UNSIGNED_BYTE,
               reduced(width, height, texel, format).data());
}

void filter(GLenum minFilter, GLenum magFilter, GLenum target) {
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(minFilter));
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(magFilter));
}

void wrap(GLenum s, GLenum t) {
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, static_cast<GLint>(s));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, static_cast<GLint>(t));
}

void environment(GLenum mode) {
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, static_cast<GLint>(mode));
}

Texel checker(int x, int y) {
  return (x + y) % 2 != 0 ? Texel{230, 60, 20, 255} : Texel{30, 90, 220, 80};
}

Texel noise(int x, int y) {
  auto h = static_cast<std::uint32_t>(x) * 0x9e3779b1u + static_cast<std::uint32_t>(y) * 0x85ebca77u + 1;
  h = (h ^ (h >> 15)) * 0x2c1b3c6du;
  h = (h ^ (h >> 12)) * 0x297a2d39u;
  h ^= h >> 15;
  return {static_cast<std::uint8_t>(h), static_cast<std::uint8_t>(h >> 8), static_cast<std::uint8_t>(h >> 16),
          static_cast<std::uint8_t>(h >> 24)};
}

Texel ramp(int x, int y) {
  return {static_cast<std::uint8_t>(x * 16), static_cast<std::uint8_t>(y * 16),
          static_cast<std::uint8_t>(255 - x * 8), static_cast<std::uint8_t>(128 + y * 4)};
}

void light(std::array<float, 4> position, float diffuse, float specular, GLenum name) {
  const GLfloat d[] = {diffuse, diffuse, diffuse, 1}, s[] = {specular, specular, specular, 1};
  glEnable(GL_LIGHTING);
  glEnable(name);
  glLightfv(name, GL_POSITION, position.data());
  glLightfv(name, GL_DIFFUSE, d);
  glLightfv(name, GL_SPECULAR, s);
}

void material(std::array<float, 4> diffuse, float specular, float shininess) {
  const GLfloat s[] = {specular, specular, specular, 1};
  glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, diffuse.data());
  glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, s);
  glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, shininess);
}

}  // namespace comparison
