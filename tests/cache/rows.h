// What the tests of the cache share: a folder, rows that are quick to make, and children.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "layer/cache/shader_cache.h"

namespace anteroom::test {

// Gone, with what is in it, when the test ends.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::filesystem::path file() const { return path / "anteroom.db"; }
  std::filesystem::path path;
};

inline constexpr uint64_t kNoLimit = UINT64_MAX;

// Row number i: a key of text, and words that pass for SPIR-V and differ from every other row's.
std::string keyText(int i);
cache::KeyBytes keyBytes(const std::string& text);
std::vector<uint32_t> spirvOf(int i, int words = 64);
void storeRow(cache::ShaderCache& cache, int i, int words = 64);
std::vector<uint32_t> findRow(cache::ShaderCache& cache, int i);

// Pipeline number i, unlike every other.
cache::PipelineRow pipelineOf(int i);

std::string contents(const std::filesystem::path& file);
void replace(const std::filesystem::path& file, const std::string& bytes);

// Runs `body` in a forked process. Join: its exit status, or minus the signal that ended it.
int fork(const std::function<int()>& body);
int join(int child);

struct Output {
  int status = -1;  // as of join
  std::string out, err;
};
// A program with more of an environment; NAME alone takes a variable away.
Output runProgram(const std::string& program, const std::vector<std::string>& environment,
                  std::vector<std::string> arguments = {});

}  // namespace anteroom::test
