// Commands that compile, change a cache, or carry it elsewhere.
#include <fmt/format.h>

#include <chrono>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "gen/inspect/commands.h"
#include "gen/inspect/words.h"

namespace anteroom::inspect {
namespace {

constexpr const char* kFormat = "anteroom-cache-keys";

// Nothing: the key does not compile.
std::optional<gen::Row> compiled(gen::KeyKind kind, gen::KeyBytes key) {
  const auto start = std::chrono::steady_clock::now();
  std::string glsl = gen::emit(kind, key);
  gen::CompileResult result = gen::compile(gen::stageOf(kind), glsl);
  const auto time = std::chrono::steady_clock::now() - start;
  if (result.spirv.empty()) return {};
  return gen::makeRow(kind, key, std::move(glsl), std::move(result.spirv),
                      std::chrono::duration_cast<std::chrono::microseconds>(time).count());
}

Status finish(gen::Store& store, const Settings& settings, bool good) {
  if (good && store.commit()) return kDone;
  fmt::print(stderr, "anteroom-cache: {} cannot be written: {}\n", settings.file, store.message());
  store.rollback();
  return kUnusable;
}

Status begin(const Settings& settings, gen::Store::Mode mode, gen::Store& store) {
  std::error_code ignored;
  if (mode == gen::Store::Mode::Create)
    std::filesystem::create_directories(std::filesystem::absolute(settings.file, ignored).parent_path(),
                                        ignored);
  if (const Status status = open(settings.file, mode, store)) return status;
  return store.begin() ? kDone : finish(store, settings, false);
}

template <class Key>
bool parsed(const std::string& text, std::vector<std::byte>& bytes) {
  Key key;
  if (!gen::parse(text, key)) return false;
  const auto view = gen::bytesOf(key);
  bytes.assign(view.begin(), view.end());
  return true;
}

// The key of one entry of an exported file.
bool read(const nlohmann::json& entry, gen::KeyKind& kind, std::vector<std::byte>& key) {
  if (!entry.is_object() || !entry.value("kind", nlohmann::json()).is_string() ||
      !entry.value("key", nlohmann::json()).is_string())
    return false;
  const std::string name = entry["kind"], text = entry["key"];
  for (int i = 0; i < 4; ++i) {
    kind = static_cast<gen::KeyKind>(i);
    if (name != kindName(kind)) continue;
    if (kind == gen::KeyKind::Vertex) return parsed<gen::VertexKey>(text, key);
    if (kind == gen::KeyKind::Fragment) return parsed<gen::FragmentKey>(text, key);
    const auto view = std::as_bytes(std::span(text));
    key.assign(view.begin(), view.end());
    return gen::validKey(kind, key);
  }
  return false;
}

}  // namespace

Status verify(const Settings& settings, bool repair) {
  std::vector<Listed> rows;
  if (const Status status = readRows(settings.file, rows)) return status;
  gen::Store store;
  if (const Status status = repair ? begin(settings, gen::Store::Mode::Write, store)
                                   : open(settings.file, gen::Store::Mode::Read, store))
    return status;
  bool written = true;
  size_t bad = 0;
  auto faults = nlohmann::json::array();
  for (auto& [id, row, why] : rows) {
    const bool keyGood = gen::validKey(row.kind, row.key) && row.id() == id;
    const auto again = keyGood ? compiled(row.kind, row.key) : std::nullopt;
    const bool current = again && again->generator == row.generator;
    if (why.empty() && !again) why = "its key does not compile";
    if (why.empty() && current && (again->spirv != row.spirv || again->glsl != row.glsl))
      why = "it is not what its key compiles to";
    if (!why.empty()) {
      ++bad;
      faults.push_back({{"key", name(id)}, {"fault", why}});
      if (!settings.json) fmt::print("{} {}\n", name(id), why);
    }
    if (repair && (!why.empty() || !current))
      written = written && (again ? store.put(*again) : store.remove(id));
  }
  const bool sound =
      store.database().ask("SELECT count(*) FROM pragma_quick_check WHERE quick_check = 'ok'", 0) == 1;
  if (settings.json)
    fmt::print(
        "{}\n",
        nlohmann::json{{"rows", rows.size()}, {"bad", bad}, {"sound", sound}, {"faults", faults}}.dump(2));
  else
    fmt::print("{} rows, {} bad{}; the file is {}\n", rows.size(), bad, repair && bad ? ", repaired" : "",
               sound ? "sound" : "damaged");
  if (repair)
    if (const Status status = finish(store, settings, written)) return status;
  return sound && (bad == 0 || repair) ? kDone : kNo;
}

Status prune(const Settings& settings, uint64_t limit, int unusedDays) {
  gen::Store store;
  if (const Status status = begin(settings, gen::Store::Mode::Write, store)) return status;
  const int64_t oldest = unusedDays < 0 ? INT64_MIN : std::time(nullptr) - int64_t{86400} * unusedDays;
  std::vector<int64_t> old;
  bool good = store.visit([&](int64_t id, gen::Row& row, const std::string& why) {
    if (row.used < oldest || !why.empty()) old.push_back(id);
  });
  for (int64_t id : old) good = good && store.remove(id);
  const int64_t dropped = good ? store.shrink(limit) : -1;
  if (const Status status = finish(store, settings, dropped >= 0)) return status;
  store.database().run("VACUUM");
  const int64_t all = static_cast<int64_t>(old.size()) + dropped;
  if (settings.json)
    fmt::print("{}\n", nlohmann::json{{"removed", all}}.dump());
  else
    fmt::print("{} rows removed\n", all);
  return kDone;
}

Status exportKeys(const Settings& settings, const std::string& to) {
  std::vector<Listed> rows;
  if (const Status status = readRows(settings.file, rows)) return status;
  auto keys = nlohmann::json::array();
  for (const auto& [id, row, why] : rows) {
    if (!why.empty()) continue;
    const bool own = row.kind == gen::KeyKind::VertexText || row.kind == gen::KeyKind::FragmentText;
    keys.push_back(
        {{"kind", kindName(row.kind)}, {"key", own ? gen::emit(row.kind, row.key) : row.description}});
  }
  const std::string text = nlohmann::json{{"format", kFormat}, {"version", 1}, {"keys", keys}}.dump(
                               1, ' ', false, nlohmann::json::error_handler_t::replace) +
                           "\n";
  if (to == "-") {
    fmt::print("{}", text);
    return kDone;
  }
  std::ofstream file(to, std::ios::binary);
  if (file << text << std::flush) return kDone;
  fmt::print(stderr, "anteroom-cache: {} cannot be written\n", to);
  return kUnusable;
}

Status importKeys(const Settings& settings, const std::string& from) {
  std::ifstream file;
  if (from != "-") file.open(from, std::ios::binary);
  if (from != "-" && !file) {
    fmt::print(stderr, "anteroom-cache: {} cannot be read\n", from);
    return kMissing;
  }
  const auto json = nlohmann::json::parse(from == "-" ? std::cin : file, nullptr, false);
  if (!json.is_object() || json.value("format", nlohmann::json()) != kFormat || !json.contains("keys") ||
      !json["keys"].is_array()) {
    fmt::print(stderr, "anteroom-cache: {} holds no exported keys\n", from);
    return kNotACache;
  }
  gen::Store store;
  if (const Status status = begin(settings, gen::Store::Mode::Create, store)) return status;
  size_t done = 0, refused = 0;
  bool good = true;
  for (const auto& entry : json["keys"]) {
    gen::KeyKind kind;
    std::vector<std::byte> key;
    const auto row = read(entry, kind, key) ? compiled(kind, key) : std::nullopt;
    if (row) good = good && store.put(*row);
    ++(row ? done : refused);
  }
  if (const Status status = finish(store, settings, good)) return status;
  if (settings.json)
    fmt::print("{}\n", nlohmann::json{{"imported", done}, {"refused", refused}}.dump());
  else
    fmt::print("{} keys imported and compiled, {} refused\n", done, refused);
  return refused ? kNo : kDone;
}

Status merge(const Settings& settings, const std::vector<std::string>& from) {
  std::vector<Listed> rows;
  for (const std::string& file : from)
    if (const Status status = readRows(file, rows)) return status;
  gen::Store store;
  if (const Status status = begin(settings, gen::Store::Mode::Create, store)) return status;
  size_t done = 0, bad = 0;
  bool good = true;
  for (const Listed& row : rows) {
    if (row.why.empty()) good = good && store.put(row.row);
    ++(row.why.empty() ? done : bad);
  }
  if (const Status status = finish(store, settings, good)) return status;
  if (settings.json)
    fmt::print("{}\n", nlohmann::json{{"merged", done}, {"bad", bad}}.dump());
  else
    fmt::print("{} rows merged, {} bad ones left out\n", done, bad);
  return kDone;
}

}  // namespace anteroom::inspect
