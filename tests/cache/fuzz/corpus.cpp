// cache_fuzz_corpus FOLDER [ROUNDS]: writes good inputs of every kind to FOLDER, and, without a fuzzer, hands
// the target these and ROUNDS variations of each, the same in every run.
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "layer/cache/driver_blob.h"
#include "layer/cache/store.h"
#include "tests/cache/fuzz/target.h"

namespace {

using namespace anteroom;

std::string contents(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

template <class Bytes>
std::string text(const Bytes& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

struct Keys {
  gen::VertexKey vertex;
  gen::FragmentKey fragment;
};

Keys keysOf(bool rich) {
  gen::State state;
  state.attributes[gen::kPosition] = {true, static_cast<uint8_t>(rich ? 4 : 3), GL_FLOAT, {}};
  if (rich) {
    state.fog.enabled = state.lighting.enabled = state.alphaTest = true;
    state.alphaFunc = GL_LEQUAL;
    state.attributes[gen::kNormal].array = true;
    for (auto& light : state.lighting.lights) light.enabled = true;
  }
  const gen::FragmentKey fragment = gen::canonicaliseFragment(state, gen::Profile{});
  return {gen::canonicaliseVertex(state, fragment, gen::Profile{}), fragment};
}

const std::vector<uint32_t> kSpirv{0x07230203, 0x00010300, 0, 10, 0, 0x00030003, 2, 450, 0x00010000};
constexpr const char* kStates[] = {
    "primitive=triangles color=R8G8B8A8_UNORM depth=D24_UNORM_S8_UINT samples=4 dynamic=123v",
    "primitive=triangle-strip cull=back front=cw depth-test depth-write depth-func=lequal "
    "stencil-func=always "
    "logic-op=copy blend src-rgb=src-alpha dst-rgb=1-src-alpha src-alpha=1 write-mask=15 sample-mask=1 "
    "color=R8G8B8A8_UNORM samples=1 array0=R32G32B32_SFLOAT/12 array4=R32G32_SFLOAT/8"};

void fill(const std::filesystem::path& file) {
  cache::Store store;
  if (store.open(file, cache::Store::Mode::Create) != cache::Opened::Ok || !store.begin()) std::exit(1);
  for (const bool rich : {false, true}) {
    const Keys keys = keysOf(rich);
    cache::ShaderRow row =
        cache::makeRow(cache::KeyKind::Vertex, cache::bytesOf(keys.vertex), "glsl", kSpirv, 1);
    row.created = row.used = 1;
    store.put(row);
    row = cache::makeRow(cache::KeyKind::Fragment, cache::bytesOf(keys.fragment), "glsl", kSpirv, 1);
    row.created = row.used = 1;
    if (rich) row.generator = "another";
    store.put(row);
    cache::PipelineRow pipeline;
    pipeline.vertex = describe(keys.vertex);
    pipeline.fragment = describe(keys.fragment);
    pipeline.state = kStates[rich];
    store.put(pipeline);
    store.use(1, pipeline.id(), store.beginRun({1, "program"}, 1), rich);
  }
  if (!store.commit()) std::exit(1);
}

std::vector<std::string> corpus(const std::filesystem::path& folder) {
  std::vector<std::string> inputs;
  const auto add = [&](FuzzKind kind, const std::string& bytes) {
    inputs.push_back(std::string(1, kind) + bytes);
  };
  const auto file = folder / "made";
  fill(file);
  add(kFuzzDatabase, contents(file));
  for (const char* suffix : {"", "-wal", "-shm"}) std::filesystem::remove(file.string() + suffix);
  cache::writeDriverBlob(file, std::as_bytes(std::span(kSpirv)));
  add(kFuzzBlob, contents(file));
  std::filesystem::remove(file);
  for (const bool rich : {false, true}) {
    const Keys keys = keysOf(rich);
    add(kFuzzWords, describe(keys.vertex));
    add(kFuzzWords, describe(keys.fragment));
    add(kFuzzVertexKey, text(cache::bytesOf(keys.vertex)));
    add(kFuzzFragmentKey, text(cache::bytesOf(keys.fragment)));
  }
  for (const char* state : kStates) add(kFuzzState, state);
  add(kFuzzSpirv, text(std::as_bytes(std::span(kSpirv))));
  return inputs;
}

void vary(std::string& input, std::mt19937& random) {
  const auto below = [&](size_t n) { return static_cast<size_t>(random() % n); };
  for (size_t i = 0; i <= below(3); ++i) {
    if (input.size() < 2) return;
    const size_t at = 1 + below(input.size() - 1);
    switch (below(4)) {
      case 0:
        input[at] = static_cast<char>(random());
        break;
      case 1:
        input[at] = static_cast<char>(input[at] ^ (1 << below(8)));
        break;
      case 2:
        input.erase(at, 1 + below(16));
        break;
      default:
        input.insert(at, input.substr(1 + below(input.size() - 1), 1 + below(24)));
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  const std::vector<std::string> inputs = corpus(folder);
  for (size_t i = 0; i < inputs.size(); ++i)
    std::ofstream(folder / ("input" + std::to_string(i)), std::ios::binary) << inputs[i];
  const int rounds = argc > 2 ? std::atoi(argv[2]) : 0;
  std::mt19937 random(1);
  for (int round = 0; round < rounds; ++round)
    for (std::string input : inputs) {
      if (round > 0) vary(input, random);
      LLVMFuzzerTestOneInput(reinterpret_cast<const uint8_t*>(input.data()), input.size());
    }
  return 0;
}
