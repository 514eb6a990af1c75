// Programs that draw, with a cache and without.
#include <cstdio>

#include "tests/cache/rows.h"

namespace anteroom::test {
namespace {

struct Drawn {
  int compiled = -1, cached = -1;
  unsigned picture = 0;
  std::string err;
};

Drawn draw(std::vector<std::string> environment) {
  const Output output = runProgram(CACHE_PROGRAM, environment);
  EXPECT_EQ(output.status, 0) << output.err;
  Drawn run;
  EXPECT_EQ(std::sscanf(output.out.c_str(), "compiled %d cached %d picture %x", &run.compiled, &run.cached,
                        &run.picture),
            3)
      << output.out;
  run.err = output.err;
  return run;
}

Drawn drawWith(const std::filesystem::path& folder) {
  return draw({"ANTEROOM_CACHE", "ANTEROOM_CACHE_DIR=" + folder.string()});
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

}  // namespace
}  // namespace anteroom::test
