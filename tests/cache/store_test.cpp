// The cache by itself: what goes in comes out, and quickly.
#include <chrono>

#include "gen/cache/generator_version.h"
#include "tests/cache/rows.h"

namespace anteroom::test {
namespace {

using Clock = std::chrono::steady_clock;

double microseconds(Clock::duration time) {
  return std::chrono::duration<double, std::micro>(time).count();
}

TEST(Store, WhatIsStoredIsFoundByTheNextCache) {
  const Folder folder;
  const gen::FragmentKey fragment = gen::canonicaliseFragment(gen::State{}, gen::Profile{});
  const gen::VertexKey vertex = gen::canonicaliseVertex(gen::State{}, fragment, gen::Profile{});
  {
    gen::ShaderCache cache(folder.file(), kNoLimit);
    EXPECT_FALSE(cache.filled());
    EXPECT_TRUE(cache.find(gen::KeyKind::Vertex, gen::bytesOf(vertex)).empty());
    cache.store(gen::KeyKind::Vertex, gen::bytesOf(vertex), "a", spirvOf(1), 7);
    cache.store(gen::KeyKind::Fragment, gen::bytesOf(fragment), "b", spirvOf(2), 8);
    storeRow(cache, 3);
    cache.flush();
    EXPECT_EQ(cache.counts().written, 3u);
  }
  gen::ShaderCache cache(folder.file(), kNoLimit);
  EXPECT_TRUE(cache.filled());
  EXPECT_EQ(cache.find(gen::KeyKind::Vertex, gen::bytesOf(vertex)), spirvOf(1));
  EXPECT_EQ(cache.find(gen::KeyKind::Fragment, gen::bytesOf(fragment)), spirvOf(2));
  EXPECT_EQ(findRow(cache, 3), spirvOf(3));
  EXPECT_TRUE(findRow(cache, 4).empty());
  EXPECT_EQ(cache.counts().hits, 3u);
  EXPECT_EQ(cache.counts().misses, 1u);
  EXPECT_EQ(cache.counts().damaged, 0u);
  cache.close();

  gen::Store store;
  ASSERT_EQ(store.open(folder.file(), gen::Store::Mode::Read), gen::Opened::Ok);
  int rows = 0;
  EXPECT_TRUE(store.visit([&](int64_t id, gen::Row& row, const std::string& why) {
    ++rows;
    EXPECT_EQ(why, "");
    EXPECT_EQ(id, row.id());
    EXPECT_EQ(row.generator, gen::generatorVersion());
    EXPECT_EQ(row.uses, 2) << "by two processes: one stored, one found";
    if (row.kind == gen::KeyKind::Vertex) {
      EXPECT_EQ(row.description, describe(vertex));
      EXPECT_EQ(row.glsl, "a");
      EXPECT_EQ(row.compileMicroseconds, 7);
    }
  }));
  EXPECT_EQ(rows, 3);
}

}  // namespace
}  // namespace anteroom::test
