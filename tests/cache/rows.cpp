#include "tests/cache/rows.h"

#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace anteroom::test {

Folder::Folder() {
  // In memory, where that can be: thousands of files are opened.
  const std::filesystem::path memory = "/dev/shm";
  const auto place = access(memory.c_str(), W_OK) ? std::filesystem::temp_directory_path() : memory;
  std::string name = (place / "anteroom-cache-XXXXXX").string();
  if (!mkdtemp(name.data())) std::abort();
  path = name;
}

Folder::~Folder() {
  std::error_code ignored;
  std::filesystem::remove_all(path, ignored);
}

std::string keyText(int i) {
  return "#version 450\n// " + std::to_string(i) + "\n";
}

cache::KeyBytes keyBytes(const std::string& text) {
  return std::as_bytes(std::span(text));
}

std::vector<uint32_t> spirvOf(int i, int words) {
  // OpNop, and one OpSource whose operand tells the rows apart.
  std::vector<uint32_t> spirv{0x07230203, 0x00010300, 0, 10, 0, 0x00030003, 2, static_cast<uint32_t>(i)};
  spirv.resize(static_cast<size_t>(words), 0x00010000);
  return spirv;
}

void storeRow(cache::ShaderCache& cache, int i, int words) {
  const std::string key = keyText(i);
  cache.store(cache::KeyKind::VertexText, keyBytes(key), key, spirvOf(i, words), 1000 + i);
}

std::vector<uint32_t> findRow(cache::ShaderCache& cache, int i) {
  const std::string key = keyText(i);
  return cache.find(cache::KeyKind::VertexText, keyBytes(key));
}

cache::PipelineRow pipelineOf(int i) {
  cache::PipelineRow row;
  row.vertex = "vertex " + std::to_string(i);
  row.fragment = "fragment";
  row.state = "primitive=triangles";
  row.createMicroseconds = 100 + i;
  return row;
}

std::string contents(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

void replace(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}

}  // namespace anteroom::test
