// A skinned mesh: what the matrix palette costs.

#include <EGL/egl.h>
#include <GLES/gl.h>
#include <GLES/glext.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>

#include "scene.h"
#include "session.h"

namespace bench {

namespace {

constexpr unsigned kRings = 62, kAround = 93, kVertices = kRings * kAround;
static_assert(kVertices == 5766);
constexpr unsigned kBones = 20, kWeights = 4, kPoses = 2;
constexpr double kLength = 800, kRadius = 90;

using Vec3 = std::array<double, 3>;
// Three rows: turned, then moved.
using Matrix = std::array<std::array<double, 4>, 3>;

struct Vertex {
  std::array<float, 3> position, normal;
  std::array<float, kWeights> weights;
  std::array<std::uint8_t, kWeights> bones;
};

struct Transformed {
  std::array<float, 3> position, normal;
};

Vec3 apply(const Matrix& m, const std::array<float, 3>& v, double w) {
  Vec3 result;
  for (std::size_t row = 0; row < 3; ++row)
    result[row] = m[row][0] * v[0] + m[row][1] * v[1] + m[row][2] * v[2] + m[row][3] * w;
  return result;
}

// A tube along x with bones at equal distances, each vertex between four of them.
std::vector<Vertex> makeTube() {
  std::vector<Vertex> tube(kVertices);
  for (unsigned i = 0; i < kVertices; ++i) {
    const double along = double(i / kAround) / (kRings - 1);
    const double angle = 2 * std::numbers::pi * double(i % kAround) / kAround;
    const double radius = kRadius * (1 + 0.2 * std::sin(6 * along));
    Vertex& v = tube[i];
    v.normal = {0, float(std::sin(angle)), float(std::cos(angle))};
    v.position = {float(along * kLength), float(radius * v.normal[1]), float(radius * v.normal[2])};
    const double place = along * (kBones - 1);
    const unsigned first = unsigned(std::clamp(std::floor(place) - 1, 0.0, double(kBones - kWeights)));
    double sum = 0;
    std::array<double, kWeights> weights{};
    for (unsigned k = 0; k < kWeights; ++k) {
      const double distance = place - double(first + k);
      sum += weights[k] = std::exp(-distance * distance);
      v.bones[k] = std::uint8_t(first + k);
    }
    for (unsigned k = 0; k < kWeights; ++k) v.weights[k] = float(weights[k] / sum);
  }
  return tube;
}

std::vector<std::uint16_t> makeIndices() {
  std::vector<std::uint16_t> indices;
  for (unsigned ring = 0; ring + 1 < kRings; ++ring)
    for (unsigned i = 0; i < kAround; ++i) {
      const unsigned a = ring * kAround + i, b = ring * kAround + (i + 1) % kAround;
      for (const unsigned index : {a, a + kAround, b, b, a + kAround, b + kAround})
        indices.push_back(std::uint16_t(index));
    }
  return indices;
}

// A bone's turn about z and x, at its place on the tube, and the whole in the middle of the window.
Matrix boneMatrix(unsigned bone, unsigned pose) {
  const double at = kLength * bone / (kBones - 1);
  const double turn = 0.25 * std::sin(0.5 * bone + pose), roll = 0.1 * std::cos(0.7 * bone + 2.0 * pose);
  const double c = std::cos(turn), s = std::sin(turn), cr = std::cos(roll), sr = std::sin(roll);
  Matrix m = {{{c, -s * cr, s * sr, 0}, {s, c * cr, -c * sr, 0}, {0, sr, cr, 0}}};
  const double wave = 40 * std::sin(0.4 * bone + 0.5 * pose);
  m[0][3] = at + (kWidth - kLength) / 2 - m[0][0] * at;
  m[1][3] = kHeight / 2.0 + wave - m[1][0] * at;
  m[2][3] = -m[2][0] * at;
  return m;
}

class Skinned : public Scene {
 public:
  explicit Skinned(bool palette)
      : Scene(palette ? "skinning.palette" : "skinning.applied",
              palette ? "5,766 lit vertices, 20 matrices, 4 weights, palette loaded each frame; without the "
                        "extension skinned by the program"
                      : "the same vertices, matrices already applied"),
        palette_(palette) {}

  void begin() override {
    const auto* extensions = reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS));
    const bool has = extensions && std::strstr(extensions, "GL_OES_matrix_palette");
    way_ = !palette_ ? Way::Applied : has ? Way::Palette : Way::Program;
    tube_ = makeTube();
    indices_ = makeIndices();
    for (unsigned pose = 0; pose < kPoses; ++pose) {
      for (unsigned bone = 0; bone < kBones; ++bone) poses_[pose][bone] = boneMatrix(bone, pose);
      transformed_[pose] = transform(pose);
    }
    setView();
    glGenBuffers(GLsizei(buffers_.size()), buffers_.data());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[0]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(indices_.size() * 2), indices_.data(), GL_STATIC_DRAW);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);
    if (way_ == Way::Palette) setPaletteArrays();
    for (unsigned pose = 0; way_ == Way::Applied && pose < kPoses; ++pose) {
      glBindBuffer(GL_ARRAY_BUFFER, buffers_[1 + pose]);
      glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(kVertices * sizeof(Transformed)), transformed_[pose].data(),
                   GL_STATIC_DRAW);
    }
  }

  void frame(unsigned number) override {
    const unsigned pose = number % kPoses;
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    if (way_ == Way::Palette) loadPalette(pose);
    if (way_ == Way::Applied) {
      glBindBuffer(GL_ARRAY_BUFFER, buffers_[1 + pose]);
      setArrays(nullptr);
    }
    if (way_ == Way::Program) {
      moving_ = transform(pose);
      setArrays(moving_.data());
    }
    glDrawElements(GL_TRIANGLES, GLsizei(indices_.size()), GL_UNSIGNED_SHORT, nullptr);
  }

  // Where vertices that face the viewer came to lie, and how the light falls there.
  Verdict check(unsigned number) const override {
    Picture picture;
    const std::vector<Transformed>& vertices = transformed_[number % kPoses];
    for (unsigned i = kAround; i < kVertices - kAround; i += 7) {  // not the open ends
      const Transformed& v = vertices[i];
      if (v.normal[2] < 0.9f) continue;
      const int grey = int(std::lround(255 * 0.8 * std::fmin(v.normal[2], 1.0f)));
      picture.expect(int(v.position[0]), int(v.position[1]), {grey, grey, grey}, 4);
    }
    picture.expect(5, 5, {0, 0, 51});
    picture.expect(kWidth - 5, kHeight - 5, {0, 0, 51});
    return picture.verdict();
  }

 private:
  enum class Way { Palette, Applied, Program };

  static void setView() {
    setPixelProjection();
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrthof(0, kWidth, 0, kHeight, -200, 200);
    glMatrixMode(GL_MODELVIEW);
    glClearColor(0, 0, 0.2f, 1);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    const std::array<float, 4> black = {0, 0, 0, 1};
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, black.data());
  }

  static void setArrays(const Transformed* from) {
    const auto* bytes = reinterpret_cast<const std::byte*>(from);
    glVertexPointer(3, GL_FLOAT, sizeof(Transformed), bytes + offsetof(Transformed, position));
    glNormalPointer(GL_FLOAT, sizeof(Transformed), bytes + offsetof(Transformed, normal));
  }

  void setPaletteArrays() {
    const auto matrixIndexPointer =
        reinterpret_cast<PFNGLMATRIXINDEXPOINTEROESPROC>(eglGetProcAddress("glMatrixIndexPointerOES"));
    const auto weightPointer =
        reinterpret_cast<PFNGLWEIGHTPOINTEROESPROC>(eglGetProcAddress("glWeightPointerOES"));
    currentMatrix_ =
        reinterpret_cast<PFNGLCURRENTPALETTEMATRIXOESPROC>(eglGetProcAddress("glCurrentPaletteMatrixOES"));
    glBindBuffer(GL_ARRAY_BUFFER, buffers_[1]);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(kVertices * sizeof(Vertex)), tube_.data(), GL_STATIC_DRAW);
    const auto at = [](std::size_t offset) { return reinterpret_cast<const void*>(offset); };
    glVertexPointer(3, GL_FLOAT, sizeof(Vertex), at(offsetof(Vertex, position)));
    glNormalPointer(GL_FLOAT, sizeof(Vertex), at(offsetof(Vertex, normal)));
    weightPointer(kWeights, GL_FLOAT, sizeof(Vertex), at(offsetof(Vertex, weights)));
    matrixIndexPointer(kWeights, GL_UNSIGNED_BYTE, sizeof(Vertex), at(offsetof(Vertex, bones)));
    glEnable(GL_MATRIX_PALETTE_OES);
    glEnableClientState(GL_MATRIX_INDEX_ARRAY_OES);
    glEnableClientState(GL_WEIGHT_ARRAY_OES);
    glMatrixMode(GL_MATRIX_PALETTE_OES);
  }

  void loadPalette(unsigned pose) const {
    for (unsigned bone = 0; bone < kBones; ++bone) {
      const Matrix& m = poses_[pose][bone];
      std::array<float, 16> columns{};
      for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 4; ++column) columns[4 * column + row] = float(m[row][column]);
      columns[15] = 1;
      currentMatrix_(bone);
      glLoadMatrixf(columns.data());
    }
  }

  std::vector<Transformed> transform(unsigned pose) const {
    std::vector<Transformed> result(kVertices);
    for (unsigned i = 0; i < kVertices; ++i) {
      const Vertex& v = tube_[i];
      for (unsigned k = 0; k < kWeights; ++k) {
        const Matrix& m = poses_[pose][v.bones[k]];
        const Vec3 position = apply(m, v.position, 1), normal = apply(m, v.normal, 0);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          result[i].position[axis] += float(v.weights[k] * position[axis]);
          result[i].normal[axis] += float(v.weights[k] * normal[axis]);
        }
      }
    }
    return result;
  }

  bool palette_;
  Way way_ = Way::Applied;
  std::vector<Vertex> tube_;
  std::vector<std::uint16_t> indices_;
  std::array<std::array<Matrix, kBones>, kPoses> poses_{};
  std::array<std::vector<Transformed>, kPoses> transformed_;
  std::vector<Transformed> moving_;
  std::array<GLuint, 1 + kPoses> buffers_{};
  PFNGLCURRENTPALETTEMATRIXOESPROC currentMatrix_ = nullptr;
};

}  // namespace

void addSkinningScenes(Scenes& scenes) {
  scenes.push_back(std::make_unique<Skinned>(true));
  scenes.push_back(std::make_unique<Skinned>(false));
}

}  // namespace bench
