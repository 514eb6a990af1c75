// fork() without exec, in processes of their own.
#include <gtest/gtest.h>

#include "tests/measure/process.h"

namespace threads {
namespace {

class Forks : public testing::TestWithParam<const char*> {};

// Parent and child use one file of the cache, that only the parent may touch.
TEST_P(Forks, HarmNobody) {
  const process::TemporaryDirectory folder;
  // What only the parent's other threads refer to counts as leaked in a child.
  const process::Environment environment = {
      {"ANTEROOM_CACHE", "on"}, {"ANTEROOM_CACHE_DIR", folder.path()}, {"ASAN_OPTIONS", "detect_leaks=0"}};
  for (int run = 0; run < 2; ++run) {  // the cache is empty at first
    const process::Outcome outcome = process::run(FORKS_PROGRAM, {GetParam()}, environment);
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.output, "");
  }
  const process::Outcome verified = process::run(CACHE_TOOL, {"verify"}, environment);
  EXPECT_EQ(verified.status, 0) << verified.output;
}

INSTANTIATE_TEST_SUITE_P(, Forks,
                         testing::Values("exits", "exits-at-once", "uses-parents", "initializes", "keeps",
                                         "forks-again", "in-thread", "busy"),
                         [](const auto& of) {
                           std::string name = of.param;
                           for (char& letter : name)
                             if (letter == '-') letter = '_';
                           return name;
                         });

}  // namespace
}  // namespace threads
