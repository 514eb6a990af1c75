// Runs debug_program under the variables that are tested, with the validation layer on.
#pragma once

#include <string>
#include <vector>

#include "tests/measure/process.h"

namespace anteroom::test {

struct Ended {
  int status = 0;
  std::string output;  // standard output and standard error
};
Ended runProgram(const std::vector<std::string>& arguments, const process::Environment& environment);

// What has the recording layer write to `log`.
process::Environment recorded(const std::string& log, process::Environment more);

std::string contentsOf(const std::string& path);
std::vector<std::string> linesOf(const std::string& text);
// How often `part` is in `text`.
size_t countOf(const std::string& text, const std::string& part);

}  // namespace anteroom::test
