// Point sprites against the same particles as quads that the program makes: sizes from the array, attenuation
// (section 3.3), sprite coordinates (OES_point_sprite), and that no particle is missing.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "particles/particles.h"
#include "room/context.h"
#include "room/picture.h"

namespace {

struct Size {
  int width;
  int height;
};
constexpr std::array kSizes = {Size{320, 240}, Size{640, 480}};

// The two may differ in how they place a sprite's edges and texture on the sub-pixel grid, 1/16 of a pixel
// where it is coarsest. The texture is black at its edges, so that a pixel won or lost there is nothing.
// Inside, a flame (23 levels of color, 20 pixels from black to black) changes by up to 23 / 10 / 16 = 0.15
// levels, and some 60 of them lie on each other: 0.15 / sqrt(3) * sqrt(60) = 0.7 at worst and with 8
// sub-pixel bits, as most have, a sixteenth of it, less than what rounding a flipped level adds. A bright
// spark of 4 pixels changes by 255 / 2 / 16 = 8 levels, in few places. Both err to either side alike.
constexpr double kRms = 0.7;
constexpr double kBias = 0.1;
constexpr int kLargest = 9;

std::unique_ptr<room::Demo> makeDemo(bool quads) {
  std::unique_ptr<room::Demo> demo = particles::makeParticles();
  demo->configure({.quads = quads});
  demo->setup();
  return demo;
}

room::Picture pictureOf(room::Demo& demo, const Size& size, double time) {
  demo.frame({size.width, size.height, time}, "fire");
  room::Picture picture = room::readPicture(size.width, size.height);
  room::checkErrors("the fire");
  return picture;
}

struct Difference {
  double rms;   // of 255, over the channels that any fire reaches
  double bias;  // mean of the second less the first, the same
  int largest;
  std::size_t burning;
};

Difference difference(const room::Picture& a, const room::Picture& b) {
  Difference d{};
  double squares = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    if (a.rgb[i] == 0 && b.rgb[i] == 0) continue;
    const int off = b.rgb[i] - a.rgb[i];
    squares += off * off;
    d.bias += off;
    d.largest = std::max(d.largest, std::abs(off));
    ++d.burning;
  }
  d.rms = std::sqrt(squares / static_cast<double>(d.burning));
  d.bias /= static_cast<double>(d.burning);
  return d;
}

TEST(ParticlesQuads, PointSpritesAreTheQuadsOfTheProgram) {
  const room::Context context(640, 480, 0);
  const std::unique_ptr<room::Demo> points = makeDemo(false);
  const std::unique_ptr<room::Demo> quads = makeDemo(true);
  for (const Size& size : kSizes) {
    for (double time : {0.4, 3.0}) {
      SCOPED_TRACE(testing::Message() << size.width << " x " << size.height << " at " << time << " s");
      const Difference d = difference(pictureOf(*points, size, time), pictureOf(*quads, size, time));
      ASSERT_GT(d.burning, 10000U) << "there is hardly any fire";
      EXPECT_LE(d.rms, kRms);
      EXPECT_LE(std::abs(d.bias), kBias);
      EXPECT_LE(d.largest, kLargest);
    }
  }
}

}  // namespace
