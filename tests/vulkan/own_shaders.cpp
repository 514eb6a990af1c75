// The renderer's own shaders are the files of shaders/own.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "layer/vulkan/pipelines/own_shaders.h"

namespace anteroom::test {
namespace {

TEST(OwnShaders, AreTheFilesOfTheirFolder) {
  std::set<std::pair<gen::Stage, std::string>> files, embedded;
  for (const auto& entry : std::filesystem::directory_iterator(ANTEROOM_SOURCE_DIR "/shaders/own")) {
    std::ifstream in(entry.path());
    const bool vertex = entry.path().stem().string().ends_with("_vertex");
    files.emplace(vertex ? gen::Stage::Vertex : gen::Stage::Fragment,
                  std::string(std::istreambuf_iterator<char>(in), {}));
  }
  for (const vulkan::OwnShader* own : vulkan::ownShaders()) embedded.emplace(own->stage, own->text);
  EXPECT_EQ(embedded, files);
  EXPECT_EQ(embedded.size(), 4u);
}

TEST(OwnShaders, Compile) {
  for (const vulkan::OwnShader* own : vulkan::ownShaders()) {
    const gen::CompileResult result = gen::compile(own->stage, own->text);
    EXPECT_FALSE(result.spirv.empty()) << own->text << result.log;
  }
}

}  // namespace
}  // namespace anteroom::test
