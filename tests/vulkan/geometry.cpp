// Geometry alone: from a call to vertices in place. Nothing is recorded.
#include "layer/vulkan/geometry/geometry_builder.h"

#include <cstring>

#include "tests/vulkan/parts.h"

namespace anteroom::test {
namespace {

constexpr uint64_t kRecording = 7;
constexpr float kCorners[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};  // of two components

class Geometry : public Part {
 protected:
  void SetUp() override {
    state_.fixed.attributes[gen::kPosition] = {true, 2, GL_FLOAT, {}};
    setArray({nullptr, kCorners, 8});
  }
  void setArray(const render::VertexArray& array) {
    state_.arrays[gen::kPosition] = array;
    const gen::FragmentKey fragment = gen::canonicaliseFragment(state_.fixed, device().caps().profile);
    const gen::VertexKey vertex = gen::canonicaliseVertex(state_.fixed, fragment, device().caps().profile);
    builder_.configure(state_, vertex, nullptr, 0);
  }
  vulkan::Geometry build(const render::DrawCall& call) {
    vulkan::Geometry geometry;
    EXPECT_TRUE(builder_.build(state_, call, kRecording, geometry));
    return geometry;
  }
  static render::DrawCall arrays(GLenum mode, int first, int count) {
    render::DrawCall call;
    call.mode = mode;
    call.first = first;
    call.count = count;
    return call;
  }

  render::State state_;
  vulkan::Stream vertices_{device(), vulkan::Stream::Purpose::Vertices, 1 << 16};
  vulkan::Stream indices_{device(), vulkan::Stream::Purpose::Vertices, 1 << 16};
  vulkan::GeometryBuilder builder_{device(), vertices_, indices_};
};

TEST_P(Geometry, ArraysOfBuffersStayInPlace) {
  const auto buffer = device().createBuffer(sizeof kCorners, kCorners);
  setArray({buffer.get(), nullptr, 8});
  const vulkan::Geometry geometry = build(arrays(GL_TRIANGLE_STRIP, 1, 4));
  EXPECT_EQ(geometry.topology, VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP);
  EXPECT_EQ(geometry.range.count, 4u);
  EXPECT_EQ(geometry.range.first, 1u);
  EXPECT_FALSE(geometry.range.indexBuffer);
  ASSERT_EQ(geometry.arrays->layout.count, 1u);
  const auto& store = vulkan::vulkan(*buffer).store();
  EXPECT_EQ(geometry.arrays->stores[0], &store) << "the recording must hold it";
  EXPECT_EQ(geometry.arrays->buffers[0], store->memory.buffer);
  EXPECT_EQ(geometry.arrays->offsets[0], store->memory.offset);
}

TEST_P(Geometry, ArraysOfClientMemoryAreGathered) {
  const vulkan::StreamPiece before = vertices_.allocate(16, 16);
  const vulkan::Geometry geometry = build(arrays(GL_TRIANGLES, 2, 3));
  EXPECT_EQ(geometry.arrays->stores[0], nullptr);
  EXPECT_EQ(geometry.arrays->buffers[0], before.buffer);
  ASSERT_EQ(geometry.arrays->offsets[0], before.offset + 16);
  const std::byte* const gathered = before.mapped + 16 + size_t{geometry.range.first} * 8;
  EXPECT_EQ(std::memcmp(gathered, kCorners + 4, 24), 0);
}

TEST_P(Geometry, TheTopologyIsAResult) {
  const bool pointsOut = device().features().provokingVertexLast;
  EXPECT_EQ(build(arrays(GL_POINTS, 0, 3)).topology, VK_PRIMITIVE_TOPOLOGY_POINT_LIST);
  EXPECT_EQ(build(arrays(GL_LINES, 0, 4)).topology, VK_PRIMITIVE_TOPOLOGY_LINE_LIST);
  const vulkan::Geometry loop = build(arrays(GL_LINE_LOOP, 0, 3));
  EXPECT_EQ(loop.topology, VK_PRIMITIVE_TOPOLOGY_LINE_STRIP);
  EXPECT_EQ(loop.range.count, 4u) << "the first vertex comes once more";
  EXPECT_TRUE(loop.range.indexBuffer);
  // Flat colors come from the last vertex: where the device takes the first, lists are made.
  state_.fixed.shadeModel = GL_FLAT;
  EXPECT_EQ(build(arrays(GL_TRIANGLE_STRIP, 0, 4)).topology,
            pointsOut ? VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP : VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST);
}

TEST_P(Geometry, IndicesBeyondTheirBufferAreNotDrawn) {
  const uint16_t four[] = {0, 1, 2, 3};
  const auto indices = device().createBuffer(sizeof four, four);
  const auto buffer = device().createBuffer(sizeof kCorners, kCorners);
  setArray({buffer.get(), nullptr, 8});
  render::DrawCall call = arrays(GL_TRIANGLE_FAN, 0, 9);
  call.indexType = GL_UNSIGNED_SHORT;
  call.indexBuffer = indices.get();
  call.indices = reinterpret_cast<const void*>(2);
  const vulkan::Geometry geometry = build(call);
  EXPECT_EQ(geometry.range.count, 3u);
  EXPECT_EQ(geometry.range.first, 1u);
  EXPECT_EQ(geometry.range.indexType, VK_INDEX_TYPE_UINT16);
  EXPECT_EQ(geometry.indexStore, &vulkan::vulkan(*indices).store());
  call.indices = reinterpret_cast<const void*>(99);
  EXPECT_EQ(build(call).range.count, 0u);
}

TEST_P(Geometry, AppendedVerticesLieBehindThoseOfTheBatch) {
  const vulkan::Geometry geometry = build(arrays(GL_TRIANGLES, 0, 3));
  vulkan::DrawRange batch;
  ASSERT_TRUE(builder_.opensBatch(arrays(GL_TRIANGLES, 0, 3), geometry, batch));
  EXPECT_EQ(batch.count, 3u);
  EXPECT_TRUE(builder_.batch().accepts(arrays(GL_TRIANGLES, 1, 4), 0, {}, batch.count));
  uint32_t count = 0;
  ASSERT_TRUE(builder_.append(state_, arrays(GL_TRIANGLES, 1, 4), false, kRecording, count));
  EXPECT_EQ(count, 3u) << "the fourth vertex is no triangle";
  EXPECT_FALSE(builder_.append(state_, arrays(GL_TRIANGLES, 0, 3), false, kRecording + 1, count))
      << "another recording has no such vertices";
}

INSTANTIATE_TEST_SUITE_P(Profiles, Geometry, testing::Values(false, true), profileName);

render::DrawCall call(GLenum mode, int count, GLenum indexType = 0) {
  render::DrawCall made;
  made.mode = mode;
  made.count = count;
  made.indexType = indexType;
  return made;
}

TEST(GeometryBatch, AcceptsWhatDiffersInItsVerticesOnly) {
  vulkan::Batch batch(true);
  gen::Blocks read;
  read.pushGroups = gen::kGroupModelview;
  batch.opened(GL_TRIANGLES);
  EXPECT_TRUE(batch.accepts(call(GL_TRIANGLES, 6), gen::kGroupArrays, read, 3));
  EXPECT_TRUE(batch.accepts(call(GL_TRIANGLES, 6), gen::kGroupCurrentColor, read, 3)) << "nothing reads it";
  EXPECT_FALSE(batch.accepts(call(GL_TRIANGLES, 6), gen::kGroupModelview, read, 3));
  EXPECT_FALSE(batch.accepts(call(GL_TRIANGLES, 6), gen::kGroupTextures, read, 3));
  EXPECT_FALSE(batch.accepts(call(GL_LINES, 6), 0, read, 3));
  EXPECT_FALSE(batch.accepts(call(GL_TRIANGLE_STRIP, 6), 0, read, 3));
  EXPECT_FALSE(batch.accepts(call(GL_TRIANGLES, 6, GL_UNSIGNED_BYTE), 0, read, 3));
  EXPECT_FALSE(batch.accepts(call(GL_TRIANGLES, 3000), 0, read, 3));
  EXPECT_FALSE(batch.accepts(call(GL_TRIANGLES, 6), 0, read, 1 << 16)) << "it is full";
}

TEST(GeometryBatch, CarriesValuesOnceTheyChangedOften) {
  vulkan::Batch batch(true);
  render::State state;
  gen::Blocks read;
  read.pushGroups = gen::kGroupModelview;
  int draws = 1;
  while (!batch.chooseCarried(state, call(GL_TRIANGLE_STRIP, 4), gen::kGroupModelview, read)) {
    EXPECT_EQ(batch.carried(), vulkan::Carried::Nothing);
    ASSERT_LT(++draws, 100);
  }
  EXPECT_EQ(draws, 32);
  EXPECT_EQ(batch.carried(), vulkan::Carried::Values);
  batch.opened(GL_TRIANGLE_STRIP);
  EXPECT_TRUE(batch.accepts(call(GL_TRIANGLE_STRIP, 4), gen::kGroupModelview, read, 6));
  // A large draw ends it, and it takes twice as long to come back.
  EXPECT_NE(batch.chooseCarried(state, call(GL_TRIANGLES, 3000), 0, read), 0u);
  EXPECT_EQ(batch.carried(), vulkan::Carried::Nothing);
  for (draws = 1; !batch.chooseCarried(state, call(GL_TRIANGLE_STRIP, 4), gen::kGroupModelview, read);)
    ASSERT_LT(++draws, 100);
  EXPECT_EQ(draws, 64);
}

TEST(GeometryBatch, CarriesNothingThatTheDeviceCannotTake) {
  vulkan::Batch batch(false);
  for (int i = 0; i < 100; ++i)
    EXPECT_EQ(batch.chooseCarried({}, call(GL_TRIANGLE_STRIP, 4), gen::kGroupModelview, {}), 0u);
}

}  // namespace
}  // namespace anteroom::test
