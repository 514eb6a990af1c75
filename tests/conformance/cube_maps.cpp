// OES_texture_cube_map: faces, completeness, texture coordinate generation.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "harness.h"
#include "reference_math.h"

namespace conformance {
namespace {

constexpr GLenum kCube = GL_TEXTURE_CUBE_MAP_OES;

class CubeMaps : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (!hasExtension("GL_OES_texture_cube_map")) GTEST_SKIP() << "no GL_OES_texture_cube_map";
    texGeni_ = reinterpret_cast<PFNGLTEXGENIOESPROC>(eglGetProcAddress("glTexGeniOES"));
    getTexGeniv_ = reinterpret_cast<PFNGLGETTEXGENIVOESPROC>(eglGetProcAddress("glGetTexGenivOES"));
    ASSERT_TRUE(texGeni_ && getTexGeniv_);
    glGenTextures(1, &name_);
    glBindTexture(kCube, name_);
    useNearest(kCube);
    glTexParameteri(kCube, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(kCube, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  }

  static Vec4 texelColor(int face, int x, int y) {
    return {(face * 40 + 15) / 255.0, (x * 60 + 10) / 255.0, (y * 60 + 10) / 255.0, 1};
  }
  // Six 4x4 faces whose texels say where they are.
  static void uploadFaces(GLint level = 0, int size = 4) {
    for (int face = 0; face < 6; ++face) uploadFace(face, level, size);
  }
  static void uploadFace(int face, GLint level = 0, int size = 4) {
    std::vector<GLubyte> texels;
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        for (double c : texelColor(face, x, y)) texels.push_back(static_cast<GLubyte>(std::lround(c * 255)));
      }
    }
    glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + static_cast<GLenum>(face), level, GL_RGBA, size, size,
                 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  }

  PFNGLTEXGENIOESPROC texGeni_ = nullptr;
  PFNGLGETTEXGENIVOESPROC getTexGeniv_ = nullptr;
  GLuint name_ = 0;
};

struct Looked {
  int face;
  double s, t;
};

// The table of major axes (3.8.10 of the extension).
Looked lookUp(const Vec3& r) {
  const double ax = std::abs(r[0]), ay = std::abs(r[1]), az = std::abs(r[2]);
  double sc = 0, tc = 0, ma = 0;
  int face = 0;
  if (ax >= ay && ax >= az) {
    face = r[0] > 0 ? 0 : 1;
    sc = r[0] > 0 ? -r[2] : r[2];
    tc = -r[1];
    ma = ax;
  } else if (ay >= az) {
    face = r[1] > 0 ? 2 : 3;
    sc = r[0];
    tc = r[1] > 0 ? r[2] : -r[2];
    ma = ay;
  } else {
    face = r[2] > 0 ? 4 : 5;
    sc = r[2] > 0 ? r[0] : -r[0];
    tc = -r[1];
    ma = az;
  }
  return {face, (sc / ma + 1) / 2, (tc / ma + 1) / 2};
}

// Whether the direction is safely inside of one texel of one face.
bool decided(const Vec3& r) {
  std::array<double, 3> a = {std::abs(r[0]), std::abs(r[1]), std::abs(r[2])};
  std::sort(a.begin(), a.end());
  const Looked looked = lookUp(r);
  const double u = looked.s * 4, v = looked.t * 4;
  return a[2] - a[1] > 0.02 && std::abs(u - std::round(u)) > 0.02 && std::abs(v - std::round(v)) > 0.02;
}

Vec3 randomDirection(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return normalised({normal(random), normal(random), normal(random)});
}

TEST_F(CubeMaps, Queries) {
  EXPECT_FALSE(glIsEnabled(kCube));
  EXPECT_FALSE(glIsEnabled(GL_TEXTURE_GEN_STR_OES));
  GLint value = -1;
  glGetIntegerv(GL_TEXTURE_BINDING_CUBE_MAP_OES, &value);
  EXPECT_EQ(value, static_cast<GLint>(name_));
  glGetIntegerv(GL_MAX_CUBE_MAP_TEXTURE_SIZE_OES, &value);
  EXPECT_GE(value, 16);
  getTexGeniv_(GL_TEXTURE_GEN_STR_OES, GL_TEXTURE_GEN_MODE_OES, &value);
  EXPECT_EQ(value, GL_REFLECTION_MAP_OES);
  texGeni_(GL_TEXTURE_GEN_STR_OES, GL_TEXTURE_GEN_MODE_OES, GL_NORMAL_MAP_OES);
  getTexGeniv_(GL_TEXTURE_GEN_STR_OES, GL_TEXTURE_GEN_MODE_OES, &value);
  EXPECT_EQ(value, GL_NORMAL_MAP_OES);
}

TEST_F(CubeMaps, Errors) {
  const std::vector<GLubyte> texels(64 * 4);
  glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES, 0, GL_RGBA, 4, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               texels.data());
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  glCopyTexImage2D(GL_TEXTURE_CUBE_MAP_NEGATIVE_Z_OES, 0, GL_RGBA, 0, 0, 4, 2, 0);
  EXPECT_GL_ERROR(GL_INVALID_VALUE);
  glTexImage2D(kCube, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  glBindTexture(GL_TEXTURE_2D, name_);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  GLuint flat = 0;
  glGenTextures(1, &flat);
  glBindTexture(GL_TEXTURE_2D, flat);
  glBindTexture(kCube, flat);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION);
  glTexParameteri(GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES, GL_TEXTURE_WRAP_S, GL_REPEAT);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  texGeni_(GL_TEXTURE_GEN_STR_OES, GL_TEXTURE_GEN_MODE_OES, GL_REPEAT);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
  texGeni_(GL_TEXTURE_2D, GL_TEXTURE_GEN_MODE_OES, GL_NORMAL_MAP_OES);
  EXPECT_GL_ERROR(GL_INVALID_ENUM);
}

TEST_F(CubeMaps, EveryDirection) {
  uploadFaces();
  glEnable(kCube);
  std::mt19937 random(3);
  Cells cells;
  for (int i = 0; i < 500; ++i) {
    const Vec3 r = scaled(randomDirection(random), i % 2 ? 0.01 : 7);
    if (!decided(scaled(r, 1 / length(r)))) continue;
    const Looked looked = lookUp(r);
    cells.add(fmt::format("{} {} {}", r[0], r[1], r[2]),
              texelColor(looked.face, static_cast<int>(looked.s * 4), static_cast<int>(looked.t * 4)), [&] {
                glMultiTexCoord4f(GL_TEXTURE0, static_cast<GLfloat>(r[0]), static_cast<GLfloat>(r[1]),
                                  static_cast<GLfloat>(r[2]), 1);
                drawRect();
              });
  }
}

// Cube map texturing wins where both are enabled (3.8.10).
TEST_F(CubeMaps, BeforeTwoDimensional) {
  uploadFaces();
  solidTexture(GL_RGBA, {255, 255, 255, 255});
  glEnable(GL_TEXTURE_2D);
  glEnable(kCube);
  glMultiTexCoord4f(GL_TEXTURE0, 1, 0.1f, 0.1f, 1);
  drawRect();
  EXPECT_PIXEL(32, 32, texelColor(0, 1, 1));
  glDisable(kCube);
  drawRect();
  EXPECT_PIXEL(32, 32, {1, 1, 1, 1});
}

TEST_F(CubeMaps, Completeness) {
  glEnable(kCube);
  glColor4f(0, 1, 0, 1);
  glMultiTexCoord4f(GL_TEXTURE0, 1, 0.1f, 0.1f, 1);
  const Vec4 green = {0, 1, 0, 1};
  for (int face = 0; face < 5; ++face) uploadFace(face);
  drawRect();
  EXPECT_PIXEL(32, 32, green) << "a face is missing";
  uploadFace(5, 0, 2);
  drawRect();
  EXPECT_PIXEL(32, 32, green) << "a face is smaller";
  uploadFace(5);
  drawRect();
  EXPECT_PIXEL(32, 32, texelColor(0, 1, 1));
  glTexParameteri(kCube, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  drawRect();
  EXPECT_PIXEL(32, 32, green) << "no mipmaps";
  uploadFaces(1, 2);
  for (int face = 0; face < 5; ++face) uploadFace(face, 2, 1);
  drawRect();
  EXPECT_PIXEL(32, 32, green) << "one face has no last level";
  uploadFace(5, 2, 1);
  drawRect();
  EXPECT_PIXEL(32, 32, texelColor(0, 1, 1));
}

TEST_F(CubeMaps, NormalMap) {
  MESA_DISAGREES("2.11.4 of OES_texture_cube_map", "NORMAL_MAP does not give the normal");
  uploadFaces();
  glEnable(kCube);
  glEnable(GL_TEXTURE_GEN_STR_OES);
  glEnable(GL_NORMALIZE);
  texGeni_(GL_TEXTURE_GEN_STR_OES, GL_TEXTURE_GEN_MODE_OES, GL_NORMAL_MAP_OES);
  std::mt19937 random(4);
  Cells cells;
  for (int i = 0; i < 100; ++i) {
    const Vec3 normal = randomDirection(random);
    const Mat4 matrix = rotation(i * 11 % 80 - 40, 1, 2, i % 3);
    const Vec3 eye = normalised(transformedNormal(matrix, normal));
    if (!decided(eye)) continue;
    const Looked looked = lookUp(eye);
    cells.add(fmt::format("normal {}", i),
              texelColor(looked.face, static_cast<int>(looked.s * 4), static_cast<int>(looked.t * 4)), [&] {
                glMatrixMode(GL_PROJECTION);
                glLoadIdentity();
                glScalef(1, 1, 0);
                glMatrixMode(GL_MODELVIEW);
                glLoadIdentity();
                glRotatef(static_cast<GLfloat>(i * 11 % 80 - 40), 1, 2, static_cast<GLfloat>(i % 3));
                glNormal3f(static_cast<GLfloat>(normal[0]), static_cast<GLfloat>(normal[1]),
                           static_cast<GLfloat>(normal[2]));
                drawRect({-500, -500, 500, 500});
              });
  }
}

// r = u - 2 n (n . u), u the unit vector from the eye to the vertex (2.11.4 of OpenGL 1.5); n of any length
// under NORMALIZE.
TEST_F(CubeMaps, ReflectionMap) {
  uploadFaces();
  glEnable(kCube);
  glEnable(GL_TEXTURE_GEN_STR_OES);
  std::mt19937 random(9);
  Cells cells;
  for (int i = 0; i < 100; ++i) {
    const Vec3 n = randomDirection(random), direction = randomDirection(random);
    const Vec3 point = scaled(direction, 4);
    const Vec3 u = normalised(point);
    const Vec3 r = added(u, scaled(n, -2 * dot(n, u)));
    if (!decided(r)) continue;
    const Looked looked = lookUp(r);
    cells.add(fmt::format("reflection {}", i),
              texelColor(looked.face, static_cast<int>(looked.s * 4), static_cast<int>(looked.t * 4)), [&] {
                // A tiny quad around the point, blown up to the viewport by the projection.
                constexpr double h = 1e-3;
                glMatrixMode(GL_PROJECTION);
                glLoadIdentity();
                glScalef(static_cast<GLfloat>(1 / h), static_cast<GLfloat>(1 / h), 0);
                glTranslatef(static_cast<GLfloat>(-point[0]), static_cast<GLfloat>(-point[1]), 0);
                glMatrixMode(GL_MODELVIEW);
                glNormal3f(static_cast<GLfloat>(n[0]), static_cast<GLfloat>(n[1]),
                           static_cast<GLfloat>(n[2]));
                std::vector<GLfloat> longer;
                for (std::size_t k = 0; k < 12; ++k) longer.push_back(static_cast<GLfloat>(3 * n[k % 3]));
                if (i % 2) {
                  glEnable(GL_NORMALIZE);
                  glEnableClientState(GL_NORMAL_ARRAY);
                  glNormalPointer(GL_FLOAT, 0, longer.data());
                }
                drawRect({point[0] - 2 * h, point[1] - 2 * h, point[0] + 2 * h, point[1] + 2 * h, point[2]});
                glDisable(GL_NORMALIZE);
                glDisableClientState(GL_NORMAL_ARRAY);
              });
  }
}

// The texture matrix applies to generated coordinates as well.
TEST_F(CubeMaps, TextureMatrixAfterGeneration) {
  MESA_DISAGREES("2.11.4 of OES_texture_cube_map", "NORMAL_MAP does not give the normal");
  uploadFaces();
  glEnable(kCube);
  glEnable(GL_TEXTURE_GEN_STR_OES);
  texGeni_(GL_TEXTURE_GEN_STR_OES, GL_TEXTURE_GEN_MODE_OES, GL_NORMAL_MAP_OES);
  glNormal3f(0.1f, 0.1f, 1);
  drawRect();
  const Looked before = lookUp({0.1, 0.1, 1});
  EXPECT_PIXEL(32, 32,
               texelColor(before.face, static_cast<int>(before.s * 4), static_cast<int>(before.t * 4)));
  glMatrixMode(GL_TEXTURE);
  glRotatef(90, 0, 1, 0);
  drawRect();
  const Looked after = lookUp({1, 0.1, -0.1});
  EXPECT_PIXEL(32, 32, texelColor(after.face, static_cast<int>(after.s * 4), static_cast<int>(after.t * 4)));
}

// 3.8.2 of the extension: copies and subimages go to one face and leave the others.
TEST_F(CubeMaps, CopiesAndSubImages) {
  uploadFaces();
  glEnable(kCube);
  glClearColor(0.2f, 0.4f, 0.6f, 0.8f);
  glClear(GL_COLOR_BUFFER_BIT);
  glCopyTexImage2D(GL_TEXTURE_CUBE_MAP_NEGATIVE_Y_OES, 0, GL_RGBA, 0, 0, 4, 4, 0);
  const std::vector<GLubyte> white(2 * 2 * 4, 255);
  glTexSubImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_Z_OES, 0, 2, 2, 2, 2, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
  glCopyTexSubImage2D(GL_TEXTURE_CUBE_MAP_NEGATIVE_X_OES, 0, 0, 0, 0, 0, 2, 4);
  EXPECT_GL_ERROR(GL_NO_ERROR);
  const auto at = [&](GLfloat x, GLfloat y, GLfloat z) {
    glMultiTexCoord4f(GL_TEXTURE0, x, y, z, 1);
    drawRect();
    return readPixel(32, 32);
  };
  const Vec4 copied = {0.2, 0.4, 0.6, 0.8};
  EXPECT_TRUE(near(at(0.1f, -1, 0.1f), copied));
  EXPECT_TRUE(near(at(0.7f, -1, -0.7f), copied));
  EXPECT_TRUE(near(at(0.1f, 1, 0.1f), texelColor(2, 2, 2)));
  // +z: s follows x, t runs against y.
  EXPECT_TRUE(near(at(0.7f, -0.7f, 1), {1, 1, 1, 1}));
  EXPECT_TRUE(near(at(-0.7f, -0.7f, 1), texelColor(4, 0, 3)));
  // -x: s follows z.
  EXPECT_TRUE(near(at(-1, 0.1f, -0.7f), copied));
  EXPECT_TRUE(near(at(-1, 0.1f, 0.7f), texelColor(1, 3, 1)));
}

// 3.8.8: GENERATE_MIPMAP works face by face.
TEST_F(CubeMaps, GenerateMipmap) {
  glTexParameteri(kCube, GL_GENERATE_MIPMAP, GL_TRUE);
  glTexParameteri(kCube, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  for (GLenum face = 0; face < 6; ++face) {
    const std::vector<GLubyte> texels(4 * 4 * 4, static_cast<GLubyte>(40 * face + 20));
    glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + face, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 texels.data());
  }
  glEnable(kCube);
  for (int face = 0; face < 6; ++face) {
    Vec3 direction = {0.1, 0.1, 0.1};
    direction[static_cast<std::size_t>(face / 2)] = face % 2 ? -1 : 1;
    glMultiTexCoord4f(GL_TEXTURE0, static_cast<GLfloat>(direction[0]), static_cast<GLfloat>(direction[1]),
                      static_cast<GLfloat>(direction[2]), 1);
    drawRect();
    const double value = (40 * face + 20) / 255.0;
    EXPECT_PIXEL(32, 32, {value, value, value, value}) << face;
  }
}

// 3.8.8: the default cube map and the default two-dimensional texture are two objects.
TEST_F(CubeMaps, Defaults) {
  glBindTexture(kCube, 0);
  glTexParameteri(kCube, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  GLint filter = 0;
  glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, &filter);
  EXPECT_EQ(filter, GL_NEAREST_MIPMAP_LINEAR);
  glGetTexParameteriv(kCube, GL_TEXTURE_MIN_FILTER, &filter);
  EXPECT_EQ(filter, GL_LINEAR);
  glBindTexture(kCube, name_);
  glGetTexParameteriv(kCube, GL_TEXTURE_MIN_FILTER, &filter);
  EXPECT_EQ(filter, GL_NEAREST);
  glDeleteTextures(1, &name_);
  GLint binding = -1;
  glGetIntegerv(GL_TEXTURE_BINDING_CUBE_MAP_OES, &binding);
  EXPECT_EQ(binding, 0);
}

}  // namespace
}  // namespace conformance
