// Which pipelines a program is said to need, and the driver's file.
#include <algorithm>

#include "layer/cache/driver_blob.h"
#include "tests/cache/rows.h"

namespace anteroom::test {
namespace {

// One run of this program.
void runWith(const Folder& folder, const std::vector<int>& pipelines) {
  cache::ShaderCache cache(folder.file(), kNoLimit);
  for (int i : pipelines) cache.use(pipelineOf(i));
}

std::vector<int> usual(const Folder& folder) {
  cache::ShaderCache cache(folder.file(), kNoLimit);
  std::vector<int> result;
  for (const cache::PipelineRow& row : cache.usualPipelines())
    for (int i = 0; i < 1000; ++i)
      if (pipelineOf(i).id() == row.id()) result.push_back(i);
  return result;
}

TEST(Pipelines, TheMostUsedComeFirstThenTheFirstUsed) {
  const Folder folder;
  EXPECT_TRUE(usual(folder).empty());
  runWith(folder, {7, 3, 5});
  EXPECT_EQ(usual(folder), (std::vector{7, 3, 5}));
  runWith(folder, {3, 9});
  EXPECT_EQ(usual(folder), (std::vector{3, 7, 9, 5}));
}

TEST(Pipelines, WhatFourRunsDidWithoutIsNotUsual) {
  const Folder folder;
  for (int i = 0; i < 5; ++i) runWith(folder, {1, 2});
  for (int i = 0; i < 3; ++i) runWith(folder, {2});
  EXPECT_EQ(usual(folder), (std::vector{2, 1}));
  runWith(folder, {2});
  EXPECT_EQ(usual(folder), (std::vector{2}));
  runWith(folder, {1});
  EXPECT_EQ(usual(folder), (std::vector{2, 1}));
}

TEST(Pipelines, AreBounded) {
  const Folder folder;
  std::vector<int> many(400);
  for (int i = 0; i < 400; ++i) many[i] = i;
  runWith(folder, many);
  const std::vector<int> found = usual(folder);
  ASSERT_EQ(found.size(), 256u);
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
}

TEST(Pipelines, ProgramsAreForgotten) {
  const Folder folder;
  cache::Store store;
  ASSERT_EQ(store.open(folder.file(), cache::Store::Mode::Create), cache::Opened::Ok);
  ASSERT_TRUE(store.put(pipelineOf(1)));
  for (int i = 1; i <= 300; ++i) {
    const int64_t run = store.beginRun({i, "program"}, i);
    ASSERT_EQ(run, 1);
    ASSERT_TRUE(store.use(i, pipelineOf(1).id(), run, 0));
  }
  EXPECT_EQ(store.database().ask("SELECT count(*) FROM program", 0), 256);
  EXPECT_EQ(store.database().ask("SELECT count(*) FROM usage", 0), 256);
  EXPECT_EQ(store.database().ask("SELECT min(id) FROM program", 0), 45);
}

TEST(Pipelines, ARowWithAnotherTextIsNotBelieved) {
  const Folder folder;
  runWith(folder, {1, 2});
  cache::Store store;
  ASSERT_EQ(store.open(folder.file(), cache::Store::Mode::Write), cache::Opened::Ok);
  ASSERT_EQ(store.database().run("UPDATE pipeline SET state = 'primitive=points' WHERE vertex = 'vertex 1'"),
            SQLITE_OK);
  EXPECT_EQ(usual(folder), (std::vector{2}));
  int bad = 0;
  EXPECT_TRUE(store.visitPipelines(
      [&](int64_t, cache::PipelineRow&, const std::string& why) { bad += !why.empty(); }));
  EXPECT_EQ(bad, 1);
}

TEST(Pipelines, TheLimitHoldsForThemToo) {
  const Folder folder;
  {
    cache::ShaderCache cache(folder.file(), 256 << 10);
    for (int i = 0; i < 2000; ++i) {
      cache::PipelineRow row = pipelineOf(i);
      row.state.append(1000, 'x');
      cache.use(std::move(row));
    }
    cache.flush();
    storeRow(cache, 1);
  }
  cache::Store store;
  ASSERT_EQ(store.open(folder.file(), cache::Store::Mode::Read), cache::Opened::Ok);
  const int64_t left = store.database().ask("SELECT count(*) FROM pipeline", 0);
  EXPECT_GT(left, 20);
  EXPECT_LT(left, 300);
  EXPECT_EQ(store.database().ask("SELECT count(*) FROM usage", 0), left);
}

std::vector<std::byte> blobOf(size_t size) {
  std::vector<std::byte> bytes(size);
  for (size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::byte>(i * 7);
  return bytes;
}

TEST(PipelinesDriverBlob, IsReadAsItWasWrittenOrNotAtAll) {
  const Folder folder;
  const auto file = folder.path / "driver";
  EXPECT_TRUE(cache::readDriverBlob(file).empty());
  ASSERT_TRUE(cache::writeDriverBlob(file, blobOf(300)));
  ASSERT_TRUE(cache::writeDriverBlob(file, blobOf(400)));
  EXPECT_EQ(cache::readDriverBlob(file), blobOf(400));
  const std::string good = contents(file);
  for (size_t at = 0; at < good.size(); ++at) {
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ (1 << at % 8));
    replace(file, bad);
    ASSERT_TRUE(cache::readDriverBlob(file).empty()) << "byte " << at;
    replace(file, good.substr(0, at));
    ASSERT_TRUE(cache::readDriverBlob(file).empty()) << "cut to " << at;
  }
  EXPECT_TRUE(cache::readDriverBlob(folder.path).empty());
  EXPECT_FALSE(cache::writeDriverBlob("/proc/driver", blobOf(10)));
}

TEST(PipelinesDriverBlob, TheNewestAreKept) {
  const Folder folder;
  const auto now = std::filesystem::file_time_type::clock::now();
  for (int i = 0; i < 5; ++i) {
    const auto file = folder.path / ("driver-a-" + std::to_string(i));
    ASSERT_TRUE(cache::writeDriverBlob(file, blobOf(10)));
    std::filesystem::last_write_time(file, now - std::chrono::hours(i));
  }
  ASSERT_TRUE(cache::writeDriverBlob(folder.path / "driver-b-0", blobOf(10)));
  cache::keepNewestBlobs(folder.path, "driver-a-", 2);
  std::vector<std::string> left;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path))
    left.push_back(entry.path().filename());
  std::sort(left.begin(), left.end());
  EXPECT_EQ(left, (std::vector<std::string>{"driver-a-0", "driver-a-1", "driver-b-0"}));
}

}  // namespace
}  // namespace anteroom::test
