// ANTEROOM_DEBUG: one list of words, and what the simple ones do.
#include <gtest/gtest.h>

#include <filesystem>

#include "layer/render/debug_options.h"
#include "tests/debug/harness.h"

namespace anteroom::test {
namespace {

using render::DebugOptions;

DebugOptions parse(std::string_view words, std::string* said = nullptr) {
  std::string complaint;
  const DebugOptions options = render::parseDebugOptions(words, complaint);
  if (said)
    *said = complaint;
  else
    EXPECT_EQ(complaint, "");
  return options;
}

TEST(Options, NothingIsOnByItself) {
  const DebugOptions none = parse("");
  EXPECT_EQ(none.validation, DebugOptions::Validation::Off);
  EXPECT_FALSE(none.markers || none.errors || none.stats || none.glsl || none.captureFrame);
}

TEST(Options, WordsAndTheirValues) {
  const DebugOptions all = parse("validation=fatal,markers,,errors,stats,glsl=/some where,capture=7,");
  EXPECT_EQ(all.validation, DebugOptions::Validation::Abort);
  EXPECT_TRUE(all.markers && all.errors && all.stats && all.glsl);
  EXPECT_EQ(all.glslFolder, "/some where");
  EXPECT_EQ(all.captureFrame, 7);
  EXPECT_EQ(parse("validation").validation, DebugOptions::Validation::Log);
  EXPECT_EQ(parse("capture").captureFrame, 1);
  EXPECT_EQ(parse("glsl").glslFolder, "");
}

TEST(Options, UnknownWordsMakeOneLineWithTheKnownOnes) {
  for (const char* words :
       {"validations", "errors,marker,shaders", "capture=0", "capture=2x", "markers=no", "="}) {
    std::string said;
    parse(words, &said);
    EXPECT_EQ(countOf(said, "\n"), 1u) << words;
    EXPECT_NE(said.find("validation[=fatal]"), said.npos) << said;
  }
  std::string said;
  EXPECT_TRUE(parse("errors,marker,shaders", &said).errors);
  EXPECT_NE(said.find("does not know marker, shaders;"), said.npos) << said;
}

TEST(Options, HelpListsEveryWord) {
  std::string said;
  EXPECT_TRUE(parse("markers,help", &said).markers);
  EXPECT_EQ(linesOf(said).size(), 7u) << said;
}

TEST(Options, AreReadOnceByAProgram) {
  const Ended run = runProgram({"broken"}, {{"ANTEROOM_DEBUG", "nonsense"}});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(countOf(run.output, "does not know nonsense"), 1u) << run.output;
}

TEST(Options, ErrorsAreLoggedWithCommandAndReason) {
  const Ended run = runProgram({"misuse"}, {{"ANTEROOM_DEBUG", "validation=fatal,errors"}});
  EXPECT_NE(run.output.find("anteroom: glLineWidth: GL_INVALID_VALUE: width is -1"), std::string::npos)
      << run.output;
  EXPECT_NE(run.output.find("anteroom: eglCreatePbufferSurface: EGL_BAD_CONFIG"), std::string::npos)
      << run.output;
  EXPECT_EQ(runProgram({"misuse"}, {}).output, "error 0x501\n");
}

TEST(Options, StatsAreLoggedWhenAContextEnds) {
  // Without the validation layer: it does not outlive what an exit may still do.
  const process::Environment on{{"ANTEROOM_DEBUG", "stats"}};
  for (const char* verb : {"groups", "leave"}) {
    const Ended run = runProgram({verb}, on);
    EXPECT_EQ(run.status, 0) << run.output;
    EXPECT_EQ(countOf(run.output, ": 1 frames, "), 1u) << run.output;
  }
}

TEST(Options, GlslTellsOfEveryShader) {
  const process::TemporaryDirectory folder, cache;
  const Ended logged = runProgram({"broken"}, {{"ANTEROOM_DEBUG", "glsl"}});
  EXPECT_EQ(countOf(logged.output, "anteroom: vertex shader: "), 1u) << logged.output;
  EXPECT_EQ(countOf(logged.output, "anteroom: fragment shader: "), 1u);
  EXPECT_EQ(countOf(logged.output, "#version 450"), 2u);

  // The second time they come from the cache, and are told of all the same.
  for (int i = 0; i < 2; ++i) {
    const std::string to = folder.path() + "/glsl" + std::to_string(i);
    const Ended run = runProgram(
        {"broken"},
        {{"ANTEROOM_DEBUG", "glsl=" + to}, {"ANTEROOM_CACHE", "on"}, {"ANTEROOM_CACHE_DIR", cache.path()}});
    EXPECT_EQ(countOf(run.output, "anteroom"), 0u) << run.output;
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(to)) {
      ++files;
      EXPECT_EQ(countOf(contentsOf(entry.path()), "#version 450"), 1u) << entry.path();
    }
    EXPECT_EQ(files, 2);
  }
}

}  // namespace
}  // namespace anteroom::test
