// What the command lines of all programs that measure have in common.
#pragma once

#include <CLI/CLI.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/measure/implementations.h"
#include "tests/measure/table.h"

namespace measure {

// Nothing is selected. What a user can put right ends a program with status 2.
constexpr int kUsage = 2;

// Names that contain one of the parts; every name when there are none.
struct Filter {
  std::vector<std::string> parts;

  bool matches(const std::string& name) const;
  // Those of the names that match, in their order. Throws std::invalid_argument when there are none.
  std::vector<std::string> chosen(const std::vector<std::string>& names) const;
};

enum class Format { Text, Csv, Json };

void addFilter(CLI::App& app, Filter& filter);
void addRounds(CLI::App& app, int& rounds);
void addFormat(CLI::App& app, Format& format);
void addSources(CLI::App& app, Sources& sources);

}  // namespace measure
