// anteroom-info: what EGL and OpenGL ES there are, on which device, and why on that one.
#include <CLI/CLI.hpp>
#include <cstdio>

#include "layer/tools/info/print.h"

int main(int argc, char** argv) {
  CLI::App program("Tells what EGL and OpenGL ES 1.1 there are, on which Vulkan device and why.",
                   "anteroom-info");
  program.set_version_flag("--version", "anteroom-info " ANTEROOM_VERSION);
  bool brief = false, json = false;
  program.add_flag("--brief", brief, "no extensions, configs and limits");
  program.add_flag("--json", json, "all of it, in JSON")->excludes("--brief");
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) ? 2 : 0;
  }
  const info::Facts facts = info::ask();
  if (json)
    info::printJson(facts);
  else
    info::print(facts, brief);
  if (!facts.platforms.empty()) return 0;
  std::fflush(stdout);
  std::fprintf(stderr, "anteroom-info: no display can be opened\n");
  return 1;
}
