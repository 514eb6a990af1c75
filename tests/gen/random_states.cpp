// Two thousand states that GL can be in: each gives valid keys, text that compiles, and constants that fit.
#include <gtest/gtest.h>

#include <chrono>
#include <map>
#include <regex>
#include <set>
#include <thread>

#include "tests/gen/states.h"
#include "tests/gen/validated.h"

namespace anteroom::gen {
namespace {

constexpr int kStates = 2000;

Profile randomProfile(RandomStates& random) {
  return {!random.coin(4), !random.coin(8)};
}

std::set<int> inputLocations(const std::string& glsl) {
  std::set<int> locations;
  const std::regex input(R"(layout\(location = (\d+)\) (flat )?in )");
  for (std::sregex_iterator it(glsl.begin(), glsl.end(), input), end; it != end; ++it)
    locations.insert(std::stoi((*it)[1]));
  return locations;
}

std::set<std::string> interfaceOf(const std::string& glsl, const std::string& direction) {
  std::set<std::string> members;
  const std::regex declaration("layout\\(location = (\\d+)\\) (flat )?" + direction + " (\\w+) (\\w+);");
  for (std::sregex_iterator it(glsl.begin(), glsl.end(), declaration), end; it != end; ++it)
    members.insert((*it)[1].str() + " " + (*it)[3].str() + " " + (*it)[4].str());
  return members;
}

uint32_t maskOf(const std::set<int>& locations) {
  uint32_t mask = 0;
  for (int location : locations) mask |= 1u << location;
  return mask;
}

uint32_t sampledIn(const std::string& glsl) {
  uint32_t mask = 0;
  const std::regex sampler(R"(layout\(set = 1, binding = (\d+)\) uniform sampler)");
  for (std::sregex_iterator it(glsl.begin(), glsl.end(), sampler), end; it != end; ++it)
    mask |= 1u << std::stoi((*it)[1]);
  return mask;
}

TEST(RandomStates, KeysAreValidAndMatchTheirText) {
  RandomStates random(1);
  for (int i = 0; i < kStates; ++i) {
    const State state = random.next();
    const Keys keys = keysOf(state, randomProfile(random));
    ASSERT_TRUE(valid(keys.fragment)) << i << ' ' << describe(keys.fragment);
    ASSERT_TRUE(valid(keys.vertex)) << i << ' ' << describe(keys.vertex);
    const std::string vertex = emitVertex(keys.vertex), fragment = emitFragment(keys.fragment);
    ASSERT_EQ(maskOf(inputLocations(vertex)), attributesRead(keys.vertex)) << vertex;
    ASSERT_EQ(sampledIn(fragment), unitsSampled(keys.fragment)) << fragment;
    // What the fragment stage reads, the vertex stage writes, and nothing else.
    std::set<std::string> read = interfaceOf(fragment, "in");
    ASSERT_EQ(interfaceOf(vertex, "out"), read) << vertex << fragment;
  }
}

// The first compile of a process builds glslang's tables: here many threads ask for it at once.
TEST(RandomStates, AnyThreadCompiles) {
  const Keys keys = keysOf(litState(2));
  const std::string glsl = emitVertex(keys.vertex);
  std::array<CompileResult, 4> results;
  std::vector<std::thread> threads;
  for (CompileResult& result : results) threads.emplace_back([&] { result = compile(Stage::Vertex, glsl); });
  for (std::thread& thread : threads) thread.join();
  for (const CompileResult& result : results) {
    EXPECT_FALSE(result.spirv.empty()) << result.log;
    EXPECT_EQ(result.spirv, results[0].spirv);
  }
}

TEST(RandomStates, EveryShaderCompiles) {
  RandomStates random(2);
  warmCompiler();
  std::set<std::string> seen;
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < kStates; ++i) {
    const Keys keys = keysOf(random.next(), randomProfile(random));
    const std::string vertex = emitVertex(keys.vertex), fragment = emitFragment(keys.fragment);
    if (seen.insert(vertex).second) {
      expectCompiles(Stage::Vertex, vertex);
    }
    if (seen.insert(fragment).second) {
      expectCompiles(Stage::Fragment, fragment);
    }
  }
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  RecordProperty("shaders", static_cast<int>(seen.size()));
  RecordProperty("millisecondsEach", std::to_string(time.count() / static_cast<double>(seen.size())));
}

// What a block or a key does not name among its groups may change without making it stale.
TEST(RandomStates, OnlyMarkedGroupsChangeConstants) {
  using Copy = void (*)(State&, const State&);
  const std::vector<std::pair<Groups, Copy>> groups = {
      {kGroupModelview, [](State& to, const State& from) { to.modelview = from.modelview; }},
      {kGroupProjection, [](State& to, const State& from) { to.projection = from.projection; }},
      {kGroupCurrentColor,
       [](State& to, const State& from) { to.attributes[kColor].current = from.attributes[kColor].current; }},
      {kGroupCurrentOther,
       [](State& to, const State& from) {
         to.attributes[kNormal].current = from.attributes[kNormal].current;
         for (int u = 0; u < kMaxTextureUnits; ++u)
           to.attributes[texCoord(u)].current = from.attributes[texCoord(u)].current;
       }},
      {kGroupLighting, [](State& to, const State& from) { to.lighting = from.lighting; }},
      {kGroupFog, [](State& to, const State& from) { to.fog = from.fog; }},
      {kGroupClipPlanes, [](State& to, const State& from) { to.clipPlanes = from.clipPlanes; }},
      {kGroupPoints, [](State& to, const State& from) { to.points = from.points; }},
      {kGroupAlphaTest, [](State& to, const State& from) { to.alphaRef = from.alphaRef; }},
      {kGroupTextureMatrix,
       [](State& to, const State& from) {
         for (int u = 0; u < kMaxTextureUnits; ++u) to.units[u].matrix = from.units[u].matrix;
       }},
      {kGroupTextures,
       [](State& to, const State& from) {
         for (int u = 0; u < kMaxTextureUnits; ++u) to.units[u].env.color = from.units[u].env.color;
       }},
      {kGroupFramebuffer, [](State& to, const State& from) { to.alphaBits = from.alphaBits; }},
      {kGroupPalette,
       [](State& to, const State& from) {
         if (to.palette && from.palette) to.palette = from.palette;
       }},
  };
  RandomStates random(3);
  const auto packed = [](auto pack, const auto& key, const State& state, uint32_t size) {
    std::vector<std::byte> bytes(size);
    pack(key, state, bytes.data());
    return bytes;
  };
  std::map<Groups, int> changes;
  for (int i = 0; i < 400; ++i) {
    const State before = random.next(), other = random.next();
    const Keys keys = keysOf(before);
    const Blocks b = blocks(keys.vertex, keys.fragment);
    for (const auto& [group, copy] : groups) {
      State after = before;
      copy(after, other);
      const Keys changed = keysOf(after);
      if (!(group & keyGroups())) {
        ASSERT_TRUE(changed.vertex == keys.vertex && changed.fragment == keys.fragment) << group;
      }
      if (!(changed.vertex == keys.vertex && changed.fragment == keys.fragment)) continue;
      const auto check = [&](auto pack, const auto& key, uint32_t size, Groups stale) {
        const bool differs = packed(pack, key, before, size) != packed(pack, key, after, size);
        changes[group] += differs;
        if (differs) {
          EXPECT_TRUE(stale & group) << "group " << group << '\n' << describe(key);
        }
      };
      check(packPush, keys.vertex, b.pushSize, b.pushGroups);
      check(packVertex, keys.vertex, b.vertexSize, b.vertexGroups);
      check(packFragment, keys.fragment, b.fragmentSize, b.fragmentGroups);
      check(packPalette, keys.vertex, b.paletteSize, b.paletteGroups);
    }
  }
  for (const auto& [group, copy] : groups) EXPECT_GT(changes[group], 0) << "never tried: group " << group;
}

}  // namespace
}  // namespace anteroom::gen
