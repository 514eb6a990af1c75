// The page of `report`: a template, and everything it shows as JSON inside of it.
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <map>

#include "layer/cache/generator_version.h"
#include "layer/tools/cache/change.h"
#include "layer/tools/cache/highlight.h"
#include "layer/tools/cache/report_page.h"
#include "layer/tools/cache/words.h"

namespace anteroom::inspect {
namespace {

constexpr std::string_view kData = "<!--data-->";

nlohmann::json page(const Settings& settings, const Contents& contents) {
  auto shaders = nlohmann::json::array(), pipelines = nlohmann::json::array();
  for (const Shader& shader : contents.shaders) {
    auto entry = toJson(shader, true);
    entry["html"] = htmlGlsl(clean(shader.row.glsl));
    entry.erase("glsl");
    shaders.push_back(std::move(entry));
  }
  std::map<int64_t, std::vector<std::string>> programs;
  for (const cache::UsageRow& usage : contents.usage) {
    auto& names = programs[usage.pipeline];
    const std::string program = clean(usage.program.name);
    if (std::find(names.begin(), names.end(), program) == names.end()) names.push_back(program);
  }
  for (const Pipeline& pipeline : contents.pipelines) {
    auto entry = toJson(pipeline, true);
    entry["programs"] = programs[pipeline.id];
    pipelines.push_back(std::move(entry));
  }
  std::error_code ignored;
  return {{"file", settings.file},      {"file_bytes", std::filesystem::file_size(settings.file, ignored)},
          {"made", std::time(nullptr)}, {"generator", cache::generatorVersion()},
          {"shaders", shaders},         {"pipelines", pipelines}};
}

}  // namespace

Status report(const Settings& settings, const std::string& to) {
  Contents contents;
  if (const Status status = read(settings.file, contents)) return status;
  std::string data = page(settings, contents).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  // No text may end the element that holds it.
  for (size_t at = 0; (at = data.find('<', at)) != std::string::npos;) data.replace(at, 1, "\\u003c");
  std::string text = reportPage();
  text.replace(text.find(kData), kData.size(), data);
  if (to == "-") {
    fmt::print("{}", text);
    return kDone;
  }
  if (const Status status = write(to, text)) return status;
  if (settings.json)
    fmt::print("{}\n", nlohmann::json{{"file", to},
                                      {"shaders", contents.shaders.size()},
                                      {"pipelines", contents.pipelines.size()}}
                           .dump(2));
  return kDone;
}

}  // namespace anteroom::inspect
