// Implementations of EGL and GLES, as environments in which a process finds them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/measure/process.h"

namespace measure {

struct Implementation {
  std::string name;
  process::Environment environment;
};

// `environment` with more, which goes before what it has.
process::Environment with(process::Environment environment, const process::Environment& more);

// The libraries that are built beside this program; none when they are not there.
std::optional<Implementation> ours();
// Ours, drawn by the float64 renderer; none when it is not there.
std::optional<Implementation> reference();
// Of the folder that holds Mesa's libEGL.so.1.
Implementation mesa(const std::string& folder);
Implementation zink(const std::string& folder);
std::string systemLibraries();

// NAME=FOLDER: the libEGL.so.1 of that folder. Throws std::invalid_argument, as the next one does.
Implementation fromFolder(const std::string& text);
// NAME:VARIABLE=VALUE,VARIABLE=VALUE.
Implementation fromVariables(const std::string& text);

// Caches of shaders: none, or one below `folder` that only this run uses.
process::Environment withoutCaches(const process::Environment& environment);
process::Environment withCaches(const process::Environment& environment, const std::string& folder);

// What the command line says of them.
struct Sources {
  std::string mesaLibraries = systemLibraries();
  std::vector<std::string> also;       // as for fromFolder
  std::vector<std::string> variables;  // as for fromVariables
};
// Those of `also` and of `variables`.
std::vector<Implementation> others(const Sources& sources);
// Ours, Mesa's native and Mesa's zink, then the others. Says on standard error when ours are not there.
std::vector<Implementation> sideBySide(const Sources& sources);

// Every implementation has its turn in every round, and another one begins each: none always pays for what
// came before it. `run` is called with each number below `count` once.
template <class Run>
void takeTurns(std::size_t round, std::size_t count, Run run) {
  for (std::size_t turn = 0; turn < count; ++turn) run((turn + round) % count);
}

}  // namespace measure
