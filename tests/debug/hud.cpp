// ANTEROOM_HUD: its words, its numbers, and its picture, which disturbs nothing.
#include "layer/egl/hud.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "tests/debug/harness.h"

namespace anteroom::test {
namespace {

using egl::HudItem;
using std::chrono::milliseconds;

TEST(Hud, WordsInTheirOrder) {
  std::string said;
  const egl::HudOptions options = egl::parseHudOptions("draws,fps,draws,pbuffers", said);
  EXPECT_EQ(options.items, (std::vector{HudItem::Draws, HudItem::Fps}));
  EXPECT_TRUE(options.pbuffers);
  EXPECT_EQ(egl::parseHudOptions("1", said).items.size(), 5u);
  EXPECT_EQ(egl::parseHudOptions("all", said).items.size(), 10u);
  EXPECT_TRUE(egl::parseHudOptions("", said).items.empty());
  EXPECT_EQ(said, "");
  EXPECT_EQ(egl::parseHudOptions("fps,speed", said).items.size(), 1u);
  EXPECT_NE(said.find("does not know speed; it knows: fps, frame, draws, passes"), said.npos) << said;
  EXPECT_EQ(countOf(said, "\n"), 1u);
}

std::string lineOf(const egl::Hud& hud, size_t index) {
  const render::Hud::Line& line = hud.picture().text[index];
  std::string text;
  std::istringstream words(std::string(line.begin(), line.end()));
  for (std::string word; words >> word;) text += (text.empty() ? "" : " ") + word;
  return text;
}

TEST(Hud, NumbersAreMeansOfAnInterval) {
  std::string said;
  egl::Hud hud(egl::parseHudOptions("fps,frame,draws,uploads,memory,pipelines", said));
  const int context = 0;
  egl::Hud::Clock::time_point now{};
  render::Stats stats;
  stats.memoryBytes = 3 << 20;
  for (int i = 0; i <= 25; ++i) {
    stats.draws += 30;
    stats.bytesUploaded += 2048;
    stats.pipelinesCreated = 7;
    hud.frame(stats, &context, now);
    now += milliseconds(20);
  }
  EXPECT_EQ(lineOf(hud, 0), "fps 50.0");
  EXPECT_EQ(lineOf(hud, 1), "frame 20.0 ms");
  EXPECT_EQ(lineOf(hud, 2), "draws 30");
  EXPECT_EQ(lineOf(hud, 3), "uploads 2.0 KiB");
  EXPECT_EQ(lineOf(hud, 4), "memory 3.0 MiB");
  EXPECT_EQ(lineOf(hud, 5), "pipelines 7");
  // The graph: its top is at 2/60 s, the mark at half of it.
  EXPECT_EQ(hud.picture().graphLine, 1);
  EXPECT_FLOAT_EQ(hud.picture().graph.back(), 0.6f);
  EXPECT_FLOAT_EQ(hud.picture().graphMark, 0.5f);

  // A frame that hangs, and one that takes no time.
  hud.frame(stats, &context, now += std::chrono::hours(10000));
  EXPECT_LE(hud.picture().graph.back(), 1.0f);
  hud.frame(stats, &context, now);
  // Another context's numbers are its own.
  render::Stats other;
  other.draws = 4;
  const int second = 0;
  hud.frame(other, &second, now);
  EXPECT_EQ(lineOf(hud, 2), "draws 4");
}

struct Picture {
  int width = 0, height = 0;
  std::string pixels;
  // Mean of the components of a pixel; row 0 is the top.
  int at(int x, int y) const {
    const size_t i = static_cast<size_t>(y * width + x) * 3;
    const auto byte = [&](size_t j) { return static_cast<unsigned char>(pixels[j]); };
    return (byte(i) + byte(i + 1) + byte(i + 2)) / 3;
  }
};

struct Shown {
  Picture picture;
  std::string output;
};

Picture pictureOf(const std::string& file) {
  Picture picture;
  std::istringstream stream(contentsOf(file));
  std::string magic;
  int most = 0;
  stream >> magic >> picture.width >> picture.height >> most;
  stream.get();
  picture.pixels.assign(std::istreambuf_iterator<char>(stream), {});
  return picture;
}

Shown show(const char* hud, int width, int height, process::Environment more = {}) {
  const process::TemporaryDirectory folder;
  const std::string file = folder.path() + "/picture.ppm";
  more["ANTEROOM_HUD"] = hud;
  const Ended run = runProgram({"pictures", file, std::to_string(width), std::to_string(height), "3"}, more);
  EXPECT_EQ(run.status, 0) << run.output;
  Shown shown{pictureOf(file), run.output};
  EXPECT_EQ(shown.picture.pixels.size(), static_cast<size_t>(width) * static_cast<size_t>(height) * 3);
  return shown;
}

class HudOn : public testing::TestWithParam<const char*> {
 protected:
  process::Environment profile() const { return {{"ANTEROOM_MINIMAL", GetParam()}}; }
};

// A dark plate with light letters lies in the upper left corner, and nothing else has changed.
TEST_P(HudOn, LiesOverThePictureAndNowhereElse) {
  const Picture plain = show("", 320, 240, profile()).picture;
  const Picture with = show("pbuffers,draws,cache", 320, 240, profile()).picture;
  const int right = 4 + 153, bottom = 4 + 31;
  int dark = 0, light = 0;
  for (int y = 0; y < 240; ++y)
    for (int x = 0; x < 320; ++x) {
      const bool inside = x >= 4 && x < right && y >= 4 && y < bottom;
      if (!inside) {
        ASSERT_EQ(with.at(x, y), plain.at(x, y)) << x << ", " << y;
      }
      if (inside && with.at(x, y) < 64) ++dark;
      if (inside && with.at(x, y) > 140) ++light;
    }
  EXPECT_GT(dark, 153 * 31 * 8 / 10);
  // "draws" and "cache" at the left, "2" and "0" at the right.
  EXPECT_GT(light, 80);
  EXPECT_LT(light, 300);
}

// The same numbers for programs as without it: draws, pipelines, compiles, uploads.
TEST_P(HudOn, CountsAsNothing) {
  EXPECT_EQ(show("pbuffers,all", 320, 240, profile()).output, show("", 320, 240, profile()).output);
}

// Larger pictures have larger letters; those that are too small for it, what fits.
TEST_P(HudOn, FitsPicturesOfAnySize) {
  const Picture large = show("pbuffers,fps", 1280, 960, profile()).picture;
  EXPECT_LT(large.at(3 * 4 + 10, 3 * 4 + 10), 70);
  EXPECT_GT(large.at(3 * (4 + 153) + 4, 12), 70);
  for (int size : {1, 3, 5, 40}) show("pbuffers,all", size, size, profile());
}

INSTANTIATE_TEST_SUITE_P(Profiles, HudOn, testing::Values("0", "1"));

TEST(Hud, LeavesPbuffersAloneUnlessAsked) {
  EXPECT_EQ(show("all", 64, 64).picture.pixels, show("", 64, 64).picture.pixels);
}

class HudOnWindows : public testing::TestWithParam<const char*> {};

// It is on the screen, and not in the picture that the program goes on with; whose age no program should
// trust.
TEST_P(HudOnWindows, IsOnTheScreenAlone) {
  if (!std::getenv("DISPLAY")) GTEST_SKIP() << "there is no X server";
  const process::TemporaryDirectory folder;
  const auto screenAndPicture = [&](const char* hud, std::string& output) {
    const Ended run = runProgram(
        {"window", folder.path() + "/screen.ppm", folder.path() + "/picture.ppm", "320", "240", "3"},
        {{"ANTEROOM_HUD", hud}, {"ANTEROOM_MINIMAL", GetParam()}});
    EXPECT_EQ(run.status, 0) << run.output;
    output = run.output;
    return std::pair(pictureOf(folder.path() + "/screen.ppm"), pictureOf(folder.path() + "/picture.ppm"));
  };
  std::string plainOutput, output;
  const auto [plainScreen, plain] = screenAndPicture("", plainOutput);
  const auto [screen, picture] = screenAndPicture("draws,cache", output);
  ASSERT_EQ(plainScreen.pixels.size(), 320u * 240 * 3);
  EXPECT_EQ(plain.pixels, plainScreen.pixels);
  EXPECT_EQ(picture.pixels, plain.pixels);
  int changed = 0, outside = 0;
  for (int y = 0; y < 240; ++y)
    for (int x = 0; x < 320; ++x) {
      const bool inside = x >= 4 && x < 4 + 153 && y >= 4 && y < 4 + 31;
      (inside ? changed : outside) += screen.at(x, y) != plainScreen.at(x, y);
    }
  EXPECT_GT(changed, 153 * 31 * 9 / 10);
  EXPECT_EQ(outside, 0);
  EXPECT_EQ(output, "age 0\nerror 0x0\n");
  EXPECT_NE(plainOutput, output);
}

INSTANTIATE_TEST_SUITE_P(Profiles, HudOnWindows, testing::Values("0", "1"));

}  // namespace
}  // namespace anteroom::test
