// The steady draw path allocates nothing and creates nothing: every scene but the uploads, once it runs.

#include <GLES/gl.h>
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>

#include "allocations.h"
#include "scene.h"
#include "session.h"

namespace bench {

namespace {

constexpr unsigned kWarmUpFrames = 12;
constexpr unsigned kFrames = 12;

using Counts = std::map<std::string, unsigned>;

// By the counting layer; empty when the Vulkan loader has not loaded it.
Counts createdObjects() {
  Counts counts;
  void* const layer = dlopen(COUNTING_LAYER, RTLD_NOW | RTLD_NOLOAD);
  if (!layer) return counts;
  using CountedCommand = const char* (*)(unsigned, unsigned*);
  const auto countedCommand = reinterpret_cast<CountedCommand>(dlsym(layer, "countedCommand"));
  unsigned count = 0;
  for (unsigned i = 0; const char* name = countedCommand(i, &count); ++i) counts[name] = count;
  dlclose(layer);
  return counts;
}

void drawFrames(Scene& scene, unsigned first, unsigned count) {
  for (unsigned number = first; number < first + count; ++number) {
    scene.frame(number);
    glFinish();
  }
}

class SteadyResources : public testing::TestWithParam<std::string> {
 protected:
  static void SetUpTestSuite() {
    setenv("VK_ADD_LAYER_PATH", COUNTING_LAYER_FOLDER, 1);
    setenv("VK_INSTANCE_LAYERS", "VK_LAYER_ANTEROOM_counting", 1);
    setenv("ANTEROOM_CACHE", "off", 1);
    display_ = openDisplay();
  }
  static void TearDownTestSuite() { eglTerminate(display_); }
  static EGLDisplay display_;
};

EGLDisplay SteadyResources::display_ = EGL_NO_DISPLAY;

std::vector<std::string> sceneNames() {
  std::vector<std::string> names;
  for (const auto& scene : allScenes())
    if (!scene->name().starts_with("upload")) names.push_back(scene->name());
  return names;
}

std::string parameterName(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  for (char& c : name)
    if (c == '.') c = '_';
  return name;
}

TEST_P(SteadyResources, NothingIsAllocatedOrCreated) {
  const Session session(display_);
  const std::string implementation = implementationName(display_);
  if (implementation.find("Anteroom") == std::string::npos) GTEST_SKIP() << "not ours: " << implementation;
  ASSERT_FALSE(createdObjects().empty()) << "the counting layer is not loaded";
  const Scenes scenes = allScenes();
  Scene& scene =
      **std::find_if(scenes.begin(), scenes.end(), [](const auto& s) { return s->name() == GetParam(); });
  scene.begin();
  drawFrames(scene, 0, kWarmUpFrames);

  const Counts before = createdObjects();
  beginCountingAllocations();
  drawFrames(scene, kWarmUpFrames, kFrames);
  const AllocationCount allocations = endCountingAllocations();

  EXPECT_EQ(createdObjects(), before);
  EXPECT_EQ(allocations.number, 0u) << testing::PrintToString(allocations.callers);
  EXPECT_EQ(scene.check(kWarmUpFrames + kFrames - 1).fault, "");
}

INSTANTIATE_TEST_SUITE_P(Scenes, SteadyResources, testing::ValuesIn(sceneNames()), parameterName);

// That a count of nothing means something.
TEST(AllocationCounter, SeesAllocations) {
  beginCountingAllocations();
  void* volatile block = operator new(100);
  operator delete(block);
  EXPECT_EQ(endCountingAllocations().number, 1u);
}

}  // namespace

}  // namespace bench
