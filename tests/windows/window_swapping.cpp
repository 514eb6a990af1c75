// EGL 1.5 section 3.10, EGL_EXT_buffer_age, EGL_KHR/EXT_swap_buffers_with_damage: what happens at the swap.
#include <chrono>
#include <deque>
#include <random>

#include "window_fixture.h"

namespace windows {
namespace {

constexpr int kWidth = 64, kHeight = 48;

class WindowSwapping : public WindowTest {
 protected:
  bool preserve(const Target& target, bool preserved) const {
    return eglSurfaceAttrib(display_, target.surface, EGL_SWAP_BEHAVIOR,
                            preserved ? EGL_BUFFER_PRESERVED : EGL_BUFFER_DESTROYED);
  }
  // With EGL_SWAP_BEHAVIOR_PRESERVED_BIT, or null.
  EGLConfig preservingConfig(std::vector<EGLint> more = {}) const {
    for (EGLConfig each : windowConfigs(std::move(more)))
      if (attribute(each, EGL_SURFACE_TYPE) & EGL_SWAP_BEHAVIOR_PRESERVED_BIT &&
          attribute(each, EGL_RED_SIZE) == 8 && attribute(each, EGL_ALPHA_SIZE) == 0)
        return each;
    return nullptr;
  }
  // The functions of both extensions, those that are there.
  std::vector<PFNEGLSWAPBUFFERSWITHDAMAGEKHRPROC> damageFunctions() const {
    std::vector<PFNEGLSWAPBUFFERSWITHDAMAGEKHRPROC> result;
    for (const std::string_view author : {"KHR", "EXT"}) {
      if (!has("EGL_" + std::string(author) + "_swap_buffers_with_damage")) continue;
      result.push_back(reinterpret_cast<PFNEGLSWAPBUFFERSWITHDAMAGEKHRPROC>(
          eglGetProcAddress(("eglSwapBuffersWithDamage" + std::string(author)).c_str())));
    }
    return result;
  }
};
ON_ALL_PLATFORMS(WindowSwapping);

Block randomBlock(std::mt19937& random) {
  static constexpr Rgb kColors[] = {{255, 0, 0},   {0, 255, 0},   {0, 0, 255},
                                    {255, 255, 0}, {255, 0, 255}, {0, 255, 255}};
  const int x = int(random() % (kWidth - 4)), y = int(random() % (kHeight - 4));
  return {x, y, 2 + int(random() % 30), 2 + int(random() % 20), kColors[random() % std::size(kColors)]};
}

TEST_P(WindowSwapping, Errors) {
  const EGLConfig config = windowConfig();
  const Target &target = open(config), &other = open(config, {.x = 100});
  EXPECT_FALSE(swap(target)) << "nothing is current";
  EXPECT_EGL_ERROR(EGL_BAD_SURFACE);
  ASSERT_TRUE(makeCurrent(target, context(config)));
  EXPECT_FALSE(swap(other)) << "not the current one";
  EXPECT_EGL_ERROR(EGL_BAD_SURFACE);
  EXPECT_FALSE(eglSwapBuffers(display_, EGL_NO_SURFACE));
  EXPECT_EGL_ERROR(EGL_BAD_SURFACE);
  EXPECT_FALSE(eglSwapBuffers(EGL_NO_DISPLAY, target.surface));
  EXPECT_EGL_ERROR(EGL_BAD_DISPLAY);
  ASSERT_TRUE(eglMakeCurrent(display_, target.surface, other.surface, eglGetCurrentContext()));
  EXPECT_FALSE(swap(other)) << "only to read from";
  EXPECT_EGL_ERROR(EGL_BAD_SURFACE);
  EXPECT_TRUE(swap(target));
}

TEST_P(WindowSwapping, IntervalErrors) {
  EXPECT_FALSE(eglSwapInterval(display_, 1));
  EXPECT_EGL_ERROR(EGL_BAD_CONTEXT);
  const EGLContext own = context(windowConfig());
  if (has("EGL_KHR_surfaceless_context")) {
    ASSERT_TRUE(eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, own));
    if (!egl_conformance::onMesa()) {  // 3.10.4: it takes the interval
      EXPECT_FALSE(eglSwapInterval(display_, 1));
      EXPECT_EGL_ERROR(EGL_BAD_SURFACE);
    }
  }
  const Target& target = open(windowConfig());
  ASSERT_TRUE(makeCurrent(target, own));
  EXPECT_FALSE(eglSwapInterval(EGL_NO_DISPLAY, 1));
  EXPECT_EGL_ERROR(EGL_BAD_DISPLAY);
}

// Values beyond the config's least and greatest are clamped in silence.
TEST_P(WindowSwapping, Intervals) {
  Target& target = openCurrent();
  for (EGLint interval : {0, 1, -5, 1000, 2, 0, 1}) {
    EXPECT_TRUE(eglSwapInterval(display_, interval)) << interval;
    if (interval > 1) continue;
    for (int frame = 0; frame < 4; ++frame) ASSERT_TRUE(drawsAndShows(target, frame)) << interval;
  }
}

// Interval 1 does not let frames out faster than a screen shows them by much, where the server has a clock at
// all; 0 does not wait.
TEST_P(WindowSwapping, IntervalZeroDoesNotWait) {
  Target& target = openCurrent();
  EXPECT_TRUE(eglSwapInterval(display_, 0));
  using Clock = std::chrono::steady_clock;
  double least = 1e9;
  for (int tries = 0; tries < 3; ++tries) {
    const Clock::time_point begin = Clock::now();
    for (int frame = 0; frame < 60; ++frame) {
      drawPicture(kWidth, kHeight, frame);
      ASSERT_TRUE(swap(target));
    }
    least = std::min(least, std::chrono::duration<double>(Clock::now() - begin).count());
  }
  EXPECT_LT(least, 0.8) << "60 frames at 60 Hz would be a second";
}

TEST_P(WindowSwapping, PreservedContents) {
  const EGLConfig config = preservingConfig();
  if (!config) GTEST_SKIP() << "no config preserves";
  Target& target = open(config);
  ASSERT_TRUE(makeCurrent(target, context(config)));
  ASSERT_TRUE(preserve(target, true));
  EXPECT_EQ(query(target, EGL_SWAP_BEHAVIOR), EGL_BUFFER_PRESERVED);
  drawPicture(kWidth, kHeight);
  Image expected = picture(kWidth, kHeight);
  std::mt19937 random(3);
  for (int frame = 0; frame < 10; ++frame) {
    ASSERT_TRUE(swap(target));
    ASSERT_TRUE(same(readPixels(0, 0, kWidth, kHeight), expected)) << frame;
    ASSERT_TRUE(shows(*target.native, expected)) << frame;
    const Block block = randomBlock(random);
    draw(block);
    paint(expected, block);
  }
  // And without anything drawn between two swaps.
  for (int frame = 0; frame < 4; ++frame) ASSERT_TRUE(swap(target));
  EXPECT_TRUE(same(readPixels(0, 0, kWidth, kHeight), expected));
  EXPECT_TRUE(shows(*target.native, expected));
}

// To and fro: the picture before the last swap is kept whenever the attribute says so at the swap.
TEST_P(WindowSwapping, PreservedNowAndThen) {
  const EGLConfig config = preservingConfig();
  if (!config) GTEST_SKIP() << "no config preserves";
  Target& target = open(config);
  ASSERT_TRUE(makeCurrent(target, context(config)));
  for (int frame = 0; frame < 8; ++frame) {
    ASSERT_TRUE(preserve(target, false));
    ASSERT_TRUE(drawsAndShows(target, frame));
    ASSERT_TRUE(preserve(target, true));
    drawPicture(kWidth, kHeight, frame + 1);
    ASSERT_TRUE(swap(target));
    Image expected = picture(kWidth, kHeight, frame + 1);
    ASSERT_TRUE(same(readPixels(0, 0, kWidth, kHeight), expected)) << frame;
    const Block block{3, 5, 40, 9, {255, 0, 255}};
    draw(block);
    paint(expected, block);
    ASSERT_TRUE(swap(target));
    ASSERT_TRUE(same(readPixels(0, 0, kWidth, kHeight), expected)) << frame;
    ASSERT_TRUE(shows(*target.native, expected)) << frame;
    // Changed between drawing and swapping.
    ASSERT_TRUE(preserve(target, frame % 2 == 0));
    draw({10, 1, 3, 3, {0, 0, 0}});
    paint(expected, {10, 1, 3, 3, {0, 0, 0}});
    ASSERT_TRUE(swap(target));
    ASSERT_TRUE(shows(*target.native, expected)) << frame;
  }
}

TEST_P(WindowSwapping, PreservedSamples) {
  const EGLConfig config = preservingConfig({EGL_SAMPLES, 4, EGL_DEPTH_SIZE, 16});
  if (!config) GTEST_SKIP() << "no config with samples preserves";
  Target& target = open(config);
  ASSERT_TRUE(makeCurrent(target, context(config)));
  ASSERT_TRUE(preserve(target, true));
  drawPicture(kWidth, kHeight);
  Image expected = picture(kWidth, kHeight);
  std::mt19937 random(4);
  for (int frame = 0; frame < 6; ++frame) {
    ASSERT_TRUE(swap(target));
    ASSERT_TRUE(shows(*target.native, expected)) << frame;
    const Block block = randomBlock(random);
    draw(block);
    paint(expected, block);
    ASSERT_TRUE(same(readPixels(0, 0, kWidth, kHeight), expected)) << frame;
  }
}

// A resize loses the contents; what is drawn after it is preserved again.
TEST_P(WindowSwapping, PreservedAcrossResizes) {
  const EGLConfig config = preservingConfig();
  if (!config) GTEST_SKIP() << "no config preserves";
  Target& target = open(config);
  ASSERT_TRUE(makeCurrent(target, context(config)));
  ASSERT_TRUE(preserve(target, true));
  ASSERT_TRUE(drawsAndShows(target));
  for (const auto& [width, height] : {std::pair{100, 80}, {30, 90}, {64, 48}}) {
    target.native->resize(width, height);
    for (int tries = 0; tries < 5; ++tries) ASSERT_TRUE(swap(target));
    ASSERT_EQ(query(target, EGL_WIDTH), width);
    ASSERT_EQ(query(target, EGL_HEIGHT), height);
    Image expected = picture(width, height, 1);
    drawPicture(width, height, 1);
    for (int frame = 0; frame < 3; ++frame) {
      ASSERT_TRUE(swap(target));
      ASSERT_TRUE(same(readPixels(0, 0, width, height), expected));
      const Block block{frame * 5, frame * 6, 7, 8, {0, 0, 0}};
      draw(block);
      paint(expected, block);
    }
    ASSERT_TRUE(swap(target));
    EXPECT_TRUE(shows(*target.native, expected));
  }
}

TEST_P(WindowSwapping, BufferAge) {
  Target& target = openCurrent();
  if (!has("EGL_EXT_buffer_age")) GTEST_SKIP() << "no EGL_EXT_buffer_age";
  EXPECT_EQ(query(target, EGL_BUFFER_AGE_EXT), 0) << "nothing was ever drawn";
  bool any = false;
  std::vector<int> frames;
  for (int frame = 0; frame < 12; ++frame) {
    const EGLint age = query(target, EGL_BUFFER_AGE_EXT);
    ASSERT_GE(age, 0);
    ASSERT_LE(age, frame) << "older than the surface";
    // What is in the buffer is the frame that old.
    if (age > 0) {
      any = true;
      ASSERT_TRUE(same(readPixels(0, 0, kWidth, kHeight), picture(kWidth, kHeight, frame - age))) << frame;
    }
    EXPECT_EQ(query(target, EGL_BUFFER_AGE_EXT), age) << "it stays until the swap";
    ASSERT_TRUE(drawsAndShows(target, frame));
  }
  EXPECT_TRUE(any) << "no buffer is ever used again";
}

TEST_P(WindowSwapping, BufferAgeErrors) {
  const EGLConfig config = windowConfig();
  const Target &target = open(config), &other = open(config, {.x = 100});
  if (!has("EGL_EXT_buffer_age")) GTEST_SKIP() << "no EGL_EXT_buffer_age";
  EGLint age = 77;
  EXPECT_FALSE(eglQuerySurface(display_, target.surface, EGL_BUFFER_AGE_EXT, &age));
  EXPECT_EGL_ERROR(EGL_BAD_SURFACE);
  ASSERT_TRUE(eglMakeCurrent(display_, other.surface, target.surface, context(config)));
  EXPECT_FALSE(eglQuerySurface(display_, target.surface, EGL_BUFFER_AGE_EXT, &age));
  EXPECT_EGL_ERROR(EGL_BAD_SURFACE);
  EXPECT_EQ(age, 77);
}

// What the extension is for: of a picture that changes only here and there, only that is drawn which the
// buffer lacks.
TEST_P(WindowSwapping, PartialRedraws) {
  Target& target = openCurrent();
  if (!has("EGL_EXT_buffer_age")) GTEST_SKIP() << "no EGL_EXT_buffer_age";
  EXPECT_TRUE(eglSwapInterval(display_, 0));
  std::mt19937 random(5);
  std::vector<Block> all = quarters(kWidth, kHeight);
  const std::size_t base = all.size();
  Image expected = picture(kWidth, kHeight);
  for (std::size_t frame = 0; frame < 20; ++frame) {
    const std::size_t age = std::size_t(query(target, EGL_BUFFER_AGE_EXT));
    // Frame n has base + n blocks.
    const std::size_t there = age == 0 || age > frame ? 0 : base + frame - age;
    ASSERT_LE(age, frame);
    if (frame > 0) {
      all.push_back(randomBlock(random));
      paint(expected, all.back());
    }
    for (std::size_t i = there; i < all.size(); ++i) draw(all[i]);
    ASSERT_TRUE(same(readPixels(0, 0, kWidth, kHeight), expected)) << frame << " age " << age;
    ASSERT_TRUE(swap(target));
    ASSERT_TRUE(shows(*target.native, expected)) << frame << " age " << age;
  }
}

TEST_P(WindowSwapping, PreservedBuffersAreOneFrameOld) {
  const EGLConfig config = preservingConfig();
  if (!config || !has("EGL_EXT_buffer_age")) GTEST_SKIP() << "no ages, or no config preserves";
  Target& target = open(config);
  ASSERT_TRUE(makeCurrent(target, context(config)));
  ASSERT_TRUE(preserve(target, true));
  for (int frame = 0; frame < 4; ++frame) {
    ASSERT_TRUE(drawsAndShows(target, frame));
    EXPECT_EQ(query(target, EGL_BUFFER_AGE_EXT), 1) << frame;
  }
}

// After a resize a buffer is new, or its age is true.
TEST_P(WindowSwapping, AgesAfterResizes) {
  Target& target = openCurrent();
  if (!has("EGL_EXT_buffer_age")) GTEST_SKIP() << "no EGL_EXT_buffer_age";
  for (int frame = 0; frame < 4; ++frame) ASSERT_TRUE(drawsAndShows(target, frame));
  target.native->resize(90, 70);
  std::vector<Image> shown;
  for (int frame = 0; frame < 10; ++frame) {
    const EGLint age = query(target, EGL_BUFFER_AGE_EXT);
    const int width = query(target, EGL_WIDTH), height = query(target, EGL_HEIGHT);
    const Image& old = age > 0 && age <= frame ? shown[std::size_t(frame - age)] : Image();
    if (old.width == width && old.height == height) {
      ASSERT_TRUE(same(readPixels(0, 0, width, height), old)) << frame;
    }
    drawPicture(width, height, frame);
    shown.push_back(picture(width, height, frame));
    ASSERT_TRUE(swap(target));
  }
  EXPECT_EQ(query(target, EGL_WIDTH), 90);
}

TEST_P(WindowSwapping, DamageErrors) {
  const EGLConfig config = windowConfig();
  Target& target = open(config);
  const auto functions = damageFunctions();
  if (functions.empty()) GTEST_SKIP() << "no swap_buffers_with_damage";
  const EGLint rect[] = {0, 0, 4, 4};
  const EGLContext own = context(config);
  for (const auto swapWithDamage : functions) {
    ASSERT_TRUE(swapWithDamage);
    EXPECT_FALSE(swapWithDamage(display_, target.surface, rect, 1)) << "nothing is current";
    EXPECT_EGL_ERROR(EGL_BAD_SURFACE);
    EXPECT_FALSE(swapWithDamage(EGL_NO_DISPLAY, target.surface, rect, 1));
    EXPECT_EGL_ERROR(EGL_BAD_DISPLAY);
    ASSERT_TRUE(makeCurrent(target, own));
    EXPECT_FALSE(swapWithDamage(display_, target.surface, rect, -1));
    EXPECT_EGL_ERROR(EGL_BAD_PARAMETER);
    EXPECT_FALSE(swapWithDamage(display_, target.surface, nullptr, 1));
    EXPECT_EGL_ERROR(EGL_BAD_PARAMETER);
    EXPECT_FALSE(swapWithDamage(display_, EGL_NO_SURFACE, rect, 1));
    EXPECT_EGL_ERROR(EGL_BAD_SURFACE);
    EXPECT_TRUE(swapWithDamage(display_, target.surface, nullptr, 0));
    EXPECT_TRUE(swapWithDamage(display_, target.surface, rect, 0));
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
}

// Rectangles count from the lower left. What has changed shows, whatever else is said to have changed.
TEST_P(WindowSwapping, Damage) {
  Target& target = openCurrent();
  const auto functions = damageFunctions();
  if (functions.empty()) GTEST_SKIP() << "no swap_buffers_with_damage";
  for (const auto swapWithDamage : functions) {
    Image expected = picture(kWidth, kHeight);
    // All buffers hold the picture, so that only the damage differs.
    for (int frame = 0; frame < 5; ++frame) ASSERT_TRUE(drawsAndShows(target));
    std::mt19937 random(6);
    for (int frame = 0; frame < 12; ++frame) {
      const Block block = randomBlock(random);
      drawPicture(kWidth, kHeight);
      draw(block);
      Image next = picture(kWidth, kHeight);
      paint(next, block);
      // Where the last frame had its block, and where this one has.
      static Block last{0, 0, kWidth, kHeight, {}};
      const EGLint rects[] = {last.x,      last.y,       last.width,  last.height, block.x, block.y,
                              block.width, block.height, block.x - 1, block.y,     3,       1};
      ASSERT_TRUE(swapWithDamage(display_, target.surface, rects, 3));
      ASSERT_TRUE(shows(*target.native, next)) << frame;
      last = block;
    }
    ASSERT_TRUE(drawsAndShows(target, 1));
  }
}

// Nothing that a program may say about rectangles is harmful.
TEST_P(WindowSwapping, OddDamage) {
  Target& target = openCurrent();
  const auto functions = damageFunctions();
  if (functions.empty()) GTEST_SKIP() << "no swap_buffers_with_damage";
  constexpr EGLint kMost = 0x7fffffff, kLeast = -kMost - 1;
  std::vector<std::vector<EGLint>> lists = {{-10, -10, 500, 500},
                                            {0, 0, 0, 0},
                                            {10, 10, 0, 5},
                                            {10, 10, -5, -5},
                                            {kMost, kMost, kMost, kMost},
                                            {kLeast, kLeast, kMost, kMost},
                                            {1, 1, kMost, kMost},
                                            {0, 0, 64, 48, 0, 0, 64, 48}};
  lists.emplace_back();
  for (int i = 0; i < 200; ++i) lists.back().insert(lists.back().end(), {i % 64, i % 48, 5, 5});
  for (const auto swapWithDamage : functions) {
    for (const std::vector<EGLint>& list : lists) {
      drawPicture(kWidth, kHeight);
      ASSERT_TRUE(swapWithDamage(display_, target.surface, list.data(), EGLint(list.size() / 4)));
    }
    ASSERT_TRUE(drawsAndShows(target, 2));
  }
}

// Windows that nobody sees keep running. On Wayland a program with interval 1 may have to wait until it is
// seen.
TEST_P(WindowSwapping, Hidden) {
  Target& target = openCurrent();
  ASSERT_TRUE(drawsAndShows(target));
  EXPECT_TRUE(eglSwapInterval(display_, onWayland() ? 0 : 1));
  for (int times = 0; times < 3; ++times) {
    target.native->hide();
    for (int frame = 0; frame < 12; ++frame) {
      drawPicture(kWidth, kHeight, frame);
      ASSERT_TRUE(same(readPixels(0, 0, kWidth, kHeight), picture(kWidth, kHeight, frame)));
      ASSERT_TRUE(swap(target));
    }
    target.native->show();
    ASSERT_TRUE(drawsAndShows(target, times));
  }
}

TEST_P(WindowSwapping, ShownLate) {
  const EGLConfig config = windowConfig();
  Target& target = open(config, {.shown = false});
  ASSERT_TRUE(makeCurrent(target, context(config)));
  EXPECT_TRUE(eglSwapInterval(display_, 0));
  for (int frame = 0; frame < 5; ++frame) {
    drawPicture(kWidth, kHeight, frame);
    ASSERT_TRUE(swap(target));
  }
  target.native->show();
  EXPECT_TRUE(drawsAndShows(target, 3));
}

TEST_P(WindowSwapping, SingleBuffer) {
  const EGLConfig config = windowConfig();
  Target& target = open(config, {}, {EGL_RENDER_BUFFER, EGL_SINGLE_BUFFER});
  ASSERT_TRUE(makeCurrent(target, context(config)));
  for (int frame = 0; frame < 3; ++frame) {
    drawPicture(kWidth, kHeight, frame);
    glFlush();
    ASSERT_TRUE(swap(target));
    EXPECT_TRUE(shows(*target.native, picture(kWidth, kHeight, frame)));
  }
}

}  // namespace
}  // namespace windows
