// ANTEROOM_DEBUG=markers: a tool reads names and groups like the GL program, seen by a layer that writes them
// down.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/debug/harness.h"

namespace anteroom::test {
namespace {

std::string recordedLog(const std::string& debug) {
  const process::TemporaryDirectory folder;
  const std::string log = folder.path() + "/log";
  const Ended run = runProgram({"groups"}, recorded(log, {{"ANTEROOM_DEBUG", debug}}));
  EXPECT_EQ(run.status, 0) << run.output;
  EXPECT_EQ(run.output, "error 0x0\n");
  return contentsOf(log);
}

// The log without names: groups, indented, and what is drawn in them.
std::string treeOf(const std::string& log) {
  std::string tree;
  int depth = 0;
  for (const std::string& line : linesOf(log)) {
    if (line.starts_with("name ")) continue;
    if (line == "end") {
      --depth;
      EXPECT_GE(depth, 0) << log;
      continue;
    }
    tree += std::string(static_cast<size_t>(2 * std::max(depth, 0)), ' ') + line + "\n";
    if (line.starts_with("begin ")) ++depth;
  }
  EXPECT_EQ(depth, 0) << log;
  return tree;
}

TEST(Markers, GroupsReadLikeTheProgram) {
  EXPECT_EQ(treeOf(recordedLog("validation=fatal,markers")),
            "begin glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)\n"
            "begin scene\n"
            "  begin glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, 0): position in buffer 1, indices in "
            "buffer 2\n"
            "    draw indexed 3\n"
            "  begin glDrawArrays(GL_TRIANGLES, 0, 3): texture0 brick (texture 1); position, texCoord0 in "
            "buffer 1\n"
            "    draw 3\n"
            "begin glDrawTexiOES: texture0 brick (texture 1)\n"
            "  draw 4\n"
            "begin glDrawArrays(GL_TRIANGLES, 0, 3): position in client memory\n"
            "  draw 3\n"
            "begin glDrawArrays(GL_TRIANGLES, 3, 3): position in client memory\n"
            "  draw 3\n"
            "begin glDrawArrays(GL_TRIANGLES, 0, 6): position in client memory\n"
            "  draw 6\n"
            "begin glDrawArrays(GL_TRIANGLES, 0, 3): position in client memory; mirror (framebuffer 1)\n"
            "  draw 3\n");
}

TEST(Markers, ObjectsAreNamedAfterThoseOfTheProgram) {
  const std::vector<std::string> lines = linesOf(recordedLog("validation=fatal,markers"));
  const auto named = [&](const std::string& text) {
    return std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
      return line.starts_with("name ") && line.find(text) != line.npos;
    });
  };
  for (const char* text : {" brick (texture 1) 2x2 RGB8", " renderbuffer 1 16x16 RGBA8", " color 64x64 RGBA8",
                           "context 1, slot 0", "the queue of all contexts", "block of buffers and streams, ",
                           "min nearest, mag linear, repeat x repeat"})
    EXPECT_TRUE(named(text)) << text;
  // A pipeline by its two keys and its state; shaders by their keys.
  const auto count = [&](const char* type) {
    return std::count_if(lines.begin(), lines.end(), [&](const std::string& line) {
      return line.starts_with(std::string("name ") + type + " ") && line.find(" | ") != line.npos;
    });
  };
  EXPECT_EQ(count("19"), 2) << "with and without a texture";
}

// Only what the program says itself, and joined draws.
TEST(Markers, OffNothingIsGroupedButTheProgramsGroups) {
  const std::string log = recordedLog("validation=fatal");
  EXPECT_EQ(countOf(log, "begin "), 1u) << log;
  EXPECT_EQ(countOf(log, "begin scene\n"), 1u);
  EXPECT_EQ(countOf(log, "name "), countOf(log, "name 10 brick\n")) << log;
  EXPECT_EQ(countOf(log, "draw 12\n"), 1u) << "the three draws are joined\n" << log;
}

}  // namespace
}  // namespace anteroom::test
