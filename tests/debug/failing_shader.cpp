// A shader or pipeline that cannot be made leaves one file for a report, and a GL error.
#include <gtest/gtest.h>

#include <filesystem>

#include "layer/vulkan/debug/shader_dump.h"
#include "layer/vulkan/device/device.h"
#include "layer/vulkan/pipelines/pipeline_cache.h"
#include "layer/vulkan/pipelines/shader_library.h"
#include "tests/debug/harness.h"

namespace anteroom::test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> reportsIn(const std::string& folder) {
  std::vector<fs::path> reports;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().filename().string().starts_with("anteroom-shader-")) reports.push_back(entry.path());
  return reports;
}

void expectParts(const std::string& report, std::initializer_list<const char*> parts) {
  for (const char* part : parts)
    EXPECT_NE(report.find(part), report.npos) << part << " is not in\n" << report;
}

// The driver refuses what the layer is told to: every fault is one file, however often it is met.
TEST(FailingShader, RefusedByTheDriver) {
  for (const char* refused : {"shaders", "pipelines"}) {
    const process::TemporaryDirectory folder;
    const std::string dumps = folder.path() + "/made/by the library";
    const Ended run = runProgram({"broken"}, recorded("/dev/null", {{"RECORDING_LAYER_REFUSES", refused},
                                                                    {"ANTEROOM_DUMP_DIR", dumps}}));
    EXPECT_EQ(run.status, 0) << run.output;
    EXPECT_EQ(countOf(run.output, "error 0x505"), 2u) << run.output;
    const bool pipeline = std::string(refused) == "pipelines";
    const auto reports = reportsIn(dumps);
    ASSERT_EQ(reports.size(), pipeline ? 1u : 2u) << run.output;
    for (const fs::path& path : reports) {
      EXPECT_EQ(countOf(run.output, path.string() + "\n"), 1u) << run.output;
      expectParts(contentsOf(path),
                  {"fault: the driver refuses a ", "VkResult -3", "library: Anteroom ", "generator ",
                   "device: llvmpipe", "driver: ", "== log ==", "key: ", "bytes: ", "#version 450"});
    }
    if (pipeline)
      expectParts(contentsOf(reports[0]), {"state: ", "== vertex shader ==", "== fragment shader =="});
  }
}

// Without a folder of its own, it lies beside the cache.
TEST(FailingShader, LiesBesideTheCache) {
  const process::TemporaryDirectory cache;
  runProgram({"broken"}, recorded("/dev/null", {{"RECORDING_LAYER_REFUSES", "pipelines"},
                                                {"ANTEROOM_CACHE", "on"},
                                                {"ANTEROOM_DUMP_DIR", ""},
                                                {"ANTEROOM_CACHE_DIR", cache.path()}}));
  EXPECT_EQ(reportsIn(cache.path()).size(), 1u);
}

// And where neither can be written to, with the temporary files.
TEST(FailingShader, FallsBackToTemporaryFiles) {
  const process::TemporaryDirectory temporary;
  const Ended run = runProgram({"broken"}, recorded("/dev/null", {{"RECORDING_LAYER_REFUSES", "pipelines"},
                                                                  {"ANTEROOM_DUMP_DIR", "/proc/self/nowhere"},
                                                                  {"TMPDIR", temporary.path()}}));
  EXPECT_EQ(reportsIn(temporary.path()).size(), 1u) << run.output;
}

class FailingShaderOnOneDevice : public testing::Test {
 protected:
  void SetUp() override {
    setenv("ANTEROOM_DUMP_DIR", folder_.path().c_str(), 1);
    vulkan::DeviceOptions options;
    options.debug.validation = render::DebugOptions::Validation::Log;
    std::string error;
    device_ = vulkan::VulkanDevice::create(options, error);
    ASSERT_TRUE(device_) << error;
  }
  void TearDown() override {
    device_.reset();
    unsetenv("ANTEROOM_DUMP_DIR");
  }
  std::string report() {
    const auto reports = reportsIn(folder_.path());
    return reports.size() == 1 ? contentsOf(reports[0]) : "there is not one report";
  }

  process::TemporaryDirectory folder_;
  std::unique_ptr<vulkan::VulkanDevice> device_;
};

TEST_F(FailingShaderOnOneDevice, GlslangRefusesAShader) {
  static constexpr vulkan::OwnShader kBad{gen::Stage::Fragment,
                                          "#version 450\n// not a shader\nvoid main() { return 1; }\n"};
  testing::internal::CaptureStderr();
  EXPECT_EQ(device_->shaders().get(kBad), nullptr);
  EXPECT_EQ(device_->shaders().get(kBad), nullptr);
  EXPECT_EQ(countOf(testing::internal::GetCapturedStderr(), "please report"), 1u);
  expectParts(report(), {"fault: glslang refuses a shader", "key: not a shader", "ERROR: ", kBad.text});
}

// A capability that the device was not asked for: the layer objects, the driver does not mind.
TEST_F(FailingShaderOnOneDevice, ValidationFindsFault) {
  static constexpr vulkan::OwnShader kLarge{
      gen::Stage::Fragment,
      "#version 450\n// asks for too much\nlayout(constant_id = 0) const double kLarge = 1.0LF;\n"
      "layout(location = 0) out vec4 color;\nvoid main() { color = vec4(kLarge * gl_FragCoord.x); }\n"};
  const vulkan::Shader* const fragment = device_->shaders().get(kLarge);
  const vulkan::Shader* const vertex = device_->shaders().get(vulkan::kQuadVertex);
  ASSERT_TRUE(fragment && vertex);
  vulkan::PipelineKey key;
  key.vertexShader = vertex->id;
  key.fragmentShader = fragment->id;
  key.colorFormat = VK_FORMAT_R8G8B8A8_UNORM;
  vulkan::BakedState state;
  state.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  state.sampleMask = 1;
  key.state = vulkan::baked(state, device_->features());
  testing::internal::CaptureStderr();
  EXPECT_TRUE(device_->pipelines().get(key, *vertex, *fragment)) << "what the driver takes is used";
  const std::string said = testing::internal::GetCapturedStderr();
  if (vulkan::validationMessages() == 0) GTEST_SKIP() << "there is no validation layer";
  EXPECT_EQ(countOf(said, "please report"), 1u) << said;
  expectParts(report(),
              {"fault: validation finds fault with a pipeline", "state: ", "asks for too much", "Float64"});
}

}  // namespace
}  // namespace anteroom::test
