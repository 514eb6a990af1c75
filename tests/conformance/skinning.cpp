// OES_matrix_palette: vertices and normals against sums of their weighted matrices that are made here, and
// what follows from eye coordinates.
#include <fmt/format.h>

#include "lighting_reference.h"
#include "palette_fixture.h"

namespace conformance {
namespace {

class Skinning : public PaletteFixture {};

Vec4 blend(const Choices& choices, const std::vector<Mat4>& palette, const Vec4& vertex) {
  Vec4 sum{};
  for (const Choice& choice : choices) {
    const Vec4 term = palette[choice.index] * vertex;
    for (std::size_t i = 0; i < 4; ++i) sum[i] += choice.weight * term[i];
  }
  return sum;
}

// Weights are what they are: the sum scales w, too, and clip coordinates with it.
TEST_F(Skinning, WeightsThatDoNotSumToOne) {
  const std::vector<Mat4> palette = {translation(0.5, 0, 0), translation(0, 0.5, 0), scaling(0.5, 0.25, 1),
                                     translation(-0.25, -0.25, 0)};
  for (GLuint i = 0; i < palette.size(); ++i) setMatrix(i, palette[i]);
  const std::vector<Choices> rows = {
      {{0, 1}, {1, 1}}, {{0, 0.125}, {1, 0.125}},         {{0, 2}, {1, -1}},
      {{0, 0.5}},       {{0, 4}, {1, 2}, {2, 1}, {3, 2}}, {{2, 0.25}, {3, 0.25}, {3, 0.5}}};
  for (const Choices& choices : rows) {
    drawChosen(choices, kHalf);
    const Vec4 low = blend(choices, palette, {-0.5, -0.5, 0, 1}),
               high = blend(choices, palette, {0.5, 0.5, 0, 1});
    expectRect(low[0] / low[3], low[1] / low[3], high[0] / high[3], high[1] / high[3],
               fmt::format("{} weights, the first {}", choices.size(), choices[0].weight));
  }
  drawChosen({{0, 1}, {1, -1}}, kHalf);  // w is 0
  expectRect(0, 0, 0, 0, "weights that cancel");
}

// A last row other than (0, 0, 0, 1): a matrix that projects.
TEST_F(Skinning, ProjectiveMatrices) {
  Mat4 twice;
  twice.at(3, 3) = 2;  // half the size
  setMatrix(4, twice);
  drawChosen({{4, 1}}, kFull);
  expectRect(-0.5, -0.5, 0.5, 0.5, "w is 2");
  setMatrix(5, translation(0.5, 0, 0));
  drawChosen({{4, 0.5}, {5, 0.5}}, kHalf);  // ((x + x + 0.5) / 2) / 1.5
  expectRect((-0.5 + 0.25) / 1.5, -0.5 / 1.5, (0.5 + 0.25) / 1.5, 0.5 / 1.5, "blended");
}

class SkinningOnNormals : public PaletteFixture {
 protected:
  void SetUp() override {
    PaletteFixture::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    material_.ambient = {0, 0, 0, 1};
    material_.diffuse = {1, 1, 1, 1};
    lights_[0].position = {0.2, 0.4, 1, 0};
    lights_[0].diffuse = {0.9, 0.2, 0.1, 1};
    lights_[1].position = {3, -1, 2, 1};
    lights_[1].diffuse = {0.1, 0.3, 0.6, 1};
    lights_[1].specular = {0.2, 0.2, 0.2, 1};
    lights_[1].linearAttenuation = 0.1;
    material_.specular = {0.5, 1, 0.5, 1};
    material_.shininess = 3;
    applySceneAmbient({0, 0, 0, 1});
    applyMaterial(material_);
    applyLights(lights_);
    glEnable(GL_LIGHTING);
    glNormal3f(kNormal[0], kNormal[1], kNormal[2]);
  }

  // sum of w_i * f_i * (n Mu_i^-1), normalised if asked to.
  static Vec3 expectedNormal(const Choices& choices, const std::vector<Mat4>& palette, GLenum how) {
    Vec3 sum{};
    for (const Choice& choice : choices) {
      const Mat4& m = palette[choice.index];
      const double factor = how == GL_RESCALE_NORMAL ? rescaleFactor(m) : 1;
      const Vec3 normal = transformedNormal(m, {kNormal[0], kNormal[1], kNormal[2]});
      sum = added(sum, scaled(normal, choice.weight * factor));
    }
    return how == GL_NORMALIZE ? normalised(sum) : sum;
  }

  // The color at the centre of the cell, whose vertices all lie in the same place but for x and y.
  void addRow(Cells& cells, const std::string& name, const Choices& choices, const std::vector<Mat4>& palette,
              GLenum how) {
    const Vec4 centre = blend(choices, palette, {0, 0, 0, 1});
    const Vec4 eye = {centre[0] / centre[3], centre[1] / centre[3], centre[2] / centre[3], 1};
    const Vec4 expected =
        litColor(material_, {0, 0, 0, 1}, lights_, eye, expectedNormal(choices, palette, how));
    constexpr GLfloat kTiny[] = {-0.02f, -0.02f, 0.02f, -0.02f, -0.02f, 0.02f, 0.02f, 0.02f};
    cells.add(
        fmt::format("{} {:#x}", name, how), expected,
        [&] {
          glMatrixMode(GL_PROJECTION);  // shows the quad, whatever its matrices did to it
          glLoadIdentity();
          glScalef(200, 200, 0.01f);
          glTranslatef(static_cast<GLfloat>(-eye[0]), static_cast<GLfloat>(-eye[1]), 0);
          if (how) glEnable(how);
          drawChosen(choices, kTiny);
          if (how) glDisable(how);
        },
        // The quad is not a point: the attenuated light differs at its corners.
        1.5 * kOneStep);
  }

  static constexpr GLfloat kNormal[] = {0.36f, -0.48f, 0.8f};
  MaterialParameters material_;
  std::array<LightParameters, 2> lights_;
};

// Normals go through each matrix's inverse transpose, with NORMALIZE and RESCALE_NORMAL and without.
TEST_F(SkinningOnNormals, InverseTransposes) {
  const std::vector<Mat4> palette = {rotation(30, 1, 2, 0), rotation(-25, 0, 1, 0.5) * translation(0.3, 0, 0),
                                     scaling(1.5, 1.5, 1.5), rotation(20, 0, 1, 0) * scaling(0.8, 1.25, 2),
                                     translation(0, 0.2, 0.1) * scaling(-1, 1, 1)};
  Cells cells;
  const std::vector<Choices> rows = {{{0, 1}},
                                     {{0, 0.25}, {1, 0.75}},
                                     {{2, 1}},
                                     {{3, 1}},
                                     {{4, 1}},
                                     {{0, 0.5}, {3, 0.5}},
                                     {{2, 0.5}, {3, 0.25}, {4, 0.25}},
                                     {{0, 0.4}, {1, 0.3}, {2, 0.2}, {3, 0.1}},
                                     {{0, 0.4}, {1, 0.3}}};
  // First matrices that keep lengths, for which a shader may take them for their own inverse transposes.
  for (std::size_t loaded : {std::size_t{2}, palette.size()}) {
    for (GLuint i = 0; i < loaded; ++i) setMatrix(i, palette[i]);
    for (GLenum how : {0, GL_NORMALIZE, GL_RESCALE_NORMAL}) {
      for (std::size_t row = 0; row < rows.size(); ++row) {
        const Choices& choices = rows[row];
        if (std::ranges::any_of(choices, [&](const Choice& c) { return c.index >= loaded; })) continue;
        addRow(cells, fmt::format("{} matrices, row {}", loaded, row), choices, palette,
               static_cast<GLenum>(how));
      }
    }
  }
}

// An array of normals takes the same road as the current one.
TEST_F(SkinningOnNormals, NormalArray) {
  setMatrix(0, rotation(30, 1, 2, 0) * scaling(2, 1, 0.5));
  setMatrix(1, rotation(-25, 0, 1, 0.5));
  const Choices choices = {{0, 0.5}, {1, 0.5}};
  glEnable(GL_NORMALIZE);
  drawChosen(choices);
  const Image expected = readAll();
  EXPECT_GT(expected.at(32, 32)[0], 0.1);
  for (GLenum type : {GL_FLOAT, GL_FIXED, GL_SHORT, GL_BYTE}) {
    std::vector<GLfloat> floats;
    std::vector<GLfixed> fixed;
    std::vector<GLshort> shorts;
    std::vector<GLbyte> bytes;
    for (int i = 0; i < 12; ++i) {
      const double v = kNormal[i % 3];
      floats.push_back(static_cast<GLfloat>(v));
      fixed.push_back(static_cast<GLfixed>(v * 65536));
      shorts.push_back(static_cast<GLshort>(std::lround((v * 65535 - 1) / 2)));
      bytes.push_back(static_cast<GLbyte>(std::lround((v * 255 - 1) / 2)));
    }
    const void* data = type == GL_FLOAT   ? static_cast<const void*>(floats.data())
                       : type == GL_FIXED ? static_cast<const void*>(fixed.data())
                       : type == GL_SHORT ? static_cast<const void*>(shorts.data())
                                          : static_cast<const void*>(bytes.data());
    glClear(GL_COLOR_BUFFER_BIT);
    glEnableClientState(GL_NORMAL_ARRAY);
    glNormalPointer(static_cast<GLenum>(type), 0, data);
    drawChosen(choices);
    glDisableClientState(GL_NORMAL_ARRAY);
    // A byte tells normals apart by 1/127.
    const double tolerance = type == GL_BYTE ? 3 * kOneStep : kOneStep;
    for (int at : {8, 32, 56}) EXPECT_PIXEL(at, at, expected.at(at, at), tolerance) << std::hex << type;
  }
}

// Collapsed matrices: whatever the normal, colors are finite, and what is not touched stays.
TEST_F(SkinningOnNormals, SingularMatrices) {
  glDisable(GL_LIGHT1);  // it differs over the surface
  const auto light = std::span(lights_).first(1);
  setMatrix(0, scaling(0, 0, 0));
  setMatrix(1, scaling(1, 1, 0));
  setMatrix(2, scaling(1, 0, 0));
  setMatrix(3, scaling(1e-20, 1e-20, 1e-20));
  setMatrix(4, scaling(1e18, 1e18, 1e18));
  const std::vector<Mat4> regular(6);
  for (GLenum how : {0, GL_NORMALIZE, GL_RESCALE_NORMAL}) {
    if (how) glEnable(static_cast<GLenum>(how));
    for (GLubyte index : {0, 1, 2, 3, 4}) {
      for (double weight : {1.0, 0.5, 0.0}) {
        drawChosen({{index, weight}, {5, 1 - weight}});
        EXPECT_GL_ERROR(GL_NO_ERROR);
      }
      glClear(GL_COLOR_BUFFER_BIT);
      drawChosen({{5, 1}});  // the identity
      const Vec4 wanted = litColor(material_, {0, 0, 0, 1}, light, {0, 0, 0, 1},
                                   expectedNormal({{5, 1}}, regular, static_cast<GLenum>(how)));
      EXPECT_PIXEL(32, 32, wanted) << "after matrix " << int{index};
    }
    if (how) glDisable(static_cast<GLenum>(how));
  }
  // Flattened along z, a surface faces along z; the hidden part of a body, shrunk to nothing, adds nothing.
  glEnable(GL_NORMALIZE);
  for (const auto& [choices, normal] : std::vector<std::pair<Choices, Vec3>>{
           {{{1, 1}}, {0, 0, 1}}, {{{0, 0.5}, {5, 0.5}}, {kNormal[0], kNormal[1], kNormal[2]}}}) {
    glClear(GL_COLOR_BUFFER_BIT);
    drawChosen(choices);
    const Vec4 wanted = litColor(material_, {0, 0, 0, 1}, light, {0, 0, 0, 1}, normal);
    EXPECT_PIXEL(32, 32, wanted) << toString(wanted);
  }
}

// User clip planes, fog, texture coordinates and point sizes are made from the blended eye coordinates.
TEST_F(Skinning, ClipPlanes) {
  const GLfloat plane[] = {1, 0, 0, 0};  // x > 0 in eye coordinates, whatever the modelview is later
  glClipPlanef(GL_CLIP_PLANE0, plane);
  glEnable(GL_CLIP_PLANE0);
  glTranslatef(0, 5, 0);
  setMatrix(0, translation(-1, 0, 0));
  setMatrix(1, translation(0.5, 0, 0));
  drawChosen({{0, 0.5}, {1, 0.5}}, kFull);
  expectRect(0, -1, 0.75, 1, "half a quad");
  drawChosen({{0, 0.125}, {1, 0.125}}, kFull);  // w is 1/4
  expectRect(0, -1, 0.75, 1, "weights of a quarter");
}

TEST_F(Skinning, Fog) {
  const GLfloat red[] = {1, 0, 0, 1};
  glEnable(GL_FOG);
  glFogfv(GL_FOG_COLOR, red);
  glFogf(GL_FOG_MODE, GL_LINEAR);
  glFogf(GL_FOG_START, 0);
  glFogf(GL_FOG_END, 1);
  setMatrix(0, translation(0, 0, -0.25));
  setMatrix(1, translation(0, 0, -0.75));
  glTranslatef(0, 0, -1);
  for (double share : {0.0, 0.25, 1.0}) {
    for (double sum : {1.0, 0.5}) {  // eye coordinates are divided by w
      drawChosen({{0, share * sum}, {1, (1 - share) * sum}});
      const double distance = 0.25 * share + 0.75 * (1 - share);
      EXPECT_PIXEL(32, 32, {distance, 1 - distance, 0, 1}) << share << " of " << sum;
    }
  }
}

TEST_F(Skinning, TextureGeneration) {
  NEEDS_EXTENSION("GL_OES_texture_cube_map");
  COMMAND(PFNGLTEXGENIOESPROC, TexGeniOES);
  const GLubyte texels[6][4] = {{255, 0, 0, 255},   {0, 255, 0, 255},   {0, 0, 255, 255},
                                {255, 255, 0, 255}, {0, 255, 255, 255}, {255, 0, 255, 255}};
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_CUBE_MAP_OES, name);
  useNearest(GL_TEXTURE_CUBE_MAP_OES);
  for (GLenum face = 0; face < 6; ++face)
    glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X_OES + face, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 texels[face]);
  glEnable(GL_TEXTURE_CUBE_MAP_OES);
  glEnable(GL_TEXTURE_GEN_STR_OES);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  TexGeniOES(GL_TEXTURE_GEN_STR_OES, GL_TEXTURE_GEN_MODE_OES, GL_NORMAL_MAP_OES);
  glNormal3f(0, 0, 1);
  setMatrix(1, rotation(90, 0, 1, 0) * scaling(1, 1, 0.001));  // +z to +x; flat, for the picture
  setMatrix(2, rotation(90, 1, 0, 0));                         // +z to -y
  glMatrixMode(GL_PROJECTION);
  const Mat4 show = rotation(40, 1, 1, 0) * scaling(0.3, 0.3, 0.3);
  glLoadMatrixf(floats(show).data());
  drawChosen({{1, 1}});
  EXPECT_PIXEL(32, 32, {1, 0, 0, 1}) << "normals along +x";
  drawChosen({{1, 0.0001}, {2, 0.9999}});  // 1000 times longer, and still the shorter
  EXPECT_PIXEL(32, 32, {1, 1, 0, 1}) << "normals along -y";

  TexGeniOES(GL_TEXTURE_GEN_STR_OES, GL_TEXTURE_GEN_MODE_OES, GL_REFLECTION_MAP_OES);
  glLoadIdentity();
  setMatrix(3, translation(0, 0, -4));
  setMatrix(4, translation(8, 0, 0));
  glOrthof(3, 5, -1, 1, 0, 10);
  drawChosen({{3, 0.5}, {4, 0.5}});  // at (4, 0, -2), facing the eye plane: reflected towards +x
  EXPECT_PIXEL(32, 32, {1, 0, 0, 1}) << "reflection";
}

TEST_F(Skinning, PointAttenuation) {
  const GLfloat attenuation[] = {0, 0, 1};
  glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, attenuation);
  glPointSize(40);
  setMatrix(0, translation(0, 0, -2));
  setMatrix(1, translation(0, 0, -8));
  glMatrixMode(GL_PROJECTION);
  glOrthof(-1, 1, -1, 1, 0, 10);
  const GLfloat centre[] = {0, 0};
  const GLubyte indices[] = {0, 1};
  const GLfloat weights[] = {0.5f, 0.5f};
  glEnable(GL_MATRIX_PALETTE_OES);
  for (GLenum array : kArrays) glEnableClientState(array);
  glVertexPointer(2, GL_FLOAT, 0, centre);
  matrixIndexPointer(2, GL_UNSIGNED_BYTE, 0, indices);
  weightPointer(2, GL_FLOAT, 0, weights);
  GLfloat range[2] = {};
  glGetFloatv(GL_ALIASED_POINT_SIZE_RANGE, range);
  glDrawArrays(GL_POINTS, 0, 1);
  if (range[1] < 8) {
    EXPECT_PIXEL(32, 32, kGreen);
    return;
  }
  expectRect(-0.125, -0.125, 0.125, 0.125, "40 / 5 pixels");
}

// The palette's constants follow each change between draws.
TEST_F(Skinning, ChangesBetweenDraws) {
  const GLfloat small[] = {-0.125f, -0.125f, 0.125f, -0.125f, -0.125f, 0.125f, 0.125f, 0.125f};
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 8; ++j) {
      if ((i + j) % 2) continue;
      setMatrix(20, translation(-0.875 + 0.25 * i, -0.875 + 0.25 * j, 0));
      drawChosen({{20, 1}}, small);
    }
  }
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j) EXPECT_PIXEL(8 * i + 4, 8 * j + 4, (i + j) % 2 ? kBlack : kGreen);
}

// OES_draw_texture's rectangles know no matrices.
TEST_F(Skinning, DrawTexture) {
  NEEDS_EXTENSION("GL_OES_draw_texture");
  COMMAND(PFNGLDRAWTEXIOESPROC, DrawTexiOES);
  solidTexture(GL_RGBA, {0, 255, 0, 255});
  const GLint crop[] = {0, 0, 1, 1};
  glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_CROP_RECT_OES, crop);
  glEnable(GL_TEXTURE_2D);
  setMatrix(0, translation(0.5, 0, 0));
  glEnable(GL_MATRIX_PALETTE_OES);
  DrawTexiOES(0, 0, 0, 32, 64);
  expectRect(-1, -1, 0, 1, "a rectangle");
  glDisable(GL_TEXTURE_2D);
  drawChosen({{0, 1}}, kHalf);
  expectRect(0, -0.5, 1, 0.5, "the palette afterwards");
}

}  // namespace
}  // namespace conformance
