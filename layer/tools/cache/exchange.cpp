// Commands that change a cache, or carry it elsewhere.
#include <fmt/format.h>

#include <charconv>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "layer/tools/cache/change.h"
#include "layer/tools/cache/words.h"

namespace anteroom::inspect {
namespace {

constexpr const char* kFormat = "anteroom-cache-keys";
constexpr int kVersion = 1;

void answer(const Settings& settings, const nlohmann::json& json, const std::string& words) {
  if (settings.json)
    fmt::print("{}\n", json.dump(2));
  else
    fmt::print("{}\n", words);
}

bool textOf(const nlohmann::json& entry, const char* field, std::string& out) {
  if (!entry.is_object() || !entry.contains(field) || !entry[field].is_string()) return false;
  out = entry[field];
  return true;
}

int64_t numberOf(const nlohmann::json& entry, const char* field) {
  const auto found = entry.find(field);
  return found != entry.end() && found->is_number_integer() ? std::clamp<int64_t>(*found, 0, 1'000'000) : 0;
}

bool keyOf(const nlohmann::json& entry, cache::KeyKind& kind, std::vector<std::byte>& key) {
  std::string name, words;
  if (!textOf(entry, "kind", name) || !textOf(entry, "key", words)) return false;
  const bool vertex = name.starts_with("vertex");
  return cache::keyOf(vertex ? gen::Stage::Vertex : gen::Stage::Fragment, words, kind, key) &&
         name == kindName(kind);
}

// Both shaders must be keys of this generator's; what the state means is the renderer's to say.
bool pipelineOf(const nlohmann::json& entry, cache::PipelineRow& row) {
  cache::KeyKind kind;
  std::vector<std::byte> key;
  if (!textOf(entry, "vertex", row.vertex) || !textOf(entry, "fragment", row.fragment) ||
      !textOf(entry, "state", row.state) || row.state.size() > 4096)
    return false;
  row.created = row.used = std::time(nullptr);
  return cache::keyOf(gen::Stage::Vertex, row.vertex, kind, key) &&
         cache::keyOf(gen::Stage::Fragment, row.fragment, kind, key);
}

bool idOf(const std::string& text, int64_t& id) {
  uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  id = static_cast<int64_t>(value);
  return error == std::errc() && end == text.data() + text.size();
}

bool usageOf(const nlohmann::json& entry, cache::UsageRow& row) {
  std::string program, pipeline;
  if (!textOf(entry, "program", program) || !textOf(entry, "name", row.program.name) ||
      !textOf(entry, "pipeline", pipeline) || row.program.name.size() > 256)
    return false;
  row.runs = numberOf(entry, "runs");
  row.uses = numberOf(entry, "uses");
  row.run = numberOf(entry, "run");
  row.place = numberOf(entry, "place");
  return idOf(program, row.program.id) && idOf(pipeline, row.pipeline);
}

// What "keys", "pipelines" and "usage" of an exported file bring.
struct Import {
  cache::Store& store;
  size_t shaders = 0, pipelines = 0, refused = 0;
  bool good = true;  // so far everything could be written

  template <class Take>
  void each(const nlohmann::json& json, const char* what, Take take) {
    if (!json.contains(what) || !json[what].is_array()) return;
    for (const auto& entry : json[what]) refused += !take(entry);
  }
  bool shader(const nlohmann::json& entry) {
    cache::KeyKind kind;
    std::vector<std::byte> key;
    const auto row = keyOf(entry, kind, key) ? compiled(kind, key) : std::nullopt;
    if (!row) return false;
    good = good && store.put(*row);
    ++shaders;
    return true;
  }
  bool pipeline(const nlohmann::json& entry) {
    cache::PipelineRow row;
    if (!pipelineOf(entry, row)) return false;
    good = good && store.put(row);
    ++pipelines;
    return true;
  }
  bool usage(const nlohmann::json& entry) {
    cache::UsageRow row;
    if (!usageOf(entry, row)) return false;
    good = good && store.put(row);
    return true;
  }
};

}  // namespace

Status verify(const Settings& settings, bool repair) {
  Contents contents;
  if (const Status status = read(settings.file, contents)) return status;
  cache::Store store;
  if (const Status status = repair ? begin(settings, cache::Store::Mode::Write, store)
                                   : open(settings.file, cache::Store::Mode::Read, store))
    return status;
  bool written = true;
  size_t bad = 0;
  auto faults = nlohmann::json::array();
  const auto fault = [&](int64_t id, const std::string& why) {
    ++bad;
    faults.push_back({{"key", name(id)}, {"fault", why}});
    if (!settings.json) fmt::print("{} {}\n", name(id), why);
  };
  for (auto& [number, id, row, why] : contents.shaders) {
    // Another generator's shaders are for it to judge, but for their form.
    if (!row.current() && why.empty()) continue;
    const std::vector<std::byte> key = row.id() == id ? row.currentKey() : std::vector<std::byte>{};
    const auto again = key.empty() ? std::nullopt : compiled(row.kind, key);
    if (why.empty() && !again) why = "its key does not compile";
    if (why.empty() && (again->spirv != row.spirv || again->glsl != row.glsl))
      why = "it is not what its key compiles to";
    if (why.empty()) continue;
    fault(id, why);
    if (repair) written = written && store.removeShader(number) && (!again || store.put(*again));
  }
  for (const Pipeline& pipeline : contents.pipelines) {
    if (pipeline.why.empty()) continue;
    fault(pipeline.id, pipeline.why);
    if (repair) written = written && store.removePipeline(pipeline.id);
  }
  const bool sound =
      store.database().ask("SELECT count(*) FROM pragma_quick_check WHERE quick_check = 'ok'", 0) == 1;
  if (repair)
    if (const Status status = finish(store, settings, written)) return status;
  const size_t rows = contents.shaders.size() + contents.pipelines.size();
  answer(settings, {{"rows", rows}, {"bad", bad}, {"sound", sound}, {"faults", faults}},
         fmt::format("{} rows, {} bad{}; the file is {}", rows, bad, repair && bad ? ", repaired" : "",
                     sound ? "sound" : "damaged"));
  return sound && (bad == 0 || repair) ? kDone : kNo;
}

Status prune(const Settings& settings, uint64_t limit, int unusedDays) {
  cache::Store store;
  if (const Status status = begin(settings, cache::Store::Mode::Write, store)) return status;
  const int64_t oldest = unusedDays < 0 ? INT64_MIN : std::time(nullptr) - int64_t{86400} * unusedDays;
  std::vector<int64_t> shaders, pipelines;
  bool good = store.visitShaders([&](int64_t number, int64_t, cache::ShaderRow& row, const std::string& why) {
    if (row.used < oldest || !why.empty()) shaders.push_back(number);
  }) && store.visitPipelines([&](int64_t id, cache::PipelineRow& row, const std::string& why) {
    if (row.used < oldest || !why.empty()) pipelines.push_back(id);
  });
  for (int64_t number : shaders) good = good && store.removeShader(number);
  for (int64_t id : pipelines) good = good && store.removePipeline(id);
  const int64_t dropped = good ? store.shrink(limit) : -1;
  if (const Status status = finish(store, settings, dropped >= 0)) return status;
  store.database().run("VACUUM");
  const int64_t all = static_cast<int64_t>(shaders.size() + pipelines.size()) + dropped;
  answer(settings, {{"removed", all}}, fmt::format("{} rows removed", all));
  return kDone;
}

Status exportKeys(const Settings& settings, const std::string& to) {
  Contents contents;
  if (const Status status = read(settings.file, contents)) return status;
  nlohmann::json json{{"format", kFormat}, {"version", kVersion}};
  for (const char* list : {"keys", "pipelines", "usage"}) json[list] = nlohmann::json::array();
  for (const Shader& shader : contents.shaders) {
    const std::vector<std::byte> key = shader.row.currentKey();
    if (!shader.why.empty() || key.empty()) continue;
    nlohmann::json entry{{"kind", kindName(shader.row.kind)}, {"key", cache::wordsOf(shader.row.kind, key)}};
    // Rows of several generators may mean one key.
    auto& keys = json["keys"];
    if (std::find(keys.begin(), keys.end(), entry) == keys.end()) keys.push_back(std::move(entry));
  }
  for (const auto& [id, row, why] : contents.pipelines)
    if (why.empty())
      json["pipelines"].push_back({{"vertex", row.vertex}, {"fragment", row.fragment}, {"state", row.state}});
  for (const cache::UsageRow& row : contents.usage)
    json["usage"].push_back({{"program", name(row.program.id)},
                             {"name", row.program.name},
                             {"runs", row.runs},
                             {"pipeline", name(row.pipeline)},
                             {"uses", row.uses},
                             {"run", row.run},
                             {"place", row.place}});
  const std::string text = json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
  if (to == "-") {
    fmt::print("{}", text);
    return kDone;
  }
  if (const Status status = write(to, text)) return status;
  if (settings.json)
    fmt::print(
        "{}\n",
        nlohmann::json{{"keys", json["keys"].size()}, {"pipelines", json["pipelines"].size()}, {"file", to}}
            .dump(2));
  return kDone;
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
  if (json.value("version", nlohmann::json()) != kVersion) {
    fmt::print(stderr, "anteroom-cache: {} was exported by another version of Anteroom\n", from);
    return kNotACache;
  }
  cache::Store store;
  if (const Status status = begin(settings, cache::Store::Mode::Create, store)) return status;
  Import import{store};
  import.each(json, "keys", [&](const auto& entry) { return import.shader(entry);
});
  import.each(json, "pipelines", [&](const auto& entry) { return import.pipeline(entry);
  }  // namespace anteroom::inspect
);
  import.each(json, "usage", [&](const auto& entry) { return import.usage(entry);
  });
  if (const Status status = finish(store, settings, import.good)) return status;
  answer(settings,
         {{"imported", import.shaders}, {"pipelines", import.pipelines}, {"refused", import.refused}},
         fmt::format("{} keys imported and compiled, {} pipelines, {} refused", import.shaders,
                     import.pipelines, import.refused));
  return import.refused ? kNo : kDone;
  }

  Status merge(const Settings& settings, const std::vector<std::string>& from) {
    Contents contents;
    for (const std::string& file : from)
      if (const Status status = read(file, contents)) return status;
    cache::Store store;
    if (const Status status = begin(settings, cache::Store::Mode::Create, store)) return status;
    size_t done = 0, bad = 0;
    bool good = true;
    const auto take = [&](const auto& entry) {
      if (entry.why.empty()) good = good && store.put(entry.row);
      ++(entry.why.empty() ? done : bad);
    };
    for (const Shader& shader : contents.shaders) take(shader);
    for (const Pipeline& pipeline : contents.pipelines) take(pipeline);
    for (const cache::UsageRow& usage : contents.usage) good = good && store.put(usage);
    if (const Status status = finish(store, settings, good)) return status;
    answer(settings, {{"merged", done}, {"bad", bad}},
           fmt::format("{} rows merged, {} bad ones left out", done, bad));
    return kDone;
  }

  }  // namespace anteroom::inspect
