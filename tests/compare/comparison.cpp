#include "comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

namespace comparison {

namespace {

constexpr unsigned kWorkerSeconds = 300;
constexpr const char* kSelf = "/proc/self/exe";

Environment withoutCaches(Environment environment) {
  environment["MESA_SHADER_CACHE_DISABLE"] = "true";
  environment["ANTEROOM_CACHE"] = "off";
  return environment;
}

// Renders on one implementation; a crash costs its scene alone, and a new process goes on behind it.
std::map<std::string, Result> renderScenes(const Environment& environment, const WorkerTask& task) {
  std::map<std::string, Result> results;
  std::vector<std::string> left = task.scenes;
  while (!left.empty()) {
    std::vector<std::string> arguments = {"--worker",  task.directory,
                                          "--shifts",  std::to_string(task.shifts),
                                          "--repeats", std::to_string(task.repeats)};
    for (const std::string& name : left) arguments.insert(arguments.end(), {"--scene", name});
    const Outcome outcome = run(kSelf, arguments, withoutCaches(environment), kWorkerSeconds);
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
        result.milliseconds = std::stod(line.substr(second + 1));
        result.picture = readPicture(pictureFile(task.directory, name, 0));
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

bool wanted(const Plan& plan, const std::string& name) {
  return plan.filters.empty() ||
         std::any_of(plan.filters.begin(), plan.filters.end(),
                     [&name](const std::string& part) { return name.find(part) != std::string::npos; });
}

const char* driverScene(Driver driver) {
  return driver == Driver::kFilter ? "driver/filter weights" : "driver/level of detail";
}

// 1/255, and 2/255 after three or more roundings; or the driver's own error where that is more.
void setBound(Row& row, const Scene& scene, const std::map<std::string, int>& driverErrors) {
  row.bound = scene.blendedPasses >= 3 ? 2 : 1;
  if (scene.surface.rgb565) {
    row.bound = 9;
    row.boundReason = "one step of five bits";
  }
  if (scene.driver == Driver::kExact || scene.name == driverScene(scene.driver)) return;
  const auto measured = driverErrors.find(driverScene(scene.driver));
  if (measured == driverErrors.end() || measured->second <= row.bound) return;
  row.bound = measured->second;
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

std::string fileName(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '/' || c == ' ' || c == ','; }, '-');
  return name + ".png";
}

void writePictures(const Plan& plan, const Row& row, const Picture& reference) {
  if (plan.out.empty()) return;
  std::vector<Picture> pictures = {reference};
  for (const Implementation& implementation : plan.implementations) {
    const auto result = row.results.find(implementation.name);
    pictures.push_back(result != row.results.end() ? result->second.picture : Picture{});
  }
  if (!reference.rgba.empty()) writeSideBySide(plan.out + "/" + fileName(row.name), pictures);
}

}  // namespace

std::vector<Row> compareAll(const Plan& plan) {
  std::vector<const Scene*> scenes;
  std::vector<std::string> names;
  for (const Scene& scene : allScenes()) {
    // What a bound may come from is always measured.
    if (!wanted(plan, scene.name) && !scene.name.starts_with("driver/")) continue;
    scenes.push_back(&scene);
    names.push_back(scene.name);
  }
  const TemporaryDirectory temporary;
  const auto render = [&](const std::string& name, const Environment& environment, int shifts, int repeats) {
    const std::string directory = temporary.path() + "/" + name;
    std::filesystem::create_directories(directory);
    return renderScenes(environment, {directory, names, shifts, repeats});
  };
  const auto references = render("reference", plan.reference, kShiftCount, 1);
  std::map<std::string, std::map<std::string, Result>> others;
  for (const Implementation& implementation : plan.implementations)
    others[implementation.name] = render(implementation.name, implementation.environment, 1, plan.repeats);

  std::vector<Row> rows;
  std::map<std::string, int> driverErrors;
  for (const Scene* scene : scenes) {
    Row row{scene->name, scene->section, scene->mesaDiffers, scene->extreme, 1, {}, {}, 0, {}};
    std::vector<Picture> pictures;
    for (int shift = 0; shift < kShiftCount; ++shift)
      pictures.push_back(readPicture(pictureFile(temporary.path() + "/reference", scene->name, shift)));
    for (auto& [name, results] : others) row.results[name] = results[scene->name];
    setBound(row, *scene, driverErrors);
    const Expectation expected(std::move(pictures));
    if (expected.picture().rgba.empty()) row.failures.push_back("no picture of the reference");
    judge(row, expected);
    row.results["reference"] = references.at(scene->name);
    if (scene->name.starts_with("driver/")) {
      driverErrors[scene->name] = row.results["ours"].difference.worst;
      row.failures.clear();
    }
    writePictures(plan, row, expected.picture());
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace comparison
