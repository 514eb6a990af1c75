// Commands that look.
#include "layer/tools/cache/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <set>
#include <spirv-tools/libspirv.hpp>
#include <sstream>

#include "layer/cache/generator_version.h"
#include "layer/tools/cache/highlight.h"
#include "layer/tools/cache/words.h"

namespace anteroom::inspect {
namespace {

constexpr int kDecimals = 2;

void print(const nlohmann::json& json) {
  fmt::print("{}\n", json.dump(kDecimals));
}

// One of a cache's shaders or pipelines.
struct Entry {
  const Shader* shader = nullptr;
  const Pipeline* pipeline = nullptr;
  int64_t id() const { return shader ? shader->id : pipeline->id; }
  State state() const { return shader ? inspect::state(shader->row) : inspect::state(pipeline->row); }
};

// Of several generators' rows of one shader, this one's, else the one used last.
bool outranks(const Shader& a, const Shader& b) {
  return a.row.current() != b.row.current() ? a.row.current() : a.row.used > b.row.used;
}

Status find(const Contents& contents, const std::string& wanted, Entry& found) {
  std::vector<Entry> matches;
  for (const Shader& shader : contents.shaders) {
    if (!name(shader.id).starts_with(wanted)) continue;
    const auto same = std::find_if(matches.begin(), matches.end(),
                                   [&](const Entry& entry) { return entry.id() == shader.id; });
    if (same == matches.end())
      matches.push_back({&shader, nullptr});
    else if (outranks(shader, *same->shader))
      same->shader = &shader;
  }
  for (const Pipeline& pipeline : contents.pipelines)
    if (name(pipeline.id).starts_with(wanted)) matches.push_back({nullptr, &pipeline});
  if (matches.size() == 1 && !wanted.empty()) {
    found = matches[0];
    return kDone;
  }
  fmt::print(stderr, "anteroom-cache: {} {}; `anteroom-cache list` shows the keys\n",
             matches.empty() ? "no key begins with" : "more than one key begins with", wanted);
  return kNo;
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) result.push_back(line);
  return result;
}

// The lines of both with "  ", "- " or "+ " before them: the longest common part is kept.
std::vector<std::string> lineDiff(const std::string& first, const std::string& second) {
  const auto a = lines(first), b = lines(second);
  std::vector<std::vector<uint32_t>> common(a.size() + 1, std::vector<uint32_t>(b.size() + 1));
  for (size_t i = a.size(); i-- > 0;)
    for (size_t j = b.size(); j-- > 0;)
      common[i][j] = a[i] == b[j] ? common[i + 1][j + 1] + 1 : std::max(common[i + 1][j], common[i][j + 1]);
  std::vector<std::string> result;
  size_t i = 0, j = 0;
  while (i < a.size() || j < b.size()) {
    if (i < a.size() && j < b.size() && a[i] == b[j]) {
      result.push_back("  " + a[i]);
      ++i, ++j;
    } else if (j == b.size() || (i < a.size() && common[i + 1][j] >= common[i][j + 1])) {
      result.push_back("- " + a[i++]);
    } else {
      result.push_back("+ " + b[j++]);
    }
  }
  return result;
}

// The most first; what is equal stays as it is.
template <class Row, class Weight>
void arrange(std::vector<Row>& rows, size_t most, Weight weight) {
  std::stable_sort(rows.begin(), rows.end(),
                   [&](const Row& a, const Row& b) { return weight(a) > weight(b); });
  if (most && rows.size() > most) rows.resize(most);
}

void listPipelines(const Settings& settings, const std::string& sort, size_t most,
                   std::vector<Pipeline>& rows) {
  arrange(rows, most, [&](const Pipeline& row) {
    return sort == "compile" ? row.row.createMicroseconds : sort == "age" ? -row.row.created : row.row.uses;
  });
  if (settings.json) {
    auto json = nlohmann::json::array();
    for (const Pipeline& row : rows) json.push_back(toJson(row, false));
    return print(json);
  }
  fmt::print("{:16} {:>6} {:>11} {:>8}  {}\n", "key", "uses", "create", "age", "state");
  for (const auto& [id, row, why] : rows)
    fmt::print("{} {:>6} {:>11} {:>8}  {}\n", name(id), row.uses, milliseconds(row.createMicroseconds),
               ago(row.created), why.empty() ? row.state : "bad: " + why);
}

void listShaders(const Settings& settings, const std::string& sort, size_t most, std::vector<Shader>& rows) {
  arrange(rows, most, [&](const Shader& row) -> int64_t {
    if (sort == "compile") return row.row.compileMicroseconds;
    if (sort == "size") return static_cast<int64_t>(row.row.spirv.size());
    return sort == "age" ? -row.row.created : row.row.uses;
  });
  if (settings.json) {
    auto json = nlohmann::json::array();
    for (const Shader& row : rows) json.push_back(toJson(row, false));
    return print(json);
  }
  fmt::print("{:16} {:>6} {:>11} {:>9} {:>8}  {}\n", "key", "uses", "compile", "SPIR-V", "age", "state");
  for (const Shader& shader : rows) {
    const cache::ShaderRow& row = shader.row;
    const std::string state = !shader.why.empty() ? "bad: " + shader.why
                              : row.current()     ? row.description
                                                  : "(another generator's) " + row.description;
    fmt::print("{} {:>6} {:>11} {:>9} {:>8}  {}\n", name(shader.id), row.uses,
               milliseconds(row.compileMicroseconds), bytes(row.spirv.size() * 4), ago(row.created), state);
  }
}

std::string disassembled(const std::vector<uint32_t>& spirv) {
  std::string assembly;
  spvtools::SpirvTools(SPV_ENV_VULKAN_1_1)
      .Disassemble(spirv, &assembly,
                   SPV_BINARY_TO_TEXT_OPTION_FRIENDLY_NAMES | SPV_BINARY_TO_TEXT_OPTION_INDENT);
  return assembly;
}

void print(const State& state) {
  for (const auto& [field, value] : state) fmt::print("  {:18} {}\n", field, value);
}

Status showShader(const Settings& settings, const Shader& shader) {
  const cache::ShaderRow& row = shader.row;
  const Status status = shader.why.empty() ? kDone : kNo;
  const std::string assembly = disassembled(row.spirv);
  if (settings.json) {
    auto json = toJson(shader, true);
    json["assembly"] = clean(assembly);
    print(json);
    return status;
  }
  fmt::print("key        {} ({})\n", name(shader.id), kindName(row.kind));
  if (!shader.why.empty()) fmt::print("bad        {}\n", shader.why);
  fmt::print("generator  {}{}\n", row.generator,
             row.current() ? "" : " (another: for this one it is compiled again)");
  fmt::print("uses       {}, last {} ago, made {} ago\n", row.uses, ago(row.used), ago(row.created));
  fmt::print("compile    {}\n", milliseconds(row.compileMicroseconds));
  fmt::print("size       {} of GLSL, {} of SPIR-V\n", bytes(row.glsl.size()), bytes(row.spirv.size() * 4));
  fmt::print("state\n");
  print(state(row));
  fmt::print("\n{}\n{}", settings.color ? coloredGlsl(row.glsl) : row.glsl,
             settings.color ? coloredAssembly(assembly) : assembly);
  return status;
}

// The key of the shader that these words mean, if it is there.
std::string shaderOf(const Contents& contents, gen::Stage stage, const std::string& words) {
  for (const Shader& shader : contents.shaders) {
    const cache::ShaderRow& row = shader.row;
    const bool key = row.kind == cache::KeyKind::Vertex || row.kind == cache::KeyKind::Fragment;
    if (cache::stageOf(row.kind) == stage && (key ? row.description : row.glsl) == words)
      return name(shader.id);
  }
  return "not in the cache";
}

Status showPipeline(const Settings& settings, const Contents& contents, const Pipeline& pipeline) {
  const cache::PipelineRow& row = pipeline.row;
  const std::string vertex = shaderOf(contents, gen::Stage::Vertex, row.vertex),
                    fragment = shaderOf(contents, gen::Stage::Fragment, row.fragment);
  if (settings.json) {
    auto json = toJson(pipeline, true);
    json["vertex_key"] = vertex;
    json["fragment_key"] = fragment;
    print(json);
  } else {
    fmt::print("key        {} (pipeline)\n", name(pipeline.id));
    if (!pipeline.why.empty()) fmt::print("bad        {}\n", pipeline.why);
    fmt::print("shaders    vertex {}, fragment {}\n", vertex, fragment);
    fmt::print("uses       {}, last {} ago, made {} ago\n", row.uses, ago(row.used), ago(row.created));
    fmt::print("create     {}\n", milliseconds(row.createMicroseconds));
    fmt::print("state\n");
    print(state(row));
  }
  return pipeline.why.empty() ? kDone : kNo;
}

}  // namespace

Status list(const Settings& settings, const std::string& sort, size_t most, bool pipelines) {
  Contents contents;
  if (const Status status = read(settings.file, contents)) return status;
  if (pipelines)
    listPipelines(settings, sort, most, contents.pipelines);
  else
    listShaders(settings, sort, most, contents.shaders);
  return kDone;
}

Status show(const Settings& settings, const std::string& key) {
  Contents contents;
  if (const Status status = read(settings.file, contents)) return status;
  Entry entry;
  if (const Status status = find(contents, key, entry)) return status;
  return entry.shader ? showShader(settings, *entry.shader)
                      : showPipeline(settings, contents, *entry.pipeline);
}

Status diff(const Settings& settings, const std::string& first, const std::string& second) {
  Contents contents;
  if (const Status status = read(settings.file, contents)) return status;
  Entry entries[2];
  if (const Status status = find(contents, first, entries[0])) return status;
  if (const Status status = find(contents, second, entries[1])) return status;
  const State a = entries[0].state(), b = entries[1].state();
  std::set<std::string> fields;
  for (const State& state : {a, b})
    for (const auto& [field, value] : state) fields.insert(field);
  std::erase_if(fields, [&](const std::string& field) { return valueOf(a, field) == valueOf(b, field); });
  std::vector<std::string> text;
  if (entries[0].shader && entries[1].shader)
    text = lineDiff(entries[0].shader->row.glsl, entries[1].shader->row.glsl);
  if (settings.json) {
    auto differences = nlohmann::json::object();
    for (const std::string& field : fields)
      differences[clean(field)] = {clean(valueOf(a, field)), clean(valueOf(b, field))};
    for (std::string& line : text) line = clean(line);
    print({{"state", differences}, {"glsl", text}});
  } else {
    for (const std::string& field : fields)
      fmt::print("{:18} {} -> {}\n", field, valueOf(a, field), valueOf(b, field));
    if (!text.empty()) fmt::print("\n");
    for (const std::string& line : text) {
      const char* const color = !settings.color  ? ""
                                : line[0] == '-' ? "\033[31m"
                                : line[0] == '+' ? "\033[32m"
                                                 : "";
      fmt::print("{}{}{}\n", color, line, *color ? "\033[0m" : "");
    }
  }
  return entries[0].id() == entries[1].id() ? kDone : kNo;
}

Status stats(const Settings& settings) {
  Contents contents;
  if (const Status status = read(settings.file, contents)) return status;
  size_t spirv = 0, glsl = 0, bad = 0, current = 0, kinds[4]{};
  int64_t compile = 0, saved = 0, create = 0;
  for (const Shader& shader : contents.shaders) {
    const cache::ShaderRow& row = shader.row;
    spirv += row.spirv.size() * 4;
    glsl += row.glsl.size();
    bad += !shader.why.empty();
    current += row.current();
    ++kinds[static_cast<int>(row.kind)];
    compile += row.compileMicroseconds;
    saved += row.compileMicroseconds * std::max<int64_t>(0, row.uses - 1);
  }
  for (const Pipeline& pipeline : contents.pipelines) {
    bad += !pipeline.why.empty();
    create += pipeline.row.createMicroseconds;
  }
  std::set<int64_t> programs;
  for (const cache::UsageRow& usage : contents.usage) programs.insert(usage.program.id);
  std::error_code ignored;
  const size_t file = std::filesystem::file_size(settings.file, ignored);
  if (settings.json) {
    print({{"file", settings.file},
           {"file_bytes", file},
           {"rows", contents.shaders.size()},
           {"bad", bad},
           {"current", current},
           {"vertex", kinds[0]},
           {"fragment", kinds[1]},
           {"own", kinds[2] + kinds[3]},
           {"pipelines", contents.pipelines.size()},
           {"programs", programs.size()},
           {"spirv_bytes", spirv},
           {"glsl_bytes", glsl},
           {"compile_us", compile},
           {"saved_us", saved},
           {"create_us", create},
           {"generator", cache::generatorVersion()}});
    return kDone;
  }
  fmt::print("{}: {}\n", settings.file, bytes(file));
  fmt::print("{} shaders: {} vertex, {} fragment, {} of the renderer's own; {} of another generator\n",
             contents.shaders.size(), kinds[0], kinds[1], kinds[2] + kinds[3],
             contents.shaders.size() - current);
  fmt::print("{} pipelines, needed by {} programs; {} bad rows\n", contents.pipelines.size(), programs.size(),
             bad);
  fmt::print("{} of SPIR-V, {} of GLSL\n", bytes(spirv), bytes(glsl));
  fmt::print("{} of compiling, {} saved so far; {} of making pipelines\n", milliseconds(compile),
             milliseconds(saved), milliseconds(create));
  return kDone;
}

}  // namespace anteroom::inspect
