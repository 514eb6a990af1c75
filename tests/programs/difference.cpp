// How far two pictures are apart, and whether that is little enough.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <exception>

#include "picture_file.h"

namespace {

struct Summary {
  int most = 0;         // of a channel, in 1/255
  double mean = 0;      // over channels and pixels, in 1/255
  double fraction = 0;  // of the pixels with a channel farther apart than told
};

Summary summarise(const windows::Image& a, const windows::Image& b, int by, windows::Image& map) {
  Summary summary;
  double sum = 0;
  std::size_t far = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    int most = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const int apart = std::abs(a.pixels[i][c] - b.pixels[i][c]);
      sum += apart;
      most = std::max(most, apart);
      map.pixels[i][c] = static_cast<std::uint8_t>(std::min(255, 8 * apart));
    }
    far += most > by;
    summary.most = std::max(summary.most, most);
  }
  const auto count = static_cast<double>(a.pixels.size());
  summary.mean = sum / (3 * count);
  summary.fraction = static_cast<double>(far) / count;
  return summary;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Compares two pictures; the exit status is 1 where they are farther apart than allowed.");
  std::string a, b, mapFile;
  int by = 0;
  double fraction = 0, mean = 0;
  app.add_option("A", a, "a picture")->required();
  app.add_option("B", b, "another of the same size")->required();
  app.add_option("--by", by, "how far apart a channel may be, 1/255");
  app.add_option("--fraction", fraction, "of the pixels that may be farther apart than that");
  app.add_option("--mean", mean, "how far apart all may be in the mean, 1/255");
  app.add_option("--map", mapFile, "a picture of the differences, eight times as strong");
  CLI11_PARSE(app, argc, argv);
  try {
    const windows::Image first = programs::readPicture(a);
    const windows::Image second = programs::readPicture(b);
    if (first.width != second.width || first.height != second.height) {
      fmt::print("{}x{} against {}x{} pixels\n", first.width, first.height, second.width, second.height);
      return 1;
    }
    windows::Image map(second.width, second.height);
    const Summary summary = summarise(first, second, by, map);
    if (!mapFile.empty()) programs::writePicture(mapFile, map);
    const bool near = summary.fraction <= fraction && (summary.mean <= mean || app.count("--mean") == 0);
    fmt::print("{}most {}/255, mean {:.3f}/255, {:.3f} % of the pixels more than {}/255 apart: {} {}\n",
               near ? "" : "TOO FAR: ", summary.most, summary.mean, 100 * summary.fraction, by, a, b);
    return near ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "programs_difference: {}\n", error.what());
    return 2;
  }
}
