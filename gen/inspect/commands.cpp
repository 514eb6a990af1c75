#include "gen/inspect/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <functional>
#include <set>
#include <spirv-tools/libspirv.hpp>
#include <sstream>

#include "gen/cache/generator_version.h"
#include "gen/inspect/words.h"

namespace anteroom::inspect {
namespace {

constexpr int kDecimals = 2;

void print(const nlohmann::json& json) {
  fmt::print("{}\n", json.dump(kDecimals));
}

Status find(const Settings& settings, const std::vector<std::string>& names, std::vector<Listed>& found) {
  std::vector<Listed> rows;
  if (const Status status = readRows(settings.file, rows)) return status;
  for (const std::string& wanted : names) {
    std::vector<const Listed*> matches;
    for (const Listed& row : rows)
      if (!wanted.empty() && name(row.id).starts_with(wanted)) matches.push_back(&row);
    if (matches.size() != 1) {
      fmt::print(stderr, "anteroom-cache: {} {}; `anteroom-cache list` shows the keys\n",
                 matches.empty() ? "no key begins with" : "more than one key begins with", wanted);
      return kNo;
    }
    found.push_back(*matches[0]);
  }
  return kDone;
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

std::string valueOf(const std::map<std::string, std::string>& state, const std::string& field) {
  const auto found = state.find(field);
  return found == state.end() ? "-" : found->second;
}

}  // namespace

Status open(const std::string& file, gen::Store::Mode mode, gen::Store& store) {
  const auto say = [&](Status status, const std::string& what) {
    fmt::print(stderr, "anteroom-cache: {} {}\n", file, what);
    return status;
  };
  switch (store.open(file, mode, 2000)) {
    case gen::Opened::Ok:
      return kDone;
    case gen::Opened::Missing:
      return say(kMissing, "does not exist; a program that draws makes it");
    case gen::Opened::Foreign:
      return say(kNotACache, "is not a shader cache");
    case gen::Opened::Newer:
      return say(kNotACache, "was made by a newer version of Anteroom");
    case gen::Opened::Damaged:
      return say(kNotACache,
                 "is no shader cache, or a damaged one; the next program that draws begins it again");
    case gen::Opened::Unusable:
      break;
  }
  return say(kUnusable, "cannot be opened: " + store.message());
}

Status readRows(const std::string& file, std::vector<Listed>& rows) {
  gen::Store store;
  if (const Status status = open(file, gen::Store::Mode::Read, store)) return status;
  const bool whole = store.visit([&](int64_t id, gen::Row& row, const std::string& why) {
    rows.push_back({id, std::move(row), why});
  });
  if (whole) return kDone;
  fmt::print(stderr, "anteroom-cache: {} is damaged after {} rows: {}\n", file, rows.size(), store.message());
  return kNotACache;
}

Status list(const Settings& settings, const std::string& sort, size_t most) {
  std::vector<Listed> rows;
  if (const Status status = readRows(settings.file, rows)) return status;
  const auto weight = [&](const Listed& row) -> int64_t {
    if (sort == "compile") return row.row.compileMicroseconds;
    if (sort == "size") return static_cast<int64_t>(row.row.spirv.size());
    if (sort == "age") return -row.row.created;
    return row.row.uses;
  };
  std::stable_sort(rows.begin(), rows.end(),
                   [&](const Listed& a, const Listed& b) { return weight(a) > weight(b); });
  if (most && rows.size() > most) rows.resize(most);
  if (settings.json) {
    auto json = nlohmann::json::array();
    for (const Listed& row : rows) json.push_back(toJson(row.id, row.row, row.why, false));
    print(json);
    return kDone;
  }
  fmt::print("{:16} {:>6} {:>9} {:>9} {:>8}  {}\n", "key", "uses", "compile", "SPIR-V", "age", "state");
  for (const auto& [id, row, why] : rows)
    fmt::print("{} {:>6} {:>6.2f} ms {:>9} {:>8}  {}\n", name(id), row.uses,
               static_cast<double>(row.compileMicroseconds) / 1000, bytes(row.spirv.size() * 4),
               ago(row.created), why.empty() ? row.description : "bad: " + why);
  return kDone;
}

Status show(const Settings& settings, const std::string& key) {
  std::vector<Listed> found;
  if (const Status status = find(settings, {key}, found)) return status;
  const auto& [id, row, why] = found[0];
  std::string assembly;
  spvtools::SpirvTools(SPV_ENV_VULKAN_1_1)
      .Disassemble(row.spirv, &assembly,
                   SPV_BINARY_TO_TEXT_OPTION_FRIENDLY_NAMES | SPV_BINARY_TO_TEXT_OPTION_INDENT);
  if (settings.json) {
    auto json = toJson(id, row, why, true);
    json["assembly"] = assembly;
    print(json);
    return why.empty() ? kDone : kNo;
  }
  fmt::print("key        {} ({})\n", name(id), kindName(row.kind));
  if (!why.empty()) fmt::print("bad        {}\n", why);
  fmt::print("generator  {}{}\n", row.generator,
             row.generator == gen::generatorVersion() ? "" : " (another: it will be compiled again)");
  fmt::print("uses       {}, last {} ago, made {} ago\n", row.uses, ago(row.used), ago(row.created));
  fmt::print("compile    {:.2f} ms\n", static_cast<double>(row.compileMicroseconds) / 1000);
  fmt::print("size       {} of GLSL, {} of SPIR-V\n", bytes(row.glsl.size()), bytes(row.spirv.size() * 4));
  fmt::print("state\n");
  for (const auto& [field, value] : state(row)) fmt::print("  {:18} {}\n", field, value);
  fmt::print("\n{}\n{}", row.glsl, assembly);
  return why.empty() ? kDone : kNo;
}

Status diff(const Settings& settings, const std::string& first, const std::string& second) {
  std::vector<Listed> found;
  if (const Status status = find(settings, {first, second}, found)) return status;
  const auto a = state(found[0].row), b = state(found[1].row);
  std::set<std::string> fields;
  for (const auto& states : {a, b})
    for (const auto& [field, value] : states) fields.insert(field);
  std::erase_if(fields, [&](const std::string& field) { return valueOf(a, field) == valueOf(b, field); });
  const auto text = lineDiff(found[0].row.glsl, found[1].row.glsl);
  if (settings.json) {
    auto differences = nlohmann::json::object();
    for (const std::string& field : fields) differences[field] = {valueOf(a, field), valueOf(b, field)};
    print({{"state", differences}, {"glsl", text}});
  } else {
    for (const std::string& field : fields)
      fmt::print("{:18} {} -> {}\n", field, valueOf(a, field), valueOf(b, field));
    fmt::print("\n");
    for (const std::string& line : text) fmt::print("{}\n", line);
  }
  return found[0].id == found[1].id ? kDone : kNo;
}

Status stats(const Settings& settings) {
  std::vector<Listed> rows;
  if (const Status status = readRows(settings.file, rows)) return status;
  size_t spirv = 0, glsl = 0, bad = 0, current = 0, kinds[4]{};
  int64_t compile = 0, saved = 0;
  for (const auto& [id, row, why] : rows) {
    spirv += row.spirv.size() * 4;
    glsl += row.glsl.size();
    bad += !why.empty();
    current += row.generator == gen::generatorVersion();
    ++kinds[static_cast<int>(row.kind)];
    compile += row.compileMicroseconds;
    saved += row.compileMicroseconds * std::max<int64_t>(0, row.uses - 1);
  }
  std::error_code ignored;
  const size_t file = std::filesystem::file_size(settings.file, ignored);
  if (settings.json) {
    print({{"file", settings.file},
           {"file_bytes", file},
           {"rows", rows.size()},
           {"bad", bad},
           {"current", current},
           {"vertex", kinds[0]},
           {"fragment", kinds[1]},
           {"own", kinds[2] + kinds[3]},
           {"spirv_bytes", spirv},
           {"glsl_bytes", glsl},
           {"compile_us", compile},
           {"saved_us", saved},
           {"generator", gen::generatorVersion()}});
    return kDone;
  }
  fmt::print("{}: {}\n", settings.file, bytes(file));
  fmt::print(
      "{} shaders: {} vertex, {} fragment, {} of the renderer's own; {} bad, {} of another generator\n",
      rows.size(), kinds[0], kinds[1], kinds[2] + kinds[3], bad, rows.size() - current);
  fmt::print("{} of SPIR-V, {} of GLSL\n", bytes(spirv), bytes(glsl));
  fmt::print("{:.1f} ms of compiling, {:.1f} ms saved so far\n", static_cast<double>(compile) / 1000,
             static_cast<double>(saved) / 1000);
  return kDone;
}

// For each piece of state: how many shaders there would be if it did not matter.
Status explain(const Settings& settings) {
  std::vector<Listed> rows;
  if (const Status status = readRows(settings.file, rows)) return status;
  auto json = nlohmann::json::object();
  for (const gen::KeyKind kind : {gen::KeyKind::Vertex, gen::KeyKind::Fragment}) {
    std::vector<std::map<std::string, std::string>> states;
    std::set<std::string> fields;
    for (const Listed& row : rows)
      if (row.row.kind == kind && row.why.empty()) states.push_back(state(row.row));
    for (const auto& one : states)
      for (const auto& [field, value] : one) fields.insert(field);
    struct Split {
      std::string field;
      size_t without;
      std::map<std::string, size_t> values;
    };
    std::vector<Split> splits;
    for (const std::string& field : fields) {
      Split split{field, 0, {}};
      std::set<std::map<std::string, std::string>> rest;
      for (auto one : states) {
        ++split.values[valueOf(one, field)];
        one.erase(field);
        rest.insert(std::move(one));
      }
      split.without = rest.size();
      if (split.values.size() > 1) splits.push_back(std::move(split));
    }
    std::stable_sort(splits.begin(), splits.end(),
                     [](const Split& a, const Split& b) { return a.without < b.without; });
    auto& list = json[kindName(kind)] = {{"shaders", states.size()}, {"splits", nlohmann::json::array()}};
    for (const Split& split : splits)
      list["splits"].push_back(
          {{"state", split.field}, {"shaders_without", split.without}, {"values", split.values}});
    if (settings.json) continue;
    fmt::print("{} {} shaders\n", states.size(), kindName(kind));
    for (const Split& split : splits) {
      fmt::print("  {:18} {} without it:", split.field, split.without);
      for (const auto& [value, count] : split.values) fmt::print(" {} ({})", value, count);
      fmt::print("\n");
    }
  }
  if (settings.json) print(json);
  return kDone;
}

}  // namespace anteroom::inspect
