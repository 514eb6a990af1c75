// Many processes, some of which end as they should not.
#include <signal.h>
#include <unistd.h>

#include <cstdlib>
#include <random>
#include <set>

#include "tests/cache/rows.h"

namespace anteroom::test {
namespace {

TEST(Processes, EightWriteAtOnce) {
  const Folder folder;
  constexpr int kEach = 40;
  std::vector<int> children;
  for (int p = 0; p < 8; ++p)
    children.push_back(fork([&] {
      cache::ShaderCache cache(folder.file(), kNoLimit);
      for (int i = 0; i < kEach; ++i) {
        // Half of them are everyone's.
        const int row = i % 2 ? i : p * 1000 + i;
        if (findRow(cache, row).empty()) storeRow(cache, row);
        if (i % 10 == 9) cache.flush();
      }
      cache.close();
      return cache.counts().damaged == 0 ? 0 : 1;
    }));
  for (int child : children) EXPECT_EQ(join(child), 0);
  cache::ShaderCache cache(folder.file(), kNoLimit);
  for (int p = 0; p < 8; ++p)
    for (int i = 0; i < kEach; ++i) {
      const int row = i % 2 ? i : p * 1000 + i;
      EXPECT_EQ(findRow(cache, row), spirvOf(row)) << row;
    }
}

// A child that stores row after row, and tells which ones are committed, until it is killed.
int storeUntilKilled(const std::filesystem::path& file, int next, int told) {
  cache::ShaderCache cache(file, kNoLimit);
  for (int i = next;; ++i) {
    storeRow(cache, i, 500);
    cache.use(pipelineOf(i));
    cache.flush();
    if (cache.counts().written == 0) continue;
    if (write(told, &i, sizeof i) != sizeof i) return 1;
  }
}

// The pipelines of rows before `end` that are there.
int pipelinesThere(const std::filesystem::path& file, int end) {
  cache::Store store;
  EXPECT_EQ(store.open(file, cache::Store::Mode::Read), cache::Opened::Ok);
  std::set<int64_t> found;
  EXPECT_TRUE(store.visitPipelines([&](int64_t id, cache::PipelineRow&, const std::string& why) {
    EXPECT_EQ(why, "");
    found.insert(id);
  }));
  int there = 0;
  for (int i = 0; i < end; ++i) there += static_cast<int>(found.count(pipelineOf(i).id()));
  return there;
}

TEST(Processes, AKillLosesNoCommittedRow) {
  const Folder folder;
  std::mt19937 random(1);
  int next = 0, told = 0;
  // On a busy machine a child is often killed before it stores anything: more rounds, until rows were at
  // stake.
  for (int round = 0; round < 200 || (told <= 100 && round < 4000); ++round) {
    int pipe[2];
    ASSERT_EQ(::pipe(pipe), 0);
    const int begun = next;
    const int child = fork([&] { return storeUntilKilled(folder.file(), begun, pipe[1]); });
    usleep(500 + random() % 20000);
    kill(child, SIGKILL);
    EXPECT_EQ(join(child), -SIGKILL);
    close(pipe[1]);
    for (int i; read(pipe[0], &i, sizeof i) == sizeof i;) {
      next = i + 1;
      ++told;
    }
    close(pipe[0]);
    cache::ShaderCache cache(folder.file(), kNoLimit);
    for (int i = begun; i < next; ++i) ASSERT_EQ(findRow(cache, i), spirvOf(i, 500)) << "round " << round;
    EXPECT_EQ(cache.counts().damaged, 0u);
    ++next;  // it may or may not be there
    storeRow(cache, next - 1, 500);
    cache.use(pipelineOf(next - 1));
  }
  EXPECT_GT(told, 100);
  cache::ShaderCache cache(folder.file(), kNoLimit);
  for (int i = 0; i < next; ++i) ASSERT_EQ(findRow(cache, i), spirvOf(i, 500));
  EXPECT_EQ(pipelinesThere(folder.file(), next), next);
}

TEST(Processes, AForkedChildLeavesTheCacheAlone) {
  const Folder folder;
  auto* cache = new cache::ShaderCache(folder.file(), kNoLimit);
  storeRow(*cache, 1);
  cache->flush();
  const int child = fork([&] {
    storeRow(*cache, 2);
    cache->flush();
    cache->close();
    return findRow(*cache, 1).empty() ? 0 : 1;
  });
  EXPECT_EQ(join(child), 0);
  EXPECT_EQ(findRow(*cache, 1), spirvOf(1));
  EXPECT_TRUE(findRow(*cache, 2).empty());
  storeRow(*cache, 2);
  delete cache;
  cache::ShaderCache again(folder.file(), kNoLimit);
  EXPECT_EQ(findRow(again, 2), spirvOf(2));
}

}  // namespace
}  // namespace anteroom::test
