// anteroom-cache: answers, exit statuses, and caches that travel.
#include <nlohmann/json.hpp>

#include "tests/cache/rows.h"

namespace anteroom::test {
namespace {

using nlohmann::json;

// Two fragment shaders that fog tells apart, and their vertex shader; compiled, not invented.
class Tool : public testing::Test {
 protected:
  void SetUp() override {
    gen::State state;
    state.attributes[gen::kPosition].array = true;
    cache::ShaderCache cache(folder_.file(), kNoLimit);
    for (bool fog : {false, true}) {
      state.fog.enabled = fog;
      const auto fragment = gen::canonicaliseFragment(state, gen::Profile{});
      add(cache, cache::KeyKind::Fragment, cache::bytesOf(fragment));
      const auto vertex = gen::canonicaliseVertex(state, fragment, gen::Profile{});
      add(cache, cache::KeyKind::Vertex, cache::bytesOf(vertex));
      cache::PipelineRow pipeline;
      pipeline.vertex = describe(vertex);
      pipeline.fragment = describe(fragment);
      pipeline.state = "primitive=triangles color=R8G8B8A8_UNORM samples=1 dynamic=123v";
      cache.use(pipeline);
    }
  }

  static void add(cache::ShaderCache& cache, cache::KeyKind kind, cache::KeyBytes key) {
    const std::string glsl = cache::emit(kind, key);
    cache.store(kind, key, glsl, gen::compile(cache::stageOf(kind), glsl).spirv, 1);
  }

  Output tool(std::vector<std::string> arguments) { return toolOn(folder_.file(), std::move(arguments)); }
  Output toolOn(const std::string& file, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"--json", "--file", file});
    return runProgram(CACHE_TOOL, {}, arguments);
  }
  void damage(const char* sql) {
    cache::Database database;
    ASSERT_EQ(database.open(folder_.file(), SQLITE_OPEN_READWRITE, 1000), SQLITE_OK);
    ASSERT_EQ(database.run(sql), SQLITE_OK);
  }

  Folder folder_;
};

TEST_F(Tool, ListsShowsAndCompares) {
  const json rows = json::parse(tool({"list"}).out);
  ASSERT_EQ(rows.size(), 4u);
  std::vector<std::string> fragments;
  for (const json& row : rows)
    if (row["kind"] == "fragment") fragments.push_back(row["key"]);
  ASSERT_EQ(fragments.size(), 2u);
  const Output shown = tool({"show", fragments[0].substr(0, 8)});
  EXPECT_EQ(shown.status, 0);
  EXPECT_NE(json::parse(shown.out)["glsl"].get<std::string>().find("void main()"), std::string::npos);
  EXPECT_NE(json::parse(shown.out)["assembly"].get<std::string>().find("OpEntryPoint"), std::string::npos);
  const Output compared = tool({"diff", fragments[0], fragments[1]});
  EXPECT_EQ(compared.status, 1);
  EXPECT_TRUE(json::parse(compared.out)["state"].contains("fog")) << compared.out;
  EXPECT_EQ(tool({"diff", fragments[0], fragments[0]}).status, 0);
  const json why = json::parse(tool({"explain"}).out)["fragment"];
  EXPECT_EQ(why["shaders"], 2);
  EXPECT_EQ(why["splits"][0]["state"], "fog");
  EXPECT_EQ(why["splits"][0]["shaders_without"], 1);
  EXPECT_EQ(json::parse(tool({"stats"}).out)["rows"], 4);
}

TEST_F(Tool, ShowsAndExplainsPipelines) {
  const json rows = json::parse(tool({"list", "--pipelines"}).out);
  ASSERT_EQ(rows.size(), 2u);
  const std::string first = rows[0]["key"], second = rows[1]["key"];
  const json shown = json::parse(tool({"show", first}).out);
  EXPECT_EQ(shown["topics"]["framebuffer"], "color=R8G8B8A8_UNORM samples=1");
  EXPECT_EQ(tool({"show", shown["vertex_key"]}).status, 0);
  const Output compared = tool({"diff", first, second});
  EXPECT_EQ(compared.status, 1);
  EXPECT_EQ(json::parse(compared.out)["state"].size(), 1u) << compared.out;
  const json why = json::parse(tool({"explain", "--program", "tools_tests"}).out)["pipeline"];
  EXPECT_EQ(why["pipelines"], 2);
  EXPECT_EQ(why["splits"][0]["state"], "fog");
  EXPECT_EQ(why["splits"][0]["pipelines_without"], 1);
  const Output none = tool({"explain", "--program", "nobody"});
  EXPECT_EQ(none.status, 1);
  EXPECT_NE(none.err.find("tools_tests"), std::string::npos) << none.err;
}

TEST_F(Tool, WarmsWhatAnotherGeneratorLeft) {
  damage(
      "UPDATE shader SET generator = 'another', number = number + 1, id = id + 1, key = x'00', checksum = 0");
  const Output warmed = tool({"warm"});
  const json answer = json::parse(warmed.out);
  EXPECT_EQ(warmed.status, 0) << warmed.err;
  EXPECT_EQ(answer["compiled"], 4) << warmed.out;
  EXPECT_EQ(answer["pipelines"].get<int>() + answer["others"].get<int>(), 2) << warmed.out;
  const json again = json::parse(tool({"warm"}).out);
  EXPECT_EQ(again["compiled"], 0);
  EXPECT_EQ(again["known"], 4);
}

TEST_F(Tool, ColorsForTerminalsAndThoseWhoAsk) {
  const json rows = json::parse(tool({"list"}).out);
  const auto show = [&](const char* color) {
    return runProgram(CACHE_TOOL, {"NO_COLOR=1"},
                      {"--file", folder_.file(), "show", "--color", color, rows[0]["key"].get<std::string>()})
        .out;
  };
  std::string colored = show("always");
  EXPECT_NE(colored.find("\033[34m"), std::string::npos);
  EXPECT_EQ(show("auto").find('\033'), std::string::npos);
  for (size_t at; (at = colored.find('\033')) != std::string::npos;)
    colored.erase(at, colored.find('m', at) - at + 1);
  EXPECT_EQ(colored, show("never")) << "colors change no letter";
}

TEST_F(Tool, VerifiesAndRepairs) {
  EXPECT_EQ(tool({"verify"}).status, 0);
  damage(
      "UPDATE shader SET checksum = 1 WHERE id = (SELECT min(id) FROM shader);"
      "UPDATE shader SET glsl = 'void' WHERE id = (SELECT max(id) FROM shader);");
  const Output bad = tool({"verify"});
  EXPECT_EQ(bad.status, 1);
  EXPECT_EQ(json::parse(bad.out)["bad"], 2);
  EXPECT_EQ(tool({"verify", "--repair"}).status, 0);
  EXPECT_EQ(tool({"verify"}).status, 0);
  damage("UPDATE shader SET key = x'ff'");
  damage("UPDATE pipeline SET state = 'x'");
  EXPECT_EQ(json::parse(tool({"prune"}).out)["removed"], 6);
}

TEST_F(Tool, CachesTravel) {
  const std::string keys = folder_.path / "keys.json", there = folder_.path / "there" / "b.db",
                    both = folder_.path / "c.db";
  EXPECT_EQ(tool({"export", keys}).status, 0);
  EXPECT_EQ(json::parse(toolOn(there, {"import", keys}).out)["imported"], 4);
  EXPECT_EQ(toolOn(there, {"verify"}).status, 0);
  EXPECT_EQ(json::parse(toolOn(both, {"merge", there, folder_.file()}).out)["merged"], 12);
  EXPECT_EQ(json::parse(toolOn(both, {"stats"}).out)["rows"], 4);
  // The program that needed them is known there, too.
  const json here = json::parse(tool({"stats"}).out), stats = json::parse(toolOn(there, {"stats"}).out);
  EXPECT_EQ(stats["pipelines"], 2);
  EXPECT_EQ(stats["programs"], here["programs"]);
  EXPECT_EQ(json::parse(toolOn(there, {"list"}).out).size(), 4u);
  replace(keys,
          R"({"format": "anteroom-cache-keys", "version": 1, "keys": [1, {"kind": "vertex", "key": "x"}]})");
  const Output refused = toolOn(there, {"import", keys});
  EXPECT_EQ(refused.status, 1);
  EXPECT_EQ(json::parse(refused.out)["refused"], 2);
}

TEST_F(Tool, SaysWhatIsWrong) {
  EXPECT_EQ(toolOn(folder_.path / "none.db", {"list"}).status, 3);
  EXPECT_EQ(tool({"show", "nothing"}).status, 1);
  EXPECT_EQ(tool({"bogus"}).status, 2);
  replace(folder_.path / "text", std::string(4096, 'x'));
  const Output foreign = toolOn(folder_.path / "text", {"list"});
  EXPECT_EQ(foreign.status, 4);
  EXPECT_NE(foreign.err.find("no shader cache"), std::string::npos) << foreign.err;
  EXPECT_EQ(toolOn(folder_.path / "text", {"import", folder_.path / "text"}).status, 4);
  damage("PRAGMA user_version = 9");
  const Output newer = tool({"stats"});
  EXPECT_EQ(newer.status, 4);
  EXPECT_NE(newer.err.find("newer"), std::string::npos) << newer.err;
}

}  // namespace
}  // namespace anteroom::test
