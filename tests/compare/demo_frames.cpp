// Frames of the demos on all implementations. No case is made of them: they show what adds up in a whole
// picture.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "comparison.h"

namespace comparison {

namespace {

constexpr double kRmsBound = 1;  // 1/255
// A pixel is an edge pixel when one of its neighbours differs by more in the reference.
constexpr int kEdgeContrast = 32;

struct Frame {
  const char* demo;
  int seconds, width, height;
  bool layers;  // hundreds of blended layers in one draw, each of which the framebuffer rounds
  std::string name() const { return fmt::format("demo/{} {}s {}x{}", demo, seconds, width, height); }
};

std::vector<Frame> frames() {
  std::vector<Frame> result;
  for (const char* demo : {"lighting", "particles", "postprocessing", "skinning", "water"}) {
    const bool layers = std::string_view(demo) == "particles";
    for (int seconds : {0, 3, 7})
      for (const auto& [width, height] : {std::pair{96, 72}, {256, 256}})
        result.push_back({demo, seconds, width, height, layers});
  }
  return result;
}

Result render(const Frame& frame, const process::Environment& environment, const std::string& directory) {
  const auto start = std::chrono::steady_clock::now();
  const process::Outcome outcome =
      process::run(process::executableDirectory() + "/rooms",
                   {frame.demo, "--samples", "0", "--size", fmt::format("{}x{}", frame.width, frame.height),
                    "--time", std::to_string(frame.seconds), "--out", directory},
                   measure::withoutCaches(environment));
  const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
  Result result;
  result.milliseconds.push_back(elapsed.count());
  if (outcome.status != 0)
    result.fault = fmt::format("ended with status {}", outcome.status);
  else
    result.picture = measure::readPng(fmt::format("{}/{}.png", directory, frame.demo));
  return result;
}

bool nextToEdge(const Picture& picture, int x, int y) {
  const auto at = [&](int px, int py) { return 4 * static_cast<std::size_t>(py * picture.width + px); };
  for (int ny = std::max(0, y - 1); ny <= std::min(picture.height - 1, y + 1); ++ny)
    for (int nx = std::max(0, x - 1); nx <= std::min(picture.width - 1, x + 1); ++nx)
      for (std::size_t c = 0; c < 3; ++c)
        if (std::abs(int{picture.rgba[at(x, y) + c]} - int{picture.rgba[at(nx, ny) + c]}) > kEdgeContrast)
          return true;
  return false;
}

Difference differenceAwayFromEdges(const Picture& reference, const Picture& actual) {
  Difference result;
  if (actual.rgba.empty() || actual.width != reference.width || actual.height != reference.height)
    return result;
  result.present = true;
  double squares = 0;
  int interior = 0;
  for (int y = 0; y < reference.height; ++y) {
    for (int x = 0; x < reference.width; ++x) {
      const auto at = 4 * static_cast<std::size_t>(y * reference.width + x);
      int worst = 0, sum = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        const int error = std::abs(int{actual.rgba[at + c]} - int{reference.rgba[at + c]});
        worst = std::max(worst, error);
        sum += error * error;
      }
      if (nextToEdge(reference, x, y)) {
        ++result.edgePixels;
        result.coverage += worst > 1;
        continue;
      }
      ++interior;
      squares += sum;
      if (worst <= result.worst) continue;
      result.worst = worst;
      result.x = x;
      result.y = y;
    }
  }
  if (interior > 0) result.rms = std::sqrt(squares / (3.0 * interior));
  return result;
}

void judge(Row& row) {
  const Result& ours = row.results["ours"];
  if (!ours.difference.present)
    row.failures.push_back("no picture: " + ours.fault);
  else if (ours.difference.rms > kRmsBound)
    row.failures.push_back(fmt::format(
        "away from edges the error is {:.3f}/255 RMS, bound {}; the worst is {} at ({}, {})",
        ours.difference.rms, kRmsBound, ours.difference.worst, ours.difference.x, ours.difference.y));
}

}  // namespace

std::vector<std::string> demoNames() {
  std::vector<std::string> names;
  for (const Frame& frame : frames()) names.push_back(frame.name());
  return names;
}

std::vector<Row> compareDemos(const Plan& plan) {
  std::vector<Row> rows;
  for (const Frame& frame : frames()) {
    if (!plan.filter.matches(frame.name())) continue;
    const process::TemporaryDirectory directory;
    Row row;
    row.name = frame.name();
    row.section = "demos";
    row.boundReason = "RMS away from edges";
    process::Environment referenceEnvironment = plan.reference;
    if (frame.layers) referenceEnvironment["ANTEROOM_REFERENCE_BLENDING"] = "steps";
    Result& reference = row.results["reference"] = render(frame, referenceEnvironment, directory.path());
    for (const measure::Implementation& implementation : plan.implementations) {
      Result& result = row.results[implementation.name] =
          render(frame, implementation.environment, directory.path());
      result.difference = differenceAwayFromEdges(reference.picture, result.picture);
    }
    if (reference.picture.rgba.empty())
      row.failures.push_back("no picture of the reference: " + reference.fault);
    judge(row);
    writePictures(plan, row, reference.picture);
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace comparison
