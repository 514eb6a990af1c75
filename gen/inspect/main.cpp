// anteroom-cache: looks into the shader cache.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "gen/cache/location.h"
#include "gen/inspect/commands.h"

int main(int argc, char** argv) {
  using namespace anteroom;
  using namespace anteroom::inspect;
  CLI::App app("Looks into Anteroom's shader cache.", "anteroom-cache");
  app.footer(
      "Exit status: 0 done; 1 the answer is no; 2 usage; 3 no such file; 4 no cache, damaged or newer; "
      "5 cannot be read or written.");
  app.require_subcommand(1);
  app.fallthrough();
  Settings settings;
  app.add_option("-f,--file", settings.file, "the cache; by default the one that programs use");
  app.add_flag("--json", settings.json, "answer in JSON");

  std::string sort = "uses", first, second, path;
  std::vector<std::string> sources;
  size_t most = 0;
  uint64_t limit = UINT64_MAX;
  int days = -1;
  bool repair = false;
  std::function<Status()> command;
  const auto add = [&](const char* name, const char* help, std::function<Status()> body) {
    CLI::App* sub = app.add_subcommand(name, help);
    sub->callback([&command, body] { command = body; });
    return sub;
  };
  auto* sub = add("list", "every shader", [&] { return list(settings, sort, most); });
  sub->add_option("--sort", sort, "by uses, compile, size or age, the most first")
      ->check(CLI::IsMember({"uses", "compile", "size", "age"}));
  sub->add_option("-n", most, "only so many");
  sub = add("show", "one shader: state, GLSL, SPIR-V, sizes, times", [&] { return show(settings, first); });
  sub->add_option("KEY", first, "the key, or the beginning of it")->required();
  sub = add("diff", "what tells two shaders apart", [&] { return diff(settings, first, second); });
  sub->add_option("KEY1", first)->required();
  sub->add_option("KEY2", second)->required();
  add("explain", "which state splits the shaders, and how many it makes", [&] { return explain(settings); });
  add("stats", "totals", [&] { return stats(settings); });
  sub = add("verify", "check every row, and compile it again", [&] { return verify(settings, repair); });
  sub->add_flag("--repair", repair, "replace bad and outdated rows");
  sub = add("prune", "remove bad rows, and those unused for long",
            [&] { return prune(settings, limit, days); });
  sub->add_option("--limit", limit, "until the rest fits so many bytes")->transform(CLI::AsSizeValue(false));
  sub->add_option("--unused", days, "those unused for so many days")->check(CLI::NonNegativeNumber);
  sub = add("export", "write the keys as text", [&] { return exportKeys(settings, path); });
  sub->add_option("FILE", path, "- for standard output")->required();
  sub = add("import", "compile exported keys into the cache", [&] { return importKeys(settings, path); });
  sub->add_option("FILE", path, "- for standard input")->required();
  sub = add("merge", "add the good rows of other caches", [&] { return merge(settings, sources); });
  sub->add_option("CACHE", sources)->required();

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) ? kUsage : kDone;
  }
  if (settings.file.empty()) {
    const gen::CacheLocation location = gen::cacheLocation();
    settings.file = location.file;
    if (settings.file.empty()) {
      fmt::print(stderr, "anteroom-cache: {}; or name a file with --file\n",
                 location.reason.empty() ? "ANTEROOM_CACHE is off" : location.reason);
      return kMissing;
    }
  }
  try {
    return command();
  } catch (const std::exception& error) {
    fmt::print(stderr, "anteroom-cache: {}\n", error.what());
    return kUnusable;
  }
}
