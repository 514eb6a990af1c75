// Runs the cases; the first line of a failure names the chapter that failed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <string>

namespace {

class NameChapter : public testing::EmptyTestEventListener {
 public:
  void OnTestPartResult(const testing::TestPartResult& result) override {
    if (!result.failed()) return;
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    const std::string chapter = test ? test->test_suite_name() : "set-up";
    if (chapter == named_) return;
    named_ = chapter;
    fmt::print("FAILED chapter {}\n", chapter);
    std::fflush(stdout);
  }

 private:
  std::string named_;
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
