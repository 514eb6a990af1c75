// Runs the cases; the first line of a failure names the chapter that failed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <string>

namespace {

class NameChapter : public testing::EmptyTestEventListener {
 public:
  // GoogleTest holds a lock while it reports a failure: which test runs must be known by then.
  void OnTestStart(const testing::TestInfo& test) override { chapter_ = test.test_suite_name(); }
  void OnTestPartResult(const testing::TestPartResult& result) override {
    if (!result.failed() || chapter_ == named_) return;
    named_ = chapter_;
    fmt::print("FAILED chapter {}\n", chapter_);
    std::fflush(stdout);
  }

 private:
  std::string chapter_ = "set-up", named_;
};

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  // Before the printer of failures, which comes with GoogleTest.
  testing::TestEventListeners& listeners = testing::UnitTest::GetInstance()->listeners();
  testing::TestEventListener* printer = listeners.Release(listeners.default_result_printer());
  listeners.Append(new NameChapter);
  listeners.Append(printer);
  return RUN_ALL_TESTS();
}
