// All that is read from the files of the cache, as bytes that anybody may have written. The first byte says
// what the rest is.
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "layer/cache/driver_blob.h"
#include "layer/cache/spirv_check.h"
#include "layer/cache/store.h"
#include "layer/vulkan/pipelines/driver_cache.h"
#include "layer/vulkan/pipelines/pipeline_words.h"
#include "tests/cache/fuzz/target.h"

namespace {

using namespace anteroom;

void must(bool good) {
  if (!good) std::abort();
}

// In memory, where that can be.
const std::filesystem::path& scratch() {
  static const std::filesystem::path file = [] {
    std::string name = access("/dev/shm", W_OK) ? "/tmp/cache-fuzz-XXXXXX" : "/dev/shm/cache-fuzz-XXXXXX";
    must(mkdtemp(name.data()));
    static const std::filesystem::path folder = name;
    std::atexit([] {
      std::error_code ignored;
      std::filesystem::remove_all(folder, ignored);
    });
    return folder / "anteroom.db";
  }();
  return file;
}

void placeScratch(const std::string& bytes) {
  for (const char* suffix : {"-wal", "-shm", "-journal"}) unlink((scratch().string() + suffix).c_str());
  std::ofstream(scratch(), std::ios::binary | std::ios::trunc) << bytes;
}

template <class Key>
void useKey(const Key& key) {
  Key again;
  must(parse(describe(key), again) && key == again);
  if constexpr (std::is_same_v<Key, gen::VertexKey>)
    must(!gen::emitVertex(key).empty());
  else
    must(!gen::emitFragment(key).empty());
}

void database(const std::string& bytes) {
  placeScratch(bytes);
  cache::Store store;
  if (store.open(scratch(), cache::Store::Mode::Read) == cache::Opened::Ok) {
    store.holdsCurrent();
    std::vector<uint32_t> spirv;
    store.visitShaders([&](int64_t, int64_t, cache::ShaderRow& row, const std::string& why) {
      if (!why.empty() || row.currentKey().empty()) return;
      const std::vector<std::byte> key = row.currentKey();
      must(!cache::emit(row.kind, key).empty());
    });
    store.visitPipelines([](int64_t, cache::PipelineRow&, const std::string&) {});
    int64_t program = 0;
    store.visitUsage([&](const cache::UsageRow& row) { program = row.program.id; });
    must(store.usual(program, 256).size() <= 256);
    const std::string key = "#version 450\n// 0\n";
    store.find(cache::KeyKind::VertexText, std::as_bytes(std::span(key)), spirv);
  }
  // As a program goes on.
  if (store.open(scratch(), cache::Store::Mode::Create) != cache::Opened::Ok || !store.begin()) return;
  const std::string text = "#version 450\n// fuzz\n";
  const std::vector<uint32_t> spirv{0x07230203, 0x00010300, 0, 10, 0, 0x00010000};
  const cache::ShaderRow row =
      cache::makeRow(cache::KeyKind::VertexText, std::as_bytes(std::span(text)), text, spirv, 1);
  const bool good =
      store.put(row) && store.beginRun({1, "fuzz"}, 1) > 0 && store.shrink(20000) >= 0 && store.commit();
  if (!good) store.rollback();
}

void blob(const std::string& bytes) {
  placeScratch(bytes);
  const std::vector<std::byte> read = cache::readDriverBlob(scratch());
  VkPhysicalDeviceProperties device{};
  vulkan::madeBy(std::as_bytes(std::span(bytes)), device);
  vulkan::madeBy(read, device);
}

void words(const std::string& text) {
  for (const gen::Stage stage : {gen::Stage::Vertex, gen::Stage::Fragment}) {
    cache::KeyKind kind;
    std::vector<std::byte> key;
    if (cache::keyOf(stage, text, kind, key)) must(!cache::emit(kind, key).empty());
  }
  gen::VertexKey vertex;
  gen::FragmentKey fragment;
  if (parse(text, vertex)) useKey(vertex);
  if (parse(text, fragment)) useKey(fragment);
}

template <class Key>
void keyBytes(const std::string& bytes) {
  Key key{};
  std::memcpy(&key, bytes.data(), std::min(bytes.size(), sizeof key));
  if (valid(key)) useKey(key);
}

void state(const std::string& text) {
  vulkan::PipelineKey key, again;
  vulkan::DynamicStates dynamic;
  if (!vulkan::parse(text, key, dynamic)) return;
  vulkan::Features features;
  features.dynamicState1 = dynamic.state1;
  features.dynamicState2 = dynamic.state2;
  features.dynamicState3 = dynamic.state3;
  features.dynamicVertexInput = dynamic.vertexInput;
  must(vulkan::parse(vulkan::describe(key, features), again, dynamic) && key == again);
  gen::VertexKey vertex{};
  vertex.fetch[gen::kPosition] = gen::Fetch::Float;
  vulkan::feeds(key.layout, vertex, gen::FragmentKey{});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) return 0;
  const std::string rest(reinterpret_cast<const char*>(data) + 1, size - 1);
  switch (static_cast<char>(data[0])) {
    case kFuzzDatabase:
      database(rest);
      break;
    case kFuzzBlob:
      blob(rest);
      break;
    case kFuzzWords:
      words(rest);
      break;
    case kFuzzVertexKey:
      keyBytes<anteroom::gen::VertexKey>(rest);
      break;
    case kFuzzFragmentKey:
      keyBytes<anteroom::gen::FragmentKey>(rest);
      break;
    case kFuzzSpirv:
      anteroom::cache::plausibleSpirv(std::as_bytes(std::span(rest)));
      break;
    case kFuzzState:
      state(rest);
      break;
    default:
      break;
  }
  return 0;
}
