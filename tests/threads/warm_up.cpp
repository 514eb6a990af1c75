// Pipelines that are made ahead while threads draw, and processes that share a cache meanwhile.
#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "tests/measure/process.h"

namespace threads {
namespace {

class WarmUp : public testing::Test {
 protected:
  process::Outcome run(const char* threads) const {
    return process::run(STATES_PROGRAM, {threads}, environment_);
  }
  // The same picture as without a cache, whatever else happens.
  void expectGood(const process::Outcome& outcome) {
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.output, plain_.output);
  }
  void SetUp() override {
    plain_ = process::run(STATES_PROGRAM, {"1"}, {{"ANTEROOM_CACHE", "off"}});
    ASSERT_EQ(plain_.status, 0);
    ASSERT_NE(plain_.output, "");
  }
  void TearDown() override {
    const process::Outcome verified = process::run(CACHE_TOOL, {"verify"}, environment_);
    EXPECT_EQ(verified.status, 0) << verified.output;
  }

  process::TemporaryDirectory folder_;
  process::Environment environment_ = {{"ANTEROOM_CACHE", "on"}, {"ANTEROOM_CACHE_DIR", folder_.path()}};
  process::Outcome plain_;
};

TEST_F(WarmUp, BesideThreadsThatDraw) {
  expectGood(run("3"));  // fills the cache
  for (int i = 0; i < 2; ++i) expectGood(run("4"));
}

TEST_F(WarmUp, ProcessesAtOnce) {
  for (int round = 0; round < 2; ++round) {  // empty, then full
    process::Outcome outcomes[3];
    std::vector<std::thread> starters;
    for (process::Outcome& outcome : outcomes) starters.emplace_back([&] { outcome = run("2"); });
    for (std::thread& starter : starters) starter.join();
    for (const process::Outcome& outcome : outcomes) expectGood(outcome);
  }
}

}  // namespace
}  // namespace threads
