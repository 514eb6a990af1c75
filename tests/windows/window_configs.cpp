// EGL 1.5 section 3.4: configs for windows and their visuals.
#include <set>

#include "window_fixture.h"

namespace windows {
namespace {

class WindowConfigs : public WindowTest {
 protected:
  EGLint bits(EGLConfig config, bool alpha) const {
    EGLint sum = alpha ? attribute(config, EGL_ALPHA_SIZE) : 0;
    for (EGLint name : {EGL_RED_SIZE, EGL_GREEN_SIZE, EGL_BLUE_SIZE}) sum += attribute(config, name);
    return sum;
  }
};
ON_ALL_PLATFORMS(WindowConfigs);

// EGL_WINDOW_BIT is what eglChooseConfig looks for unless told otherwise.
TEST_P(WindowConfigs, ChosenByDefault) {
  for (const std::vector<EGLint>& more :
       {std::vector<EGLint>{}, {EGL_DEPTH_SIZE, 24}, {EGL_DEPTH_SIZE, 24, EGL_STENCIL_SIZE, 8}}) {
    std::vector<EGLint> attributes = {
        EGL_RENDERABLE_TYPE, EGL_OPENGL_ES_BIT, EGL_RED_SIZE, 8, EGL_GREEN_SIZE, 8, EGL_BLUE_SIZE, 8};
    attributes.insert(attributes.end(), more.begin(), more.end());
    attributes.push_back(EGL_NONE);
    EGLConfig config = nullptr;
    EGLint count = 0;
    ASSERT_TRUE(eglChooseConfig(display_, attributes.data(), &config, 1, &count));
    ASSERT_EQ(count, 1);
    EXPECT_TRUE(attribute(config, EGL_SURFACE_TYPE) & EGL_WINDOW_BIT);
  }
  EXPECT_NE(windowConfig({EGL_DEPTH_SIZE, 24, EGL_STENCIL_SIZE, 8}), nullptr);
}

// A visual of the config's depth. Mesa also gives configs with alpha to visuals without.
TEST_P(WindowConfigs, Visuals) {
  const std::vector<EGLConfig> configs = windowConfigs();
  ASSERT_FALSE(configs.empty());
  if (onWayland()) return;
  for (EGLConfig each : configs) {
    const int depth = native().visualDepth(fitting(each).visual);
    EXPECT_TRUE(depth == bits(each, true) || depth == bits(each, false))
        << "config " << attribute(each, EGL_CONFIG_ID) << " depth " << depth;
    // TrueColor or DirectColor
    const EGLint type = attribute(each, EGL_NATIVE_VISUAL_TYPE);
    EXPECT_TRUE(type == 4 || type == 5) << type;
  }
}

TEST_P(WindowConfigs, NoVisualWithoutWindows) {
  MESA_DISAGREES("3.4.1.3", "configs without windows have visuals");
  EGLint count = 0;
  EXPECT_TRUE(eglGetConfigs(display_, nullptr, 0, &count));
  std::vector<EGLConfig> configs(std::size_t(count), nullptr);
  EXPECT_TRUE(eglGetConfigs(display_, configs.data(), count, &count));
  for (EGLConfig each : configs) {
    if (attribute(each, EGL_SURFACE_TYPE) & EGL_WINDOW_BIT) continue;
    EXPECT_EQ(attribute(each, EGL_NATIVE_VISUAL_ID), 0);
    EXPECT_EQ(attribute(each, EGL_NATIVE_VISUAL_TYPE), EGL_NONE);
  }
}

// The type of the visual is a criterion only for configs that have one.
TEST_P(WindowConfigs, ChosenByVisualType) {
  if (onWayland()) GTEST_SKIP() << "no types of visuals";
  const EGLint type = attribute(windowConfig(), EGL_NATIVE_VISUAL_TYPE);
  const std::vector<EGLConfig> found = windowConfigs({EGL_NATIVE_VISUAL_TYPE, type});
  EXPECT_FALSE(found.empty());
  for (EGLConfig each : found) EXPECT_EQ(attribute(each, EGL_NATIVE_VISUAL_TYPE), type);
  EXPECT_TRUE(windowConfigs({EGL_NATIVE_VISUAL_TYPE, 77}).empty());
}

TEST_P(WindowConfigs, SwapIntervals) {
  for (EGLConfig each : windowConfigs()) {
    EXPECT_LE(attribute(each, EGL_MIN_SWAP_INTERVAL), 1);
    EXPECT_GE(attribute(each, EGL_MAX_SWAP_INTERVAL), attribute(each, EGL_MIN_SWAP_INTERVAL));
  }
}

// Our own promise: what programs ask for, each with and without depth and stencil, and with samples.
TEST_P(WindowConfigs, PromisedFormats) {
  MESA_DISAGREES("3.4", "these are our own promises");
  std::set<std::vector<EGLint>> found;
  for (EGLConfig each : windowConfigs())
    found.insert({bits(each, false), attribute(each, EGL_ALPHA_SIZE), attribute(each, EGL_DEPTH_SIZE),
                  attribute(each, EGL_STENCIL_SIZE), attribute(each, EGL_SAMPLES)});
  for (EGLint alpha : {0, 8}) {
    for (EGLint samples : {0, 4}) {
      EXPECT_TRUE(found.count({24, alpha, 0, 0, samples})) << alpha << " " << samples;
      EXPECT_TRUE(found.count({24, alpha, 24, 8, samples})) << alpha << " " << samples;
    }
  }
}

}  // namespace
}  // namespace windows
