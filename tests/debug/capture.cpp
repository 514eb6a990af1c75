// ANTEROOM_DEBUG=capture, with RenderDoc where it is installed.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/debug/harness.h"

namespace anteroom::test {
namespace {

namespace fs = std::filesystem;

TEST(Capture, SaysWhatToDoWithoutRenderDoc) {
  const Ended run = runProgram({"groups"}, {{"ANTEROOM_DEBUG", "capture"}});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(countOf(run.output, "RenderDoc is not loaded"), 1u) << run.output;
  EXPECT_EQ(countOf(run.output, "ENABLE_VULKAN_RENDERDOC_CAPTURE=1"), 1u);
}

// RenderDoc's layer is switched on by a variable; the recording layer lies below it, so that Mesa's driver
// sees no labels.
process::Environment underRenderDoc(const std::string& debug) {
  process::Environment environment = recorded("/dev/null", {{"ANTEROOM_DEBUG", debug}});
  environment["VK_INSTANCE_LAYERS"] = "VK_LAYER_ANTEROOM_recording";
  environment["ENABLE_VULKAN_RENDERDOC_CAPTURE"] = "1";
  return environment;
}

class CaptureByRenderDoc : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists("/usr/share/vulkan/implicit_layer.d/renderdoc_capture.json") || !fs::exists(RENDERDOCCMD))
      GTEST_SKIP() << "RenderDoc is not installed";
  }
};

// What RenderDoc says of its own capture of a program without a window.
TEST_F(CaptureByRenderDoc, CaptureReadsLikeTheProgram) {
  const Ended run = runProgram({"groups"}, underRenderDoc("markers,capture"));
  EXPECT_EQ(run.status, 0) << run.output;
  const std::string said = "anteroom: frame 1 is captured in ";
  const size_t at = run.output.find(said);
  ASSERT_NE(at, std::string::npos) << run.output;
  const std::string path =
      run.output.substr(at + said.size(), run.output.find(".rdc", at) + 4 - at - said.size());
  const process::TemporaryDirectory folder;
  const std::string text = folder.path() + "/capture.xml";
  process::run(RENDERDOCCMD, {"convert", "-f", path, "-o", text, "-c", "xml"}, {});
  const std::string capture = contentsOf(text);
  for (const char* part :
       {"brick (texture 1) 2x2 RGB8", ">scene<", "glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)<",
        "glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, 0): position in buffer 1, indices in buffer 2<"})
    EXPECT_EQ(countOf(capture, part) > 0, true)
        << part << " is not among " << capture.size() << " characters of " << path;
  fs::remove(path);
}

TEST_F(CaptureByRenderDoc, SaysWhenTheFrameNeverCame) {
  const Ended run = runProgram({"groups"}, underRenderDoc("capture=3"));
  EXPECT_NE(run.output.find("capture: there were only 1 frames"), std::string::npos) << run.output;
}

}  // namespace
}  // namespace anteroom::test
