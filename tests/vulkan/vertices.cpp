// Vertices and indices: every type and place, and what lies outside of buffers.
#include <cmath>
#include <cstring>

#include "layer/vulkan/vulkan_device.h"
#include "tests/vulkan/scene.h"

namespace anteroom::test {
namespace {

constexpr Pixel kBlack{0, 0, 0, 255}, kWhite{255, 255, 255, 255};

class Vertices : public testing::TestWithParam<bool> {
 protected:
  void TearDown() override { EXPECT_EQ(vulkan::validationMessages(), 0u); }
};

// The lower left half of the target, as a type's values.
template <class T>
std::vector<std::byte> triangle(T one, int size, size_t lead, size_t stride) {
  const T minus = static_cast<T>(-one);
  const T corners[3][4] = {{minus, minus, 0, one}, {one, minus, 0, one}, {minus, one, 0, one}};
  std::vector<std::byte> bytes(lead + 3 * stride);
  for (size_t i = 0; i < 3; ++i) std::memcpy(&bytes[lead + i * stride], corners[i], size * sizeof(T));
  return bytes;
}

template <class T>
void drawType(Scene& scene, GLenum type, T one) {
  for (const bool inBuffer : {false, true})
    for (int size = 2; size <= 4; ++size)
      for (const size_t lead : {size_t{0}, size_t{4}, size_t{1}})
        for (const size_t stride : {size * sizeof(T), size * sizeof(T) + 5, size_t{32}}) {
          const auto bytes = triangle(one, size, lead, stride);
          const auto buffer = scene.device.createBuffer(bytes.size(), bytes.data());
          scene.clear(GL_COLOR_BUFFER_BIT);
          scene.state.fixed.attributes[gen::kPosition] = {true, static_cast<uint8_t>(size), type, {}};
          scene.state.arrays[gen::kPosition] = {
              inBuffer ? buffer.get() : nullptr,
              inBuffer ? reinterpret_cast<const void*>(lead) : bytes.data() + lead,
              static_cast<uint32_t>(stride)};
          scene.changed |= gen::kGroupArrays;
          scene.draw(GL_TRIANGLES, 3);
          ASSERT_EQ(scene.at(2, 2), kWhite) << type << ' ' << size << ' ' << lead << ' ' << stride;
          ASSERT_EQ(scene.at(13, 13), kBlack) << type << ' ' << size << ' ' << lead << ' ' << stride;
        }
}

TEST_P(Vertices, EveryTypeSizeAndPlace) {
  Scene scene(GetParam());
  drawType<float>(scene, GL_FLOAT, 1);
  drawType<int32_t>(scene, GL_FIXED, 65536);
  drawType<int16_t>(scene, GL_SHORT, 1);
  drawType<int8_t>(scene, GL_BYTE, 1);
}

TEST_P(Vertices, IndicesOfEveryType) {
  Scene scene(GetParam());
  const float points[] = {9, 9, -1, -1, 1, -1, -1, 1, 9, 9};
  const uint8_t bytes[] = {0, 1, 2, 3};
  const uint16_t shorts[] = {0, 1, 2, 3};
  const uint32_t ints[] = {0, 1, 2, 3};
  const auto vertices = scene.device.createBuffer(sizeof points, points);
  for (const bool inBuffer : {false, true})
    for (const bool vertexBuffer : {false, true})
      for (const auto& [type, data, size] :
           {std::tuple<GLenum, const void*, size_t>{GL_UNSIGNED_BYTE, bytes, 1},
            std::tuple<GLenum, const void*, size_t>{GL_UNSIGNED_SHORT, shorts, 2},
            std::tuple<GLenum, const void*, size_t>{GL_UNSIGNED_INT, ints, 4}}) {
        const auto buffer = scene.device.createBuffer(4 * size, data);
        scene.clear(GL_COLOR_BUFFER_BIT);
        scene.array(gen::kPosition, points, 2);
        if (vertexBuffer) scene.state.arrays[gen::kPosition] = {vertices.get(), nullptr, 8};
        render::DrawCall call;
        call.count = 3;
        call.indexType = type;
        call.indexBuffer = inBuffer ? buffer.get() : nullptr;
        call.indices =
            inBuffer ? reinterpret_cast<const void*>(size) : static_cast<const std::byte*>(data) + size;
        scene.draw(call);
        EXPECT_EQ(scene.at(2, 2), kWhite);
        EXPECT_EQ(scene.at(13, 13), kBlack);
      }
}

TEST_P(Vertices, MixedSourcesAgreeOnTheVertex) {
  Scene scene(GetParam());
  const float points[] = {9, 9, 9, 9, -1, -1, 3, -1, -1, 3};
  const float colors[] = {1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1};
  const auto vertices = scene.device.createBuffer(sizeof points, points);
  scene.array(gen::kPosition, points, 2);
  scene.array(gen::kColor, colors, 4);
  scene.state.arrays[gen::kPosition] = {vertices.get(), nullptr, 8};
  scene.clear(GL_COLOR_BUFFER_BIT);
  scene.draw(GL_TRIANGLES, 3, 2);
  EXPECT_EQ(scene.at(8, 8), (Pixel{0, 255, 0, 255}));
  const uint16_t indices[] = {2, 3, 4};
  render::DrawCall call;
  call.count = 3;
  call.indexType = GL_UNSIGNED_SHORT;
  call.indices = indices;
  scene.clear(GL_COLOR_BUFFER_BIT);
  scene.draw(call);
  EXPECT_EQ(scene.at(8, 8), (Pixel{0, 255, 0, 255}));
}

TEST_P(Vertices, BeyondTheEndNothingStrangeIsRead) {
  Scene scene(GetParam());
  const float points[] = {-1, -1, 1, -1, -1, 1};
  const auto vertices = scene.device.createBuffer(sizeof points, points);
  const uint32_t indices[] = {5, 6, 7, 0, 1, 0xffffffff, 0, 1, 2};
  const auto indexBuffer = scene.device.createBuffer(sizeof indices, indices);
  scene.array(gen::kPosition, points, 2);
  scene.state.arrays[gen::kPosition] = {vertices.get(), nullptr, 8};
  scene.clear(GL_COLOR_BUFFER_BIT);
  scene.draw(GL_TRIANGLES, 3000);
  EXPECT_EQ(scene.at(2, 2), kWhite);
  scene.clear(GL_COLOR_BUFFER_BIT);
  scene.draw(GL_TRIANGLES, 3, 2147483000);
  render::DrawCall call;
  call.indexType = GL_UNSIGNED_INT;
  call.indexBuffer = indexBuffer.get();
  for (const auto& [offset, count] : {std::pair{0, 9}, std::pair{0, 100000}, std::pair{36, 3},
                                      std::pair{4000, 3}, std::pair{35, 3}, std::pair{2, 3}}) {
    call.indices = reinterpret_cast<const void*>(static_cast<uintptr_t>(offset));
    call.count = count;
    scene.draw(call);
  }
  EXPECT_EQ(scene.at(2, 2), kWhite);
  // An array that begins beyond its buffer.
  scene.state.arrays[gen::kPosition].pointer = reinterpret_cast<const void*>(uintptr_t{1} << 40);
  scene.changed |= gen::kGroupArrays;
  scene.draw(GL_TRIANGLES, 3);
  scene.read();
}

TEST_P(Vertices, DrawsSeeTheBufferOfTheirTime) {
  Scene scene(GetParam());
  const float left[] = {-1, -1, 0, -1, 0, 1, -1, -1, 0, 1, -1, 1},
              right[] = {0, -1, 1, -1, 1, 1, 0, -1, 1, 1, 0, 1};
  const auto buffer = scene.device.createBuffer(sizeof left, left);
  scene.array(gen::kPosition, left, 2);
  scene.state.arrays[gen::kPosition] = {buffer.get(), nullptr, 8};
  scene.clear(GL_COLOR_BUFFER_BIT);
  scene.draw(GL_TRIANGLES, 6);
  ASSERT_TRUE(buffer->write(0, right, sizeof right));
  scene.color(1, 0, 0);
  scene.draw(GL_TRIANGLES, 6);
  EXPECT_EQ(scene.at(4, 8), kWhite);
  EXPECT_EQ(scene.at(12, 8), (Pixel{255, 0, 0, 255}));
}

TEST_P(Vertices, SparseIndicesIntoClientMemory) {
  Scene scene(GetParam());
  std::vector<float> points(2 * 60000, 9.0f);
  const float corners[] = {-1, -1, 1, -1, -1, 1};
  const uint16_t indices[] = {3, 30000, 59999};
  for (int i = 0; i < 3; ++i) std::memcpy(&points[2 * indices[i]], corners + 2 * i, 8);
  scene.array(gen::kPosition, points.data(), 2);
  scene.clear(GL_COLOR_BUFFER_BIT);
  render::DrawCall call;
  call.count = 3;
  call.indexType = GL_UNSIGNED_SHORT;
  call.indices = indices;
  scene.draw(call);
  EXPECT_EQ(scene.at(2, 2), kWhite);
  EXPECT_EQ(scene.at(13, 13), kBlack);
}

// Small draws are joined behind the seam: what each of them looked like must stay.
TEST_P(Vertices, JoinedDrawsKeepTheirColorsAndOrder) {
  Scene scene(GetParam(), 64, 64);
  scene.clear(GL_COLOR_BUFFER_BIT);
  const auto shade = [](int i) { return static_cast<float>(i % 256) / 255; };
  const auto cell = [&](int i, float size) {
    const float x = static_cast<float>(i % 16) / 8 - 1, y = static_cast<float>(i / 16) / 8 - 1;
    const float corners[] = {x, y, x + size, y, x, y + size, x + size, y, x + size, y + size, x, y + size};
    scene.array(gen::kPosition, corners, 2);
    scene.draw(GL_TRIANGLES, 6);
  };
  for (int i = 0; i < 256; ++i) {
    scene.color(1, 1, 1);
    cell(i, 0.125f);
    scene.color(shade(i), shade(255 - i), 0);
    cell(i, 0.125f);
    if (i == 100) scene.clear(GL_DEPTH_BUFFER_BIT);
  }
  const auto pixels = scene.read();
  for (int i = 0; i < 256; ++i) {
    const Pixel expected{static_cast<uint8_t>(i), static_cast<uint8_t>(255 - i), 0, 255};
    EXPECT_EQ(pixels[static_cast<size_t>(i / 16 * 4 + 1) * 64 + i % 16 * 4 + 1], expected) << i;
  }
  // Incomplete primitives are dropped from each draw alone.
  scene.clear(GL_COLOR_BUFFER_BIT);
  const float corners[] = {-1, -1, 1, -1, -1, 1, 1, 1, 1, 1};
  scene.color(1, 1, 1);
  for (int i = 0; i < 3; ++i) {
    scene.array(gen::kPosition, corners, 2);
    scene.draw(GL_TRIANGLES, 5);
  }
  EXPECT_EQ(scene.at(60, 60), kBlack);
  EXPECT_EQ(scene.at(5, 5), kWhite);
}

// The same with matrices, from a buffer that is written to in between.
TEST_P(Vertices, JoinedDrawsKeepTheirMatrices) {
  Scene scene(GetParam(), 64, 64);
  scene.clear(GL_COLOR_BUFFER_BIT);
  const auto shade = [](int i) { return static_cast<float>(i % 256) / 255; };
  const float whole[] = {9, 9, 0, 0, 1, 0, 0, 1, 1, 0, 1, 1, 0, 1};
  const float half[] = {9, 9, 0, 0, 1, 0, 0, .5f, 1, 0, 1, .5f, 0, .5f};
  const auto buffer = scene.device.createBuffer(sizeof whole, whole);
  scene.array(gen::kPosition, whole, 2);
  scene.state.arrays[gen::kPosition] = {buffer.get(), nullptr, 8};
  for (int i = 0; i < 256; ++i) {
    if (i == 128) {
      ASSERT_TRUE(buffer->write(0, half, sizeof half));
    }
    gen::State& fixed = scene.state.fixed;
    fixed.modelview = glm::dmat4(0.125);
    fixed.modelview[3] = {i % 16 / 8.0 - 1, i / 16 / 8.0 - 1, 0, 1};
    scene.changed |= gen::kGroupModelview;
    scene.color(shade(i), shade(255 - i), 0);
    scene.draw(GL_TRIANGLES, 6, 1);
  }
  const auto pixels = scene.read();
  for (int i = 0; i < 256; ++i) {
    const auto at = [&](int y) { return pixels[static_cast<size_t>(i / 16 * 4 + y) * 64 + i % 16 * 4 + 1]; };
    const Pixel color{static_cast<uint8_t>(i), static_cast<uint8_t>(255 - i), 0, 255};
    EXPECT_EQ(at(1), color) << i;
    EXPECT_EQ(at(3), i < 128 ? color : kBlack) << i;
  }
  // What lies behind the buffer is not read, whatever came before.
  scene.draw(GL_TRIANGLES, 6, 5);
  scene.draw(GL_TRIANGLES, 6, 1 << 30);
  scene.read();
}

// Lighting and fog see the matrices of each draw, too.
TEST_P(Vertices, JoinedDrawsLookLikeSingleOnes) {
  const float corners[] = {0, 0, 0, 1, 0, .5f, 0, 1, 1, 1, 1, 0};
  const float normals[] = {0, 0, 1, .6f, 0, .8f, 0, .8f, .6f, 0, -1, 0};
  const uint16_t indices[] = {2, 0, 1, 3, 2};
  const auto picture = [&](bool lit, GLenum mode, bool indexed, bool single) {
    Scene scene(GetParam(), 64, 64);
    gen::State& fixed = scene.state.fixed;
    fixed.lighting.enabled = fixed.lighting.normalize = fixed.lighting.colorMaterial = lit;
    fixed.lighting.lights[0].enabled = true;
    fixed.lighting.lights[0].diffuse = {1, 1, 1, 1};
    fixed.fog.enabled = !lit;
    scene.array(gen::kPosition, corners, 3);
    scene.array(gen::kNormal, normals, 3);
    scene.clear(GL_COLOR_BUFFER_BIT);
    for (int i = 0; i < 256; ++i) {
      const double angle = i * .1, c = std::cos(angle) / 10, s = std::sin(angle) / 10;
      fixed.modelview = {
          {c, 0, s, 0}, {0, .1, 0, 0}, {-s, 0, c, 0}, {i % 16 / 8.0 - 1, i / 16 / 8.0 - 1, i / 300.0, 1}};
      scene.changed |= gen::kGroupModelview;
      if (single) scene.changed |= gen::kGroupRaster;
      scene.color(1, static_cast<float>(i % 7) / 6, .5f);
      fixed.shadeModel = mode == GL_TRIANGLE_FAN ? GL_FLAT : GL_SMOOTH;
      fixed.primitive = mode == GL_LINE_LOOP ? gen::PrimitiveClass::Lines : gen::PrimitiveClass::Triangles;
      render::DrawCall call;
      call.mode = mode;
      call.count = indexed ? 5 - i % 2 : mode == GL_TRIANGLES ? 3 : 4;
      if (indexed) call.indexType = GL_UNSIGNED_SHORT, call.indices = indices;
      scene.draw(call);
    }
    return scene.read();
  };
  for (const bool lit : {true, false})
    for (const GLenum mode : {GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_LINE_LOOP})
      for (const bool indexed : {false, true})
        EXPECT_EQ(picture(lit, mode, indexed, false), picture(lit, mode, indexed, true))
            << lit << ' ' << mode << ' ' << indexed;
}

// Some drivers lose the whole list, when its number of vertices is a certain one.
TEST_P(Vertices, ADegenerateTriangleHidesNoOther) {
  Scene scene(GetParam());
  for (int count = 6; count <= 36; ++count) {
    std::vector<float> corners(static_cast<size_t>(count) * 2, 0.25f);
    const float half[] = {-1, -1, 1, -1, -1, 1};
    for (int i = 0; i < (count / 3 - 1) * 6; ++i) corners[static_cast<size_t>(i)] = half[i % 6];
    for (const int draws : {1, 2}) {
      scene.clear(GL_COLOR_BUFFER_BIT);
      scene.array(gen::kPosition, corners.data(), 2);
      for (int i = 0; i < draws; ++i) scene.draw(GL_TRIANGLES, count);
      ASSERT_EQ(scene.at(2, 2), kWhite) << count;
      ASSERT_EQ(scene.at(13, 13), kBlack) << count;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Profiles, Vertices, testing::Values(false, true), profileName);

}  // namespace
}  // namespace anteroom::test
