// EGL 1.5 section 3.4: the configs, their selection and their order.
#include <algorithm>
#include <array>
#include <set>

#include "egl_fixture.h"

namespace egl_conformance {
namespace {

class Configs : public EglTest {
 protected:
  std::vector<EGLConfig> all() const {
    EGLint count = 0;
    EXPECT_TRUE(eglGetConfigs(display_, nullptr, 0, &count));
    std::vector<EGLConfig> configs(static_cast<std::size_t>(count));
    EXPECT_TRUE(eglGetConfigs(display_, configs.data(), count, &count));
    return configs;
  }
  // EGL_EXT_pixel_format_float: by default only configs of fixed-point components match.
  bool fixedPoint(EGLConfig config) const {
    return !names(eglQueryString(display_, EGL_EXTENSIONS), "EGL_EXT_pixel_format_float") ||
           attribute(config, EGL_COLOR_COMPONENT_TYPE_EXT) == EGL_COLOR_COMPONENT_TYPE_FIXED_EXT;
  }
  std::vector<EGLConfig> matching(std::vector<EGLint> attributes) const {
    attributes.push_back(EGL_NONE);
    EGLint count = 0;
    EXPECT_TRUE(eglChooseConfig(display_, attributes.data(), nullptr, 0, &count));
    std::vector<EGLConfig> configs(static_cast<std::size_t>(count));
    EXPECT_TRUE(eglChooseConfig(display_, attributes.data(), configs.data(), count, &count));
    return configs;
  }
};

// 3.4.1
TEST_F(Configs, GetConfigs) {
  const std::vector<EGLConfig> configs = all();
  ASSERT_FALSE(configs.empty());
  EXPECT_EQ(std::set<EGLConfig>(configs.begin(), configs.end()).size(), configs.size());
  std::array<EGLConfig, 3> few = {};
  EGLint count = 0;
  EXPECT_TRUE(eglGetConfigs(display_, few.data(), 2, &count));
  EXPECT_EQ(count, 2);
  EXPECT_EQ(few[2], nullptr) << "written beyond config_size";
  EXPECT_FALSE(eglGetConfigs(display_, few.data(), 2, nullptr));
  EXPECT_EGL_ERROR(EGL_BAD_PARAMETER);
  EXPECT_FALSE(eglChooseConfig(display_, nullptr, few.data(), 2, nullptr));
  EXPECT_EGL_ERROR(EGL_BAD_PARAMETER);
}

// 3.4: the formats that this implementation promises, each with pbuffers, ES 1, depth, stencil and samples.
TEST_F(Configs, PromisedFormats) {
  MESA_DISAGREES("3.4", "these are our own promises");
  const std::array<std::array<EGLint, 4>, 5> formats = {
      {{8, 8, 8, 8}, {8, 8, 8, 0}, {5, 6, 5, 0}, {5, 5, 5, 1}, {4, 4, 4, 4}}};
  std::set<std::vector<EGLint>> found;
  for (EGLConfig config : all()) {
    if (!(attribute(config, EGL_SURFACE_TYPE) & EGL_PBUFFER_BIT)) continue;
    if (!(attribute(config, EGL_RENDERABLE_TYPE) & EGL_OPENGL_ES_BIT)) continue;
    std::vector<EGLint> key;
    for (EGLint name : {EGL_RED_SIZE, EGL_GREEN_SIZE, EGL_BLUE_SIZE, EGL_ALPHA_SIZE, EGL_DEPTH_SIZE,
                        EGL_STENCIL_SIZE, EGL_SAMPLES}) {
      key.push_back(attribute(config, name));
    }
    found.insert(key);
  }
  for (const auto& f : formats) {
    for (EGLint samples : {0, 4}) {
      EXPECT_TRUE(found.count({f[0], f[1], f[2], f[3], 0, 0, samples})) << f[0] << f[1] << f[2] << f[3];
      EXPECT_TRUE(found.count({f[0], f[1], f[2], f[3], 24, 8, samples})) << f[0] << f[1] << f[2] << f[3];
      const bool deep = found.count({f[0], f[1], f[2], f[3], 16, 0, samples}) ||
                        found.count({f[0], f[1], f[2], f[3], 24, 0, samples});
      EXPECT_TRUE(deep) << f[0] << f[1] << f[2] << f[3];
    }
  }
}

// Table 3.1: values that any config may have, and those that belong together.
TEST_F(Configs, Attributes) {
  std::set<EGLint> ids;
  for (EGLConfig config : all()) {
    const EGLint id = attribute(config, EGL_CONFIG_ID);
    SCOPED_TRACE(id);
    EXPECT_GT(id, 0);
    EXPECT_TRUE(ids.insert(id).second) << "the same id twice";
    EXPECT_EQ(attribute(config, EGL_COLOR_BUFFER_TYPE), EGL_RGB_BUFFER);
    EXPECT_EQ(attribute(config, EGL_LUMINANCE_SIZE), 0);
    EXPECT_EQ(attribute(config, EGL_BUFFER_SIZE),
              attribute(config, EGL_RED_SIZE) + attribute(config, EGL_GREEN_SIZE) +
                  attribute(config, EGL_BLUE_SIZE) + attribute(config, EGL_ALPHA_SIZE));
    EXPECT_EQ(attribute(config, EGL_SAMPLE_BUFFERS), attribute(config, EGL_SAMPLES) > 0 ? 1 : 0);
    EXPECT_EQ(attribute(config, EGL_LEVEL), 0);
    EXPECT_EQ(attribute(config, EGL_TRANSPARENT_TYPE), EGL_NONE);
    EXPECT_GE(attribute(config, EGL_MAX_SWAP_INTERVAL), attribute(config, EGL_MIN_SWAP_INTERVAL));
    // 3.4: a conformant config is conformant in what it renders.
    const EGLint renderable = attribute(config, EGL_RENDERABLE_TYPE),
                 conformant = attribute(config, EGL_CONFORMANT);
    EXPECT_EQ(conformant & ~renderable, 0);
    if (attribute(config, EGL_SURFACE_TYPE) & EGL_PBUFFER_BIT) {
      EXPECT_GE(attribute(config, EGL_MAX_PBUFFER_WIDTH), 1);
      EXPECT_GE(attribute(config, EGL_MAX_PBUFFER_HEIGHT), 1);
      // Mesa leaves it 0.
      EXPECT_GE(attribute(config, EGL_MAX_PBUFFER_PIXELS), onMesa() ? 0 : 1);
    }
    EGLint value = 77;
    EXPECT_FALSE(eglGetConfigAttrib(display_, config, EGL_WIDTH, &value));
    EXPECT_EGL_ERROR(EGL_BAD_ATTRIBUTE);
    EXPECT_EQ(value, 77);
    EXPECT_FALSE(eglGetConfigAttrib(display_, config, EGL_MATCH_NATIVE_PIXMAP, &value));
    EXPECT_EGL_ERROR(EGL_BAD_ATTRIBUTE);
  }
  EGLint value = 0;
  EXPECT_FALSE(eglGetConfigAttrib(display_, reinterpret_cast<EGLConfig>(&value), EGL_RED_SIZE, &value));
  EXPECT_EGL_ERROR(EGL_BAD_CONFIG);
}

// 3.4.1.1: each criterion; every config that matches is returned, and no other.
TEST_F(Configs, Selection) {
  const struct {
    EGLint name, value;
    bool (*accepts)(EGLint have, EGLint want);
  } rows[] = {
      {EGL_RED_SIZE, 5, [](EGLint have, EGLint want) { return have >= want; }},
      {EGL_ALPHA_SIZE, 1, [](EGLint have, EGLint want) { return have >= want; }},
      {EGL_BUFFER_SIZE, 24, [](EGLint have, EGLint want) { return have >= want; }},
      {EGL_DEPTH_SIZE, 16, [](EGLint have, EGLint want) { return have >= want; }},
      {EGL_STENCIL_SIZE, 8, [](EGLint have, EGLint want) { return have >= want; }},
      {EGL_SAMPLES, 4, [](EGLint have, EGLint want) { return have >= want; }},
      {EGL_SAMPLE_BUFFERS, 1, [](EGLint have, EGLint want) { return have >= want; }},
      {EGL_CONFIG_CAVEAT, EGL_NONE, [](EGLint have, EGLint want) { return have == want; }},
      {EGL_NATIVE_RENDERABLE, EGL_FALSE, [](EGLint have, EGLint want) { return have == want; }},
      {EGL_BIND_TO_TEXTURE_RGBA, EGL_TRUE, [](EGLint have, EGLint want) { return have == want; }},
      {EGL_BIND_TO_TEXTURE_RGB, EGL_FALSE, [](EGLint have, EGLint want) { return have == want; }},
      {EGL_CONFORMANT, EGL_OPENGL_ES_BIT, [](EGLint have, EGLint want) { return (have & want) == want; }},
      {EGL_RED_SIZE, EGL_DONT_CARE, [](EGLint, EGLint) { return true; }},
      {EGL_MAX_PBUFFER_WIDTH, 1 << 30, [](EGLint, EGLint) { return true; }},
  };
  for (const auto& row : rows) {
    std::set<EGLConfig> expected;
    for (EGLConfig config : all()) {
      if ((attribute(config, EGL_SURFACE_TYPE) & EGL_PBUFFER_BIT) &&
          (attribute(config, EGL_RENDERABLE_TYPE) & EGL_OPENGL_ES_BIT) && fixedPoint(config) &&
          row.accepts(attribute(config, row.name), row.value)) {
        expected.insert(config);
      }
    }
    const std::vector<EGLConfig> configs = matching(
        {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_ES_BIT, row.name, row.value});
    EXPECT_EQ(std::set<EGLConfig>(configs.begin(), configs.end()), expected) << std::hex << row.name;
  }
  EXPECT_TRUE(matching({EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RED_SIZE, 100}).empty());
  EXPECT_TRUE(matching({EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_LEVEL, 3}).empty());
}

// 3.4.1.1: CONFIG_ID overrides everything else.
TEST_F(Configs, SelectionById) {
  for (EGLConfig config : all()) {
    const std::vector<EGLConfig> found =
        matching({EGL_RED_SIZE, 100, EGL_CONFIG_ID, attribute(config, EGL_CONFIG_ID)});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0], config);
  }
  EXPECT_TRUE(matching({EGL_CONFIG_ID, 99999}).empty());
}

// 3.4.1: unknown attributes and values.
TEST_F(Configs, SelectionErrors) {
  EGLint count = 0;
  for (const std::vector<EGLint>& list : {std::vector<EGLint>{EGL_WIDTH, 1, EGL_NONE},
                                          {0x7777, 1, EGL_NONE},
                                          {EGL_RED_SIZE, -5, EGL_NONE},
                                          {EGL_LEVEL, EGL_DONT_CARE, EGL_NONE},
                                          {EGL_CONFIG_CAVEAT, 5, EGL_NONE},
                                          {EGL_COLOR_BUFFER_TYPE, 5, EGL_NONE},
                                          {EGL_NATIVE_RENDERABLE, 5, EGL_NONE}}) {
    EXPECT_FALSE(eglChooseConfig(display_, list.data(), nullptr, 0, &count)) << std::hex << list[0];
    EXPECT_EGL_ERROR(EGL_BAD_ATTRIBUTE) << std::hex << list[0];
  }
}

// 3.4.1.2: the order of the eleven rules, for several requests.
TEST_F(Configs, Sorting) {
  const std::vector<std::vector<EGLint>> requests = {{},
                                                     {EGL_RED_SIZE, 1, EGL_GREEN_SIZE, 1, EGL_BLUE_SIZE, 1},
                                                     {EGL_ALPHA_SIZE, 1},
                                                     {EGL_DEPTH_SIZE, 1, EGL_STENCIL_SIZE, 1},
                                                     {EGL_RED_SIZE, EGL_DONT_CARE, EGL_BLUE_SIZE, 4}};
  for (const std::vector<EGLint>& request : requests) {
    const auto wants = [&](EGLint name) {
      for (std::size_t i = 0; i < request.size(); i += 2) {
        if (request[i] == name) return request[i + 1] > 0;
      }
      return false;
    };
    const auto key = [&](EGLConfig config) {
      EGLint bits = 0;
      for (EGLint name : {EGL_RED_SIZE, EGL_GREEN_SIZE, EGL_BLUE_SIZE, EGL_ALPHA_SIZE}) {
        if (wants(name)) bits += attribute(config, name);
      }
      const EGLint caveat = attribute(config, EGL_CONFIG_CAVEAT);
      return std::vector<EGLint>{caveat == EGL_NONE          ? 0
                                 : caveat == EGL_SLOW_CONFIG ? 1
                                                             : 2,
                                 -bits,
                                 attribute(config, EGL_BUFFER_SIZE),
                                 attribute(config, EGL_SAMPLE_BUFFERS),
                                 attribute(config, EGL_SAMPLES),
                                 attribute(config, EGL_DEPTH_SIZE),
                                 attribute(config, EGL_STENCIL_SIZE),
                                 attribute(config, EGL_ALPHA_MASK_SIZE)};
    };
    std::vector<EGLint> full = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT};
    full.insert(full.end(), request.begin(), request.end());
    const std::vector<EGLConfig> configs = matching(full);
    ASSERT_GT(configs.size(), 1u);
    for (std::size_t i = 1; i < configs.size(); ++i) {
      const auto before = key(configs[i - 1]), after = key(configs[i]);
      EXPECT_LE(before, after) << "request of " << request.size() << ", place " << i;
      // Rule 10 orders native visual types as it likes; the id decides last.
      if (before == after && attribute(configs[i - 1], EGL_NATIVE_VISUAL_TYPE) ==
                                 attribute(configs[i], EGL_NATIVE_VISUAL_TYPE)) {
        EXPECT_LT(attribute(configs[i - 1], EGL_CONFIG_ID), attribute(configs[i], EGL_CONFIG_ID));
      }
    }
  }
}

}  // namespace
}  // namespace egl_conformance
