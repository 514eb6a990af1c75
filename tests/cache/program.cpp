// Programs that draw, with a cache and without.
#include <algorithm>
#include <cstdio>

#include "layer/cache/driver_blob.h"
#include "tests/cache/rows.h"

namespace anteroom::test {
namespace {

struct Drawn {
  int compiled = -1, cached = -1, pipelines = -1, ahead = -1;
  unsigned picture = 0;
  std::string err;
};

Drawn draw(const std::vector<std::string>& environment, const std::vector<std::string>& arguments = {},
           const char* program = CACHE_PROGRAM) {
  const Output output = runProgram(program, environment, arguments);
  EXPECT_EQ(output.status, 0) << output.err;
  Drawn run;
  EXPECT_EQ(std::sscanf(output.out.c_str(), "compiled %d cached %d pipelines %d ahead %d picture %x",
                        &run.compiled, &run.cached, &run.pipelines, &run.ahead, &run.picture),
            5)
      << output.out;
  run.err = output.err;
  return run;
}

Drawn drawWith(const std::filesystem::path& folder, const std::vector<std::string>& arguments = {},
               const char* program = CACHE_PROGRAM) {
  return draw({"ANTEROOM_CACHE", "ANTEROOM_CACHE_DIR=" + folder.string()}, arguments, program);
}

int lines(const std::string& text, const std::string& word) {
  int count = 0;
  for (size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

TEST(Program, SecondRunCompilesNothing) {
  const Folder folder;
  const Drawn off = draw({"ANTEROOM_CACHE=off", "ANTEROOM_CACHE_DIR=" + folder.path.string()});
  EXPECT_FALSE(std::filesystem::exists(folder.file()));
  EXPECT_GE(off.compiled, 6);
  EXPECT_EQ(off.cached, 0);
  EXPECT_EQ(lines(off.err, "anteroom"), 0);
  const Drawn first = drawWith(folder.path);
  EXPECT_EQ(first.compiled, off.compiled);
  EXPECT_EQ(first.cached, 0);
  const Drawn second = drawWith(folder.path);
  EXPECT_EQ(second.compiled, 0);
  EXPECT_EQ(second.cached, first.compiled);
  EXPECT_EQ(first.picture, off.picture);
  EXPECT_EQ(second.picture, off.picture);
  EXPECT_EQ(second.err, "");
}

// Full and minimal device.
class ProgramAhead : public testing::TestWithParam<bool> {
 protected:
  Drawn draw(int await, const char* other = nullptr) {
    std::vector<std::string> arguments;
    if (GetParam()) arguments.emplace_back("minimal");
    if (other) arguments.emplace_back(other);
    return test::draw({"ANTEROOM_CACHE", "ANTEROOM_CACHE_DIR=" + folder_.path.string(),
                       "CACHE_AWAIT=" + std::to_string(await)},
                      arguments);
  }
  Folder folder_;
};

TEST_P(ProgramAhead, ASecondRunFindsItsPipelinesMade) {
  const Drawn first = draw(0);
  EXPECT_EQ(first.ahead, 0);
  EXPECT_GE(first.pipelines, 5);
  const Drawn second = draw(first.pipelines);
  EXPECT_EQ(second.ahead, first.pipelines);
  EXPECT_EQ(second.pipelines, first.pipelines) << "and no other";
  EXPECT_EQ(second.compiled, 0);
  EXPECT_EQ(second.picture, first.picture);
  EXPECT_EQ(second.err, "");
  // Draws that do not wait ask while they are being made.
  const Drawn third = draw(0);
  EXPECT_EQ(third.pipelines, first.pipelines);
  EXPECT_EQ(third.picture, first.picture);
}

TEST_P(ProgramAhead, NothingIsMadeThatTheProgramDoesNotUse) {
  const Drawn plain = draw(0);
  const Drawn fog = draw(0, "fog");
  EXPECT_EQ(fog.ahead, 0) << "it was never called so before";
  EXPECT_EQ(fog.compiled, 0) << "the shaders are everybody's";
  const Drawn again = draw(fog.pipelines, "fog");
  EXPECT_EQ(again.ahead, fog.pipelines);
  EXPECT_EQ(again.pipelines, fog.pipelines);
  EXPECT_LT(fog.pipelines, plain.pipelines);
}

TEST_P(ProgramAhead, AnotherGeneratorsPipelinesAreMade) {
  const Drawn first = draw(0);
  cache::Store store;
  ASSERT_EQ(store.open(folder_.file(), cache::Store::Mode::Write), cache::Opened::Ok);
  ASSERT_EQ(store.database().run(
                "UPDATE shader SET generator = 'another', key = x'00', number = number + 1, id = id + 1"),
            SQLITE_OK);
  store.close();
  const Drawn second = draw(first.pipelines);
  EXPECT_EQ(second.ahead, first.pipelines);
  EXPECT_EQ(second.compiled, first.compiled) << "keys are text, and last";
  EXPECT_EQ(second.picture, first.picture);
}

// Rows that say what no renderer says, for the same program: none is made, all else is drawn as ever.
TEST_P(ProgramAhead, HostileRowsAreRefused) {
  const Drawn first = draw(0);
  cache::Store store;
  ASSERT_EQ(store.open(folder_.file(), cache::Store::Mode::Write), cache::Opened::Ok);
  std::vector<cache::PipelineRow> rows;
  ASSERT_TRUE(store.visitPipelines(
      [&](int64_t, cache::PipelineRow& row, const std::string&) { rows.push_back(std::move(row)); }));
  cache::UsageRow usage;
  ASSERT_TRUE(store.visitUsage([&](const cache::UsageRow& row) { usage = row; }));
  const auto key = std::find_if(rows.begin(), rows.end(), [](const auto& row) {
    return row.fragment.find("fog") != std::string::npos;
  });
  const auto plain =
      std::find_if(rows.begin(), rows.end(), [](const auto& row) { return row.fragment == "fragment"; });
  const auto own =
      std::find_if(rows.begin(), rows.end(), [](const auto& row) { return row.vertex[0] == '#'; });
  ASSERT_TRUE(key != rows.end() && plain != rows.end() && own != rows.end());
  std::vector<cache::PipelineRow> bad;
  const auto with = [&](auto change) { change(bad.emplace_back(*key)); };
  for (const char* more :
       {" samples=3", " samples=64", " color=D16_UNORM", " depth=R8G8B8A8_UNORM", " color=37",
        " primitive=quads", " bogus", " array0=R32_SINT/4", " array31=R8_UNORM/1", " dynamic=9",
        " write-mask=16", " line-mode=rectangular", "  "})
    with([&](auto& row) { row.state += more; });
  with([](auto& row) { row.state.clear(); });
  with([](auto& row) { row.state = std::string(100000, 'x'); });
  with([](auto& row) { row.vertex = "vertex lights=9"; });
  with([](auto& row) { row.vertex.clear(); });
  with([&](auto& row) { row.vertex = plain->vertex; });  // writes no fog
  with([&](auto& row) { row.vertex = own->vertex; });
  with([](auto& row) { row.fragment = "#version 450\nvoid main() {}\n"; });
  with([](auto& row) { std::swap(row.vertex, row.fragment); });
  usage.uses = 1000;  // before all others
  for (cache::PipelineRow& row : bad) {
    usage.pipeline = row.id();
    ASSERT_TRUE(store.put(row) && store.put(usage));
  }
  store.close();
  const Drawn second = draw(first.pipelines);
  EXPECT_EQ(second.ahead, first.pipelines);
  EXPECT_EQ(second.pipelines, first.pipelines);
  EXPECT_EQ(second.picture, first.picture);
}

INSTANTIATE_TEST_SUITE_P(Profiles, ProgramAhead, testing::Bool(),
                         [](const auto& minimal) { return minimal.param ? "minimal" : "full"; });

// Two builds whose generators differ share a file, and neither spoils the other's rows.
TEST(Program, TwoGeneratorsSideBySide) {
  const Folder folder;
  const Drawn ours = drawWith(folder.path);
  const Drawn other = drawWith(folder.path, {}, CACHE_PROGRAM_OTHER);
  EXPECT_EQ(other.compiled, ours.compiled);
  EXPECT_EQ(other.picture, ours.picture);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(drawWith(folder.path).compiled, 0);
    EXPECT_EQ(drawWith(folder.path, {}, CACHE_PROGRAM_OTHER).compiled, 0);
  }
  EXPECT_EQ(drawWith(folder.path, {}, CACHE_PROGRAM_OTHER).picture, ours.picture);
}

TEST(Program, ADriversBlobOfAnotherKindDoesNoHarm) {
  const Folder folder;
  const Drawn first = drawWith(folder.path);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path))
    EXPECT_TRUE(entry.path().filename().string().starts_with("anteroom.db")) << entry.path();
  const std::vector<std::byte> noise(5000, std::byte{0x5a});
  for (const char* name : {"driver-10005-0000-00000001", "driver-10005-0000-05806003"})
    EXPECT_TRUE(cache::writeDriverBlob(folder.path / name, noise));
  const Drawn second = drawWith(folder.path);
  EXPECT_EQ(second.picture, first.picture);
  EXPECT_EQ(second.err, "");
}

}  // namespace
}  // namespace anteroom::test
