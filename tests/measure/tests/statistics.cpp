#include "tests/measure/statistics.h"

#include <gtest/gtest.h>

namespace measure {
namespace {

TEST(Statistics, PercentilesLieBetweenNeighbours) {
  const std::vector<double> values = {40, 10, 30, 20};
  EXPECT_DOUBLE_EQ(percentile(values, 0), 10);
  EXPECT_DOUBLE_EQ(percentile(values, 1), 40);
  EXPECT_DOUBLE_EQ(percentile(values, 0.9), 37);
  EXPECT_DOUBLE_EQ(median(values), 25);
  EXPECT_DOUBLE_EQ(median({3, 1, 2}), 2);
  EXPECT_DOUBLE_EQ(median({7}), 7);
}

TEST(Statistics, SpreadIsHalfOfTheRangeByTheMedian) {
  const Summary some = summary({10, 12, 9});
  EXPECT_EQ(some.count, 3u);
  EXPECT_DOUBLE_EQ(some.least, 9);
  EXPECT_DOUBLE_EQ(some.greatest, 12);
  EXPECT_DOUBLE_EQ(some.spread(), 0.15);
  EXPECT_EQ(summary({}).count, 0u);
  EXPECT_DOUBLE_EQ(summary({}).spread(), 0);
}

// A round that is slow for both does not show in the ratio.
TEST(Statistics, RatiosAreOfTheSameRound) {
  const Summary slowRound = ratio({2, 20, 2.2}, {1, 10, 1});
  EXPECT_EQ(slowRound.count, 3u);
  EXPECT_DOUBLE_EQ(slowRound.median, 2);
  EXPECT_NEAR(slowRound.spread(), 0.05, 1e-9);
  EXPECT_EQ(ratio({1, 2, 3}, {1}).count, 1u);
  EXPECT_EQ(ratio({1}, {0}).count, 0u);
}

}  // namespace
}  // namespace measure
