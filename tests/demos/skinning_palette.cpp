// The hand by the matrix palette (OES_matrix_palette) against the same hand moved by the program, and what
// its mesh and its act must be.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "room/context.h"
#include "room/picture.h"
#include "skinning/set/hand.h"
#include "skinning/skinning.h"

namespace {

constexpr int kWidth = 480, kHeight = 360;

// The program adds up in float64 what the palette adds up in float32: 2^-24 of a metre or so, far below the
// sub-pixel grid. Only a pixel whose centre an edge meets within that may go to the other side, and a vertex
// color a step; the wall's shadow is 3.5 times as large.
constexpr double kRms = 0.25;
constexpr double kFarPixels = 0.0005;  // share of the pixels that are off by more than 3 steps

std::unique_ptr<room::Demo> makeDemo(const std::string& skin) {
  std::unique_ptr<room::Demo> demo = skinning::makeSkinning();
  room::Settings settings;
  settings.skin = skin;
  demo->configure(settings);
  demo->setup();
  return demo;
}

room::Picture pictureOf(room::Demo& demo, double time, std::string_view stage) {
  demo.frame({kWidth, kHeight, time}, stage);
  room::Picture picture = room::readPicture(kWidth, kHeight);
  room::checkErrors("the hand");
  return picture;
}

TEST(SkinningPalette, IsTheSkinOfTheProgram) {
  const room::Context context(kWidth, kHeight, 0);
  const std::unique_ptr<room::Demo> palette = makeDemo("palette");
  const std::unique_ptr<room::Demo> program = makeDemo("cpu");
  for (double time : {0.9, 7.0, 9.2, 11.6}) {
    for (std::string_view stage : {"bones", "diffuse", "specular", "shadows", "final"}) {
      SCOPED_TRACE(testing::Message() << stage << " at " << time << " s");
      const room::Picture a = pictureOf(*palette, time, stage), b = pictureOf(*program, time, stage);
      double squares = 0, bright = 0;
      std::size_t far = 0;
      for (std::size_t i = 0; i < a.rgb.size(); ++i) {
        const int off = a.rgb[i] - b.rgb[i];
        squares += off * off;
        far += std::abs(off) > 3;
        bright += a.rgb[i] > 40;
      }
      const auto count = static_cast<double>(a.rgb.size());
      ASSERT_GT(bright / count, 0.001) << "there is no hand";
      EXPECT_LE(std::sqrt(squares / count), kRms);
      EXPECT_LE(static_cast<double>(far) / count, kFarPixels);
    }
  }
}

// It moves, and ends where it began.
TEST(SkinningPalette, TheActGoesOn) {
  const room::Context context(kWidth, kHeight, 0);
  const std::unique_ptr<room::Demo> demo = makeDemo("any");
  const room::Picture first = pictureOf(*demo, 0.9, "bones");
  EXPECT_EQ(first.rgb, pictureOf(*demo, 0.9, "bones").rgb);
  for (double time : {1.7, 7.0, 9.2, 11.6}) {
    const room::Picture later = pictureOf(*demo, time, "bones");
    const std::size_t moved = static_cast<std::size_t>(std::ranges::count_if(
        later.rgb, [&, i = std::size_t{0}](std::uint8_t value) mutable { return value != first.rgb[i++]; }));
    EXPECT_GT(moved, first.rgb.size() / 100) << time;
  }
}

TEST(SkinningPalette, TheHandHasItsBonesAndVertices) {
  const skinning::HandMesh hand = skinning::makeHand();
  ASSERT_EQ(hand.vertices.size(), 5766U);
  std::set<int> bones;
  for (const skinning::SkinVertex& v : hand.vertices) {
    float sum = 0;
    for (std::size_t k = 0; k < v.weights.size(); ++k) {
      ASSERT_LT(v.bones[k], skinning::kBones);
      ASSERT_GE(v.weights[k], 0);
      if (v.weights[k] > 0.5F) bones.insert(v.bones[k]);
      sum += v.weights[k];
    }
    ASSERT_NEAR(sum, 1, 1e-6);
    ASSERT_NEAR(glm::length(v.normal), 1, 1e-5);
    ASSERT_TRUE(v.uv.x >= 0 && v.uv.x <= 1 && v.uv.y >= 0 && v.uv.y <= 1);
  }
  EXPECT_EQ(bones.size(), 20U) << "every bone leads some of the skin";
  for (std::uint16_t index : hand.indices) ASSERT_LT(index, hand.vertices.size());
}

TEST(SkinningPalette, BonesTurnAndMoveOnly) {
  for (double time = 0; time < skinning::kActLength; time += 0.37) {
    for (const glm::dmat4& bone : skinning::boneMatrices(time)) {
      const glm::dmat3 turn(bone), product = glm::transpose(turn) * turn;
      for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) ASSERT_NEAR(product[c][r], c == r, 1e-12);
      ASSERT_GT(glm::determinant(turn), 0);
    }
  }
}

}  // namespace
