// The cache by itself: what goes in comes out, and quickly.
#include <algorithm>
#include <chrono>
#include <cstdio>

#include "layer/cache/generator_version.h"
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
    cache::ShaderCache cache(folder.file(), kNoLimit);
    EXPECT_FALSE(cache.filled());
    EXPECT_TRUE(cache.find(cache::KeyKind::Vertex, cache::bytesOf(vertex)).empty());
    cache.store(cache::KeyKind::Vertex, cache::bytesOf(vertex), "a", spirvOf(1), 7);
    cache.store(cache::KeyKind::Fragment, cache::bytesOf(fragment), "b", spirvOf(2), 8);
    storeRow(cache, 3);
    cache.flush();
    EXPECT_EQ(cache.counts().written, 3u);
  }
  cache::ShaderCache cache(folder.file(), kNoLimit);
  EXPECT_TRUE(cache.filled());
  EXPECT_EQ(cache.find(cache::KeyKind::Vertex, cache::bytesOf(vertex)), spirvOf(1));
  EXPECT_EQ(cache.find(cache::KeyKind::Fragment, cache::bytesOf(fragment)), spirvOf(2));
  EXPECT_EQ(findRow(cache, 3), spirvOf(3));
  EXPECT_TRUE(findRow(cache, 4).empty());
  EXPECT_EQ(cache.counts().hits, 3u);
  EXPECT_EQ(cache.counts().misses, 1u);
  EXPECT_EQ(cache.counts().damaged, 0u);
  cache.close();

  cache::Store store;
  ASSERT_EQ(store.open(folder.file(), cache::Store::Mode::Read), cache::Opened::Ok);
  int rows = 0;
  EXPECT_TRUE(store.visitShaders([&](int64_t, int64_t id, cache::ShaderRow& row, const std::string& why) {
    ++rows;
    EXPECT_EQ(why, "");
    EXPECT_EQ(id, row.id());
    EXPECT_EQ(row.generator, cache::generatorVersion());
    EXPECT_EQ(row.uses, 2) << "by two processes: one stored, one found";
    if (row.kind == cache::KeyKind::Vertex) {
      EXPECT_EQ(row.description, describe(vertex));
      EXPECT_EQ(row.glsl, "a");
      EXPECT_EQ(row.compileMicroseconds, 7);
    }
  }));
  EXPECT_EQ(rows, 3);
}

TEST(Store, TenThousandRowsAreFound) {
  const Folder folder;
  constexpr int kRows = 10000;
  {
    cache::Store store;
    ASSERT_EQ(store.open(folder.file(), cache::Store::Mode::Create), cache::Opened::Ok);
    ASSERT_TRUE(store.begin());
    for (int i = 0; i < kRows; ++i) {
      const std::string key = keyText(i);
      ASSERT_TRUE(
          store.put(cache::makeRow(cache::KeyKind::VertexText, keyBytes(key), key, spirvOf(i, 700), 1)));
    }
    ASSERT_TRUE(store.commit());
  }
  std::vector<double> opening, finding;  // reported, not judged: machines differ
  for (int i = 0; i < 9; ++i) {
    cache::Store store;
    const auto start = Clock::now();
    ASSERT_EQ(store.open(folder.file(), cache::Store::Mode::Write), cache::Opened::Ok);
    ASSERT_TRUE(store.holdsCurrent());
    opening.push_back(microseconds(Clock::now() - start));
  }
  cache::ShaderCache cache(folder.file(), kNoLimit);
  ASSERT_TRUE(cache.filled());
  for (int i = 0; i < 1000; ++i) {
    const int row = i * 7919 % kRows;
    const auto start = Clock::now();
    const auto spirv = findRow(cache, row);
    finding.push_back(microseconds(Clock::now() - start));
    ASSERT_EQ(spirv, spirvOf(row, 700));
  }
  std::sort(opening.begin(), opening.end());
  std::sort(finding.begin(), finding.end());
  RecordProperty("opening_us", static_cast<int>(opening[4]));
  RecordProperty("look_up_us", static_cast<int>(finding[500]));
  std::printf("opening %.0f us, a look-up %.1f us (medians)\n", opening[4], finding[500]);
}

TEST(Store, TheLimitDropsWhatWasUnusedForLongest) {
  const Folder folder;
  constexpr uint64_t kLimit = 256 << 10;
  cache::ShaderCache cache(folder.file(), kLimit);
  for (int i = 0; i < 300; ++i) {
    storeRow(cache, i, 1000);
    if (i % 50 == 49) cache.flush();
  }
  cache.close();
  cache::Store store;
  ASSERT_EQ(store.open(folder.file(), cache::Store::Mode::Read), cache::Opened::Ok);
  const int64_t rows = store.database().ask("SELECT count(*) FROM shader", 0);
  EXPECT_GT(rows, 20);
  EXPECT_LT(rows, 60);
  EXPECT_LT(std::filesystem::file_size(folder.file()), 2 * kLimit);
}

}  // namespace
}  // namespace anteroom::test
