// OES_matrix_palette: ordinary skins, and stiff ones.
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

#include "canvas.h"
#include "scene.h"

namespace comparison {

namespace {

const Surface kMedium{96, 96};
constexpr int kBones = 4;

// A ball whose vertices choose from four bones along y, each weighted by a smooth hat around it.
struct Skin {
  std::vector<GLubyte> indices;
  std::vector<GLfloat> weights;
};

Skin skinOf(const Mesh& mesh, float weightSum) {
  Skin skin;
  for (std::size_t i = 1; i < mesh.positions.size(); i += 3) {
    float weights[kBones], sum = 0;
    for (int bone = 0; bone < kBones; ++bone) {
      const float distance = mesh.positions[i] * 1.5f + 1.5f - static_cast<float>(bone);
      sum += weights[bone] = std::exp(-2 * distance * distance);
    }
    for (int bone = 0; bone < kBones; ++bone) {
      skin.indices.push_back(static_cast<GLubyte>(10 * bone + 3));
      skin.weights.push_back(weights[bone] / sum * weightSum);
    }
  }
  return skin;
}

// Palette matrices are set between these, by the commands of the current matrix.
void bone(int index) {
  static const auto select = command<PFNGLCURRENTPALETTEMATRIXOESPROC>("glCurrentPaletteMatrixOES");
  glMatrixMode(GL_MATRIX_PALETTE_OES);
  select(static_cast<GLuint>(10 * index + 3));
  glLoadIdentity();
  glTranslatef(0, 0, -3);
  glRotatef(20, 1, 0, 0);
}

void bendBones(float degrees) {
  for (int i = 0; i < kBones; ++i) {
    bone(i);
    glRotatef(degrees * (static_cast<float>(i) - 1.5f), 0, 0.4f, 1);
  }
}

void requirePalette() {
  const auto* extensions = reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS));
  if (!extensions || !std::strstr(extensions, "GL_OES_matrix_palette"))
    throw std::runtime_error("no GL_OES_matrix_palette");
}

// `extra`: one triangle more, ahead of all, with this for a weight.
void drawSkinned(float weightSum = 1, std::optional<float> extra = {}) {
  const auto matrixIndexPointer = command<PFNGLMATRIXINDEXPOINTEROESPROC>("glMatrixIndexPointerOES");
  const auto weightPointer = command<PFNGLWEIGHTPOINTEROESPROC>("glWeightPointerOES");
  glMatrixMode(GL_MODELVIEW);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_MATRIX_PALETTE_OES);
  glEnableClientState(GL_MATRIX_INDEX_ARRAY_OES);
  glEnableClientState(GL_WEIGHT_ARRAY_OES);
  Mesh mesh = sphere(24, 16);
  Skin skin = skinOf(mesh, weightSum);
  if (extra) {
    const auto first = static_cast<GLushort>(mesh.positions.size() / 3);
    for (int i = 0; i < 9; ++i) {
      mesh.positions.push_back(0.3f * static_cast<float>(i % 4));
      mesh.normals.push_back(0.5f);
      if (i < 6) mesh.texCoords.push_back(0);
    }
    for (int i = 0; i < 3 * kBones; ++i) {
      skin.indices.push_back(static_cast<GLubyte>(10 * (i % kBones) + 3));
      skin.weights.push_back(i % kBones == 1 ? *extra : 0.25f);
    }
    mesh.indices.insert(mesh.indices.begin(),
                        {first, static_cast<GLushort>(first + 1), static_cast<GLushort>(first + 2)});
  }
  matrixIndexPointer(kBones, GL_UNSIGNED_BYTE, 0, skin.indices.data());
  weightPointer(kBones, GL_FLOAT, 0, skin.weights.data());
  mesh.draw();
}

void start() {
  requirePalette();
  perspective();
  light({1, 2, 3, 0}, 0.9f, 0.5f);
  material({0.9f, 0.6f, 0.3f, 1}, 0.5f, 16);
}

void bent() {
  start();
  bendBones(15);
  drawSkinned();
}

void stretched(GLenum how) {
  start();
  bendBones(10);
  for (int i = 0; i < kBones; ++i) {
    bone(i);
    const float s = 0.8f + 0.15f * static_cast<float>(i);
    if (how == GL_RESCALE_NORMAL)
      glScalef(s, s, s);
    else
      glScalef(s, 1, 1.2f - 0.1f * static_cast<float>(i));
  }
  if (how) glEnable(how);
  drawSkinned();
}

void weightsThatSumTo(float sum) {
  start();
  bendBones(15);
  drawSkinned(sum);
}

// What eye coordinates lead to: a near light, fog, a plane, a texture by the normal.
void everything() {
  start();
  const GLfloat plane[] = {0.5f, 1, 0, 0.3f}, fog[] = {0.2f, 0.3f, 0.5f, 1};
  light({1, 1, -1, 1}, 0.7f, 0, GL_LIGHT1);
  glLightf(GL_LIGHT1, GL_LINEAR_ATTENUATION, 0.3f);
  glEnable(GL_FOG);
  glFogf(GL_FOG_DENSITY, 0.2f);
  glFogfv(GL_FOG_COLOR, fog);
  bendBones(15);
  glMatrixMode(GL_MODELVIEW);
  glClipPlanef(GL_CLIP_PLANE0, plane);
  glEnable(GL_CLIP_PLANE0);
  glLightModelf(GL_LIGHT_MODEL_TWO_SIDE, 1);
  drawSkinned();
}

// Bones that have no inverse: one flat, one a line, one a point.
void collapsed(GLenum how) {
  start();
  bendBones(10);
  glScalef(1, 1, 0);  // the last one
  bone(1);
  glScalef(0, 1, 0);
  bone(2);
  glScalef(0, 0, 0);
  if (how) glEnable(how);
  glEnable(GL_CULL_FACE);  // both sides lie in the same place
  drawSkinned();
}

void nearlyCollapsed() {
  start();
  bendBones(10);
  glScalef(1, 1, 1e-4f);
  bone(1);
  glScalef(1e-4f, 1, 1);
  glEnable(GL_NORMALIZE);
  drawSkinned();
}

// Undefined (2.1.1), but for the one triangle alone.
void badWeight(float value) {
  start();
  bendBones(15);
  drawSkinned(1, value);
}

// Camera and bones far from the origin, near each other.
void farBones(float distance) {
  start();
  for (int i = 0; i < kBones; ++i) {
    bone(i);
    glTranslatef(-distance, distance, -distance);
    glTranslatef(distance, -distance, distance);
    glRotatef(15 * (static_cast<float>(i) - 1.5f), 0, 0.4f, 1);
  }
  drawSkinned();
}

void hugeBones(float scale) {
  start();
  bendBones(15);
  for (int i = 0; i < kBones; ++i) {
    bone(i);
    glScalef(scale, scale, scale);
    glScalef(1 / scale, 1 / scale, 1 / scale);
    glRotatef(15 * (static_cast<float>(i) - 1.5f), 0, 0.4f, 1);
  }
  drawSkinned();
}

}  // namespace

void addPaletteScenes(Scenes& scenes) {
  const auto add = [&scenes](const char* name, void (*draw)()) {
    scenes.push_back({name, "OES_matrix_palette", draw, kMedium});
  };
  add("palette/bent", bent);
  add("palette/stretched", [] { stretched(0); });
  add("palette/stretched, NORMALIZE", [] { stretched(GL_NORMALIZE); });
  add("palette/scaled, RESCALE_NORMAL", [] { stretched(GL_RESCALE_NORMAL); });
  add("palette/lights, fog and a clip plane", everything);
}

void addPaletteExtremes(Scenes& scenes) {
  const auto add = [&scenes](const char* name, void (*draw)()) {
    scenes.push_back({name, "OES_matrix_palette", draw, kMedium});
  };
  add("palette/weights sum to 0.7", [] { weightsThatSumTo(0.7f); });
  add("palette/weights sum to 3", [] { weightsThatSumTo(3); });
  add("palette/weights sum to 1e-6", [] { weightsThatSumTo(1e-6f); });
  add("palette/collapsed", [] { collapsed(0); });
  add("palette/collapsed, NORMALIZE", [] { collapsed(GL_NORMALIZE); });
  add("palette/nearly collapsed", nearlyCollapsed);
  add("palette/weight that is no number", [] { badWeight(std::numeric_limits<float>::quiet_NaN()); });
  add("palette/infinite weight", [] { badWeight(std::numeric_limits<float>::infinity()); });
  add("palette/bones at 1e6", [] { farBones(1e6f); });
  add("palette/bones at 1e7", [] { farBones(1e7f); });
  add("palette/bones of 1e15", [] { hugeBones(1e15f); });
}

}  // namespace comparison
