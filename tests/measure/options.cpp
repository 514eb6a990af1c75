#include "tests/measure/options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace measure {

bool Filter::matches(const std::string& name) const {
  return parts.empty() || std::any_of(parts.begin(), parts.end(), [&](const std::string& part) {
           return name.find(part) != std::string::npos;
         });
}

std::vector<std::string> Filter::chosen(const std::vector<std::string>& names) const {
  std::vector<std::string> result;
  std::copy_if(names.begin(), names.end(), std::back_inserter(result),
               [this](const std::string& name) { return matches(name); });
  if (result.empty())
    throw std::invalid_argument(fmt::format("nothing has a name with '{}'", fmt::join(parts, "' or '")));
  return result;
}

void addFilter(CLI::App& app, Filter& filter) {
  app.add_option("--filter", filter.parts, "only names that contain this; may be repeated")->take_all();
}

void addRounds(CLI::App& app, int& rounds) {
  app.add_option("--rounds", rounds, "rounds of fresh processes, taken in turns")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
}

void addFormat(CLI::App& app, Format& format) {
  CLI::Option* csv = app.add_flag_callback(
      "--csv", [&] { format = Format::Csv; }, "comma-separated values instead of a table");
  app.add_flag_callback(
         "--json", [&] { format = Format::Json; }, "JSON instead of a table")
      ->excludes(csv);
}

void addSources(CLI::App& app, Sources& sources) {
  app.add_option("--mesa-libraries", sources.mesaLibraries, "directory of the system's libEGL.so.1")
      ->capture_default_str();
  app.add_option("--also", sources.also, "also the libEGL.so.1 of a folder: NAME=FOLDER; may be repeated")
      ->take_all();
  app.add_option("--with", sources.variables,
                 "also NAME:VARIABLE=VALUE,... (an environment); may be repeated")
      ->take_all();
}

}  // namespace measure
