// Every demo, small, as the program draws it: there is a picture, and it is the float64 renderer's.
#include <OpenImageIO/imagebuf.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>

#include "tests/measure/process.h"

namespace {

// Root of the mean square of the channels' differences, over pixels whose neighbours are like them: on which
// side of an edge a pixel lies is a matter of rounding.
constexpr double kRms = 1.0;
// Of all channels: an edge that moves by one pixel is most of what there may be.
constexpr double kRmsWithEdges = 4.0;
constexpr int kAlike = 24;  // of 255, to the neighbours

struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;

  int at(int x, int y, int channel) const {
    return rgb[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
                   3 +
               static_cast<std::size_t>(channel)];
  }
};

// Thousands of sprites lie on each other in the fire, and eight bits round every one of them; a fifth of
// them, with as much light, round less than a step.
std::vector<std::string> optionsOf(const std::string& demo) {
  if (demo == "particles") return {"--particles", "1000"};
  return {};
}

Picture draw(const std::string& demo, const std::string& folder, const process::Environment& environment) {
  std::vector<std::string> arguments = {demo,        "--size", "64x48", "--time", "2",
                                        "--samples", "0",      "--out", folder};
  for (const std::string& option : optionsOf(demo)) arguments.push_back(option);
  const process::Outcome outcome = process::run(ROOMS_PROGRAM, arguments, environment);
  EXPECT_EQ(outcome.status, 0);
  OIIO::ImageBuf image(folder + "/" + demo + ".png");
  Picture picture;
  if (!image.read(0, 0, true, OIIO::TypeDesc::UINT8)) {
    ADD_FAILURE() << image.geterror();
    return picture;
  }
  picture.width = image.spec().width;
  picture.height = image.spec().height;
  const auto* pixels = static_cast<const std::uint8_t*>(image.localpixels());
  picture.rgb.assign(pixels, pixels + image.spec().image_pixels() * 3);
  return picture;
}

bool hasEdge(const Picture& picture, int x, int y) {
  for (int channel = 0; channel < 3; ++channel) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const int nx = std::clamp(x + dx, 0, picture.width - 1);
        const int ny = std::clamp(y + dy, 0, picture.height - 1);
        if (std::abs(picture.at(nx, ny, channel) - picture.at(x, y, channel)) > kAlike) return true;
      }
    }
  }
  return false;
}

struct Difference {
  double rms = 0;
  double rmsWithEdges = 0;
  int interior = 0;  // pixels without edges
};

Difference difference(const Picture& wanted, const Picture& got) {
  Difference d;
  for (int y = 0; y < wanted.height; ++y) {
    for (int x = 0; x < wanted.width; ++x) {
      double square = 0;
      for (int channel = 0; channel < 3; ++channel)
        square += std::pow(wanted.at(x, y, channel) - got.at(x, y, channel), 2) / 3;
      d.rmsWithEdges += square;
      if (hasEdge(wanted, x, y)) continue;
      d.rms += square;
      ++d.interior;
    }
  }
  d.rms = std::sqrt(d.rms / std::max(d.interior, 1));
  d.rmsWithEdges = std::sqrt(d.rmsWithEdges / (wanted.width * wanted.height));
  return d;
}

std::size_t colorsOf(const Picture& picture) {
  std::set<std::array<int, 3>> colors;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x)
      colors.insert({picture.at(x, y, 0), picture.at(x, y, 1), picture.at(x, y, 2)});
  }
  return colors.size();
}

class DemoPictures : public testing::TestWithParam<const char*> {};

TEST_P(DemoPictures, AreTheReferenceRenderers) {
  const process::TemporaryDirectory folder;
  const std::string ours = folder.path() + "/ours";
  const std::string reference = folder.path() + "/reference";
  const Picture got = draw(GetParam(), ours, {{"ANTEROOM_DEBUG", "validation=fatal"}});
  const Picture wanted = draw(GetParam(), reference, {{"ANTEROOM_RENDERER", "reference"}});
  ASSERT_EQ(wanted.width, 64);
  ASSERT_EQ(wanted.height, 48);
  ASSERT_EQ(got.rgb.size(), wanted.rgb.size());
  EXPECT_GT(colorsOf(got), 500U) << "there is hardly anything to see";
  const Difference d = difference(wanted, got);
  RecordProperty("rms", std::to_string(d.rms));
  std::printf("RMS %.3f over %d pixels, %.3f with edges\n", d.rms, d.interior, d.rmsWithEdges);
  EXPECT_GT(d.interior, 64 * 48 / 20) << "too few pixels are compared";
  EXPECT_LE(d.rms, kRms);
  EXPECT_LE(d.rmsWithEdges, kRmsWithEdges);
}

INSTANTIATE_TEST_SUITE_P(Each, DemoPictures,
                         testing::Values("lighting", "particles", "postprocessing", "reflect", "skinning",
                                         "water"),
                         [](const auto& one) { return std::string(one.param); });

}  // namespace
