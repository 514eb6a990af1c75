#include "layer/tools/cache/change.h"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <fstream>

namespace anteroom::inspect {

std::optional<cache::ShaderRow> compiled(cache::KeyKind kind, cache::KeyBytes key) {
  const auto start = std::chrono::steady_clock::now();
  std::string glsl = cache::emit(kind, key);
  gen::CompileResult result = gen::compile(cache::stageOf(kind), glsl);
  const auto time = std::chrono::steady_clock::now() - start;
  if (result.spirv.empty()) return {};
  return cache::makeRow(kind, key, std::move(glsl), std::move(result.spirv),
                        std::chrono::duration_cast<std::chrono::microseconds>(time).count());
}

Status finish(cache::Store& store, const Settings& settings, bool good) {
  if (good && store.commit()) return kDone;
  fmt::print(stderr, "anteroom-cache: {} cannot be written: {}\n", settings.file, store.message());
  store.rollback();
  return kUnusable;
}

Status begin(const Settings& settings, cache::Store::Mode mode, cache::Store& store) {
  std::error_code ignored;
  if (mode == cache::Store::Mode::Create)
    std::filesystem::create_directories(std::filesystem::absolute(settings.file, ignored).parent_path(),
                                        ignored);
  if (const Status status = open(settings.file, mode, store)) return status;
  return store.begin() ? kDone : finish(store, settings, false);
}

Status write(const std::string& to, const std::string& text) {
  std::ofstream file(to, std::ios::binary);
  if (file << text << std::flush) return kDone;
  fmt::print(stderr, "anteroom-cache: {} cannot be written\n", to);
  return kUnusable;
}

}  // namespace anteroom::inspect
