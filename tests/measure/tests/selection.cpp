// What selects nothing is a mistake, in every program that measures.
#include <gtest/gtest.h>

#include "tests/measure/process.h"

namespace {

class Selection : public testing::TestWithParam<const char*> {};

TEST_P(Selection, OfNothingIsAnError) {
  // MEASURING_PROGRAMS: the folder of the programs.
  const process::Outcome outcome = process::run(
      "/bin/sh", {"-c", std::string(MEASURING_PROGRAMS "/") + GetParam() + " --filter zzz 2>&1"}, {});
  EXPECT_EQ(outcome.status, 2) << outcome.output;
  EXPECT_NE(outcome.output.find("zzz"), std::string::npos) << outcome.output;
}

INSTANTIATE_TEST_SUITE_P(, Selection,
                         testing::Values("anteroom-bench", "anteroom-compare", "rooms bench",
                                         "anteroom-cache-speed"),
                         [](const auto& parameter) {
                           std::string name = parameter.param;
                           for (char& c : name)
                             if (c == '-' || c == ' ') c = '_';
                           return name;
                         });

}  // namespace
