#include "comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <sstream>

#include "tests/measure/picture.h"
#include "worker.h"

namespace comparison {

namespace {

constexpr const char* kSelf = "/proc/self/exe";

// Renders on one implementation; a crash costs its scene alone, and a new process goes on behind it.
std::map<std::string, Result> renderScenes(const process::Environment& environment, const WorkerTask& task) {
  std::map<std::string, Result> results;
  std::vector<std::string> left = task.scenes;
  while (!left.empty()) {
    std::vector<std::string> arguments = {"--worker",    task.directory,
                                          "--repeats",   std::to_string(task.repeats),
                                          "--lod-error", std::to_string(task.lodError)};
    if (task.varied) arguments.emplace_back("--varied");
    for (const std::string& name : left) arguments.insert(arguments.end(), {"--scene", name});
    const process::Outcome outcome = process::run(kSelf, arguments, measure::withoutCaches(environment));
    std::istringstream lines(outcome.output);
    std::string begun;
    for (std::string line; std::getline(lines, line);) {
      const std::size_t tab = line.find('\t'), second = line.find('\t', tab + 1);
      if (tab == std::string::npos) continue;
      const std::string word = line.substr(0, tab), name = line.substr(tab + 1, second - tab - 1);
      begun = word == "begin" ? name : "";
      if (word == "begin") continue;
      Result& result = results[name];
      if (word == "skip") result.fault = line.substr(second + 1);
      if (word == "done") {
        result.milliseconds.push_back(std::stod(line.substr(second + 1)));
        result.picture = measure::readRaw(pictureFile(task.directory, name, 0));
      }
      left.erase(std::remove(left.begin(), left.end(), name), left.end());
    }
    if (left.empty()) break;
    if (begun.empty()) begun = left.front();
    results[begun].fault = fmt::format("ended with status {}", outcome.status);
    left.erase(std::remove(left.begin(), left.end(), begun), left.end());
  }
  return results;
}

// The measurement of anteroom-driver that bounds a scene.
const char* measurementOf(Driver driver) {
  switch (driver) {
    case Driver::kFilter:
      return "filter-weights";
    case Driver::kBlend:
      return "blending";
    case Driver::kLine:
      return "line-parameter";
    case Driver::kSmoothLine:
      return "smooth-line-coverage";
    default:
      return "";
  }
}

DriverErrors measureDriver() {
  const process::Outcome outcome = process::run(process::executableDirectory() + "/anteroom-driver", {}, {});
  if (outcome.status != 0) throw std::runtime_error("anteroom-driver failed");
  DriverErrors errors;
  std::istringstream lines(outcome.output);
  std::string name;
  double error = 0;
  while (lines >> name >> error) errors[name] = error;
  return errors;
}

// 1/255, and 2/255 after three or more roundings; or the driver's own error where that is more.
void setBound(Row& row, const Scene& scene, const DriverErrors& driverErrors) {
  row.bound = scene.blendedPasses >= 3 ? 2 : 1;
  if (scene.surface.rgb565) {
    row.bound = 9;
    row.boundReason = "one step of five bits";
  }
  const auto measured = driverErrors.find(measurementOf(scene.driver));
  if (measured == driverErrors.end()) return;
  // From the exact color to the driver's, and half a step to the reference's rounded one.
  const int steps = static_cast<int>(std::floor(measured->second * 255 + 0.5));
  if (steps <= row.bound) return;
  row.bound = steps;
  row.boundReason = measured->first;
}

void judge(Row& row, const Expectation& expected) {
  for (auto& [name, result] : row.results) result.difference = difference(expected, result.picture);
  const Result& ours = row.results["ours"];
  if (!ours.difference.present) {
    row.failures.push_back("no picture: " + ours.fault);
    return;
  }
  if (ours.difference.worst > row.bound) {
    row.failures.push_back(fmt::format("an interior pixel at ({}, {}) is off by {}/255, bound {}",
                                       ours.difference.x, ours.difference.y, ours.difference.worst,
                                       row.bound));
  }
  if (ours.difference.worstOutside > row.bound) {
    row.failures.push_back(fmt::format("an edge pixel is {}/255 from all that its edge may make of it",
                                       ours.difference.worstOutside));
  }
  const auto mesa = row.results.find("mesa");
  if (mesa != row.results.end() && mesa->second.difference.present)
    row.disagreements = disagreements(expected, ours.picture, mesa->second.picture, row.bound);
}

}  // namespace

void writePictures(const Plan& plan, const Row& row, const Picture& reference) {
  if (plan.out.empty()) return;
  std::vector<Picture> pictures = {reference};
  for (const measure::Implementation& implementation : plan.implementations) {
    const auto result = row.results.find(implementation.name);
    pictures.push_back(result != row.results.end() ? result->second.picture : Picture{});
  }
  if (!reference.rgba.empty())
    measure::writeSideBySide(plan.out + "/" + measure::fileName(row.name) + ".png", pictures);
}

namespace {

// Some scenes on all implementations.
class Drawn {
 public:
  Drawn(const Plan& plan, std::vector<const Scene*> scenes, double lodError)
      : plan_(plan), scenes_(std::move(scenes)), lodError_(lodError) {
    for (const Scene* scene : scenes_) names_.push_back(scene->name);
    reference_ = render("reference", plan.reference, true, 1);
    for (int round = 0; round < plan.rounds; ++round) {
      measure::takeTurns(std::size_t(round), plan.implementations.size(), [&](std::size_t i) {
        const auto& [name, environment] = plan.implementations[i];
        for (auto& [scene, result] : render(name, environment, false, plan.repeats))
          add(others_[name][scene], std::move(result));
      });
    }
  }

  std::vector<Row> rows(const DriverErrors& driverErrors) {
    std::vector<Row> result;
    for (const Scene* scene : scenes_) result.push_back(makeRow(*scene, driverErrors));
    return result;
  }

 private:
  // The picture is the last round's, a fault any round's.
  static void add(Result& sum, Result round) {
    sum.milliseconds.insert(sum.milliseconds.end(), round.milliseconds.begin(), round.milliseconds.end());
    sum.picture = std::move(round.picture);
    if (sum.fault.empty()) sum.fault = std::move(round.fault);
  }

  std::map<std::string, Result> render(const std::string& name, const process::Environment& environment,
                                       bool varied, int repeats) const {
    const std::string directory = temporary_.path() + "/" + name;
    std::filesystem::create_directories(directory);
    return renderScenes(environment, {directory, names_, varied, lodError_, repeats});
  }

  Row makeRow(const Scene& scene, const DriverErrors& driverErrors) {
    Row row;
    row.name = scene.name;
    row.section = scene.section;
    row.mesaDiffers = scene.mesaDiffers;
    row.deviates = scene.deviates;
    row.extreme = scene.extreme;
    setBound(row, scene, driverErrors);
    for (auto& [name, results] : others_) row.results[name] = results[scene.name];
    const Result reference = reference_[scene.name];
    if (reference.fault.starts_with("no gl") && reference.fault == row.results["ours"].fault) {
      row.skipped = reference.fault;
      return row;
    }
    std::vector<Picture> pictures;
    const int count = static_cast<int>(variants(scene, lodError_).size());
    for (int i = 0; i < count; ++i)
      pictures.push_back(measure::readRaw(pictureFile(temporary_.path() + "/reference", scene.name, i)));
    const Expectation expected(std::move(pictures));
    if (expected.picture().rgba.empty()) row.failures.push_back("no picture of the reference");
    judge(row, expected);
    row.results["reference"] = reference;
    writePictures(plan_, row, expected.picture());
    return row;
  }

  const Plan& plan_;
  std::vector<const Scene*> scenes_;
  double lodError_;
  std::vector<std::string> names_;
  process::TemporaryDirectory temporary_;
  std::map<std::string, Result> reference_;
  std::map<std::string, std::map<std::string, Result>> others_;
};

}  // namespace

Comparison compareAll(const Plan& plan) {
  Comparison result;
  std::vector<std::string> names;
  std::vector<const Scene*> scenes;
  for (const Scene& scene : allScenes()) {
    names.push_back(scene.name);
    if (plan.filter.matches(scene.name)) scenes.push_back(&scene);
  }
  if (plan.demos)
    for (std::string& name : demoNames()) names.push_back(std::move(name));
  plan.filter.chosen(names);
  result.driverErrors = measureDriver();
  const double lodError =
      std::max(result.driverErrors["level-of-detail"], result.driverErrors["level-of-detail-in-perspective"]);
  result.rows = Drawn(plan, scenes, lodError).rows(result.driverErrors);
  if (plan.demos) {
    std::vector<Row> demos = compareDemos(plan);
    std::move(demos.begin(), demos.end(), std::back_inserter(result.rows));
  }
  return result;
}

}  // namespace comparison
