// anteroom-cache: looks into the shader cache.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <functional>
#include <string_view>

#include "layer/cache/location.h"
#include "layer/tools/cache/commands.h"

namespace {

using namespace anteroom;
using namespace anteroom::inspect;

struct Arguments {
  Settings settings;
  std::string color = "auto", sort = "uses", first, second, path, program, device;
  std::vector<std::string> sources;
  size_t most = 0;
  uint64_t limit = UINT64_MAX;
  int days = -1;
  bool repair = false, pipelines = false;
  std::function<Status()> command;
};

// https://no-color.org, and terminals that know no colors.
bool wantsColor(const std::string& wish) {
  if (wish != "auto") return wish == "always";
  const char* const none = std::getenv("NO_COLOR");
  const char* const terminal = std::getenv("TERM");
  return isatty(STDOUT_FILENO) && !(none && *none) && terminal && std::string_view(terminal) != "dumb";
}

CLI::App* add(CLI::App& app, Arguments& a, const char* name, const char* help, std::function<Status()> body) {
  CLI::App* const sub = app.add_subcommand(name, help);
  sub->callback([&a, body = std::move(body)] { a.command = body; });
  return sub;
}

void describeLooking(CLI::App& app, Arguments& a) {
  const Settings& s = a.settings;
  auto* sub = add(app, a, "list", "every shader, or every pipeline",
                  [&] { return list(s, a.sort, a.most, a.pipelines); });
  sub->add_option("--sort", a.sort, "by uses, compile, size or age, the most first")
      ->check(CLI::IsMember({"uses", "compile", "size", "age"}));
  sub->add_option("-n", a.most, "only so many");
  sub->add_flag("--pipelines", a.pipelines, "pipelines instead of shaders");
  sub = add(app, a, "show", "one shader or pipeline: state, GLSL, SPIR-V, sizes, times",
            [&] { return show(s, a.first); });
  sub->add_option("KEY", a.first, "the key, or the beginning of it")->required();
  sub->add_option("--color", a.color, "auto, always or never")
      ->check(CLI::IsMember({"auto", "always", "never"}));
  sub = add(app, a, "diff", "what tells two shaders or pipelines apart",
            [&] { return diff(s, a.first, a.second); });
  sub->add_option("KEY1", a.first)->required();
  sub->add_option("KEY2", a.second)->required();
  sub->add_option("--color", a.color, "auto, always or never")
      ->check(CLI::IsMember({"auto", "always", "never"}));
  sub = add(app, a, "explain", "which state splits pipelines and shaders, and how many it makes",
            [&] { return explain(s, a.program); });
  sub->add_option("--program", a.program, "only what programs of this name needed");
  add(app, a, "stats", "totals", [&] { return stats(s); });
  sub = add(app, a, "report", "a page that shows it all", [&] { return report(s, a.path); });
  sub->add_option("FILE.html", a.path)->required();
}

void describeChanging(CLI::App& app, Arguments& a) {
  const Settings& s = a.settings;
  auto* sub =
      add(app, a, "verify", "check every row, and compile it again", [&] { return verify(s, a.repair); });
  sub->add_flag("--repair", a.repair, "replace bad rows");
  sub = add(app, a, "prune", "remove bad rows, and those unused for long",
            [&] { return prune(s, a.limit, a.days); });
  sub->add_option("--limit", a.limit, "until the rest fits so many bytes")
      ->transform(CLI::AsSizeValue(false));
  sub->add_option("--unused", a.days, "those unused for so many days")->check(CLI::NonNegativeNumber);
  sub = add(app, a, "warm", "compile everything for this version and this machine's device",
            [&] { return warm(s, a.device); });
  sub->add_option("--device", a.device, "Vulkan device: an index, or a part of its name")
      ->envname("ANTEROOM_DEVICE");
  sub = add(app, a, "export", "write the keys as text", [&] { return exportKeys(s, a.path); });
  sub->add_option("FILE", a.path, "- for standard output")->required();
  sub = add(app, a, "import", "compile exported keys into the cache", [&] { return importKeys(s, a.path); });
  sub->add_option("FILE", a.path, "- for standard input")->required();
  sub = add(app, a, "merge", "add the good rows of other caches", [&] { return merge(s, a.sources); });
  sub->add_option("CACHE", a.sources)->required();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Looks into Anteroom's shader cache.", "anteroom-cache");
  app.footer(
      "Exit status: 0 done; 1 the answer is no; 2 usage; 3 no such file; 4 no cache, damaged or of another "
      "version; 5 cannot be read or written, or there is no device.");
  app.set_version_flag("--version", "anteroom-cache " ANTEROOM_VERSION);
  app.require_subcommand(1);
  app.fallthrough();
  Arguments a;
  app.add_option("-f,--file", a.settings.file, "the cache; by default the one that programs use");
  app.add_flag("--json", a.settings.json, "answer in JSON");
  describeLooking(app, a);
  describeChanging(app, a);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) ? kUsage : kDone;
  }
  if (a.settings.file.empty()) {
    const cache::CacheLocation location = cache::cacheLocation();
    a.settings.file = location.file;
    if (a.settings.file.empty()) {
      fmt::print(stderr, "anteroom-cache: {}; or name a file with --file\n",
                 location.reason.empty() ? "ANTEROOM_CACHE is off" : location.reason);
      return kMissing;
    }
  }
  a.settings.color = wantsColor(a.color);
  try {
    return a.command();
  } catch (const std::exception& error) {
    fmt::print(stderr, "anteroom-cache: {}\n", error.what());
    return kUnusable;
  }
}
