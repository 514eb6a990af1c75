#include "layer/cache/spirv_check.h"

#include <cstring>

namespace anteroom::cache {
namespace {

constexpr uint32_t kMagic = 0x07230203;
constexpr uint32_t kOldest = 0x00010000, kNewest = 0x00010600;
constexpr uint32_t kMostIds = 0x3fffff;  // the universal limit (SPIR-V, section 2.17)
constexpr size_t kHeaderWords = 5, kMostWords = 1 << 18;

}  // namespace

bool plausibleSpirv(std::span<const std::byte> bytes) {
  const size_t words = bytes.size() / sizeof(uint32_t);
  if (bytes.size() % sizeof(uint32_t) || words <= kHeaderWords || words > kMostWords) return false;
  const auto word = [&](size_t i) {
    uint32_t value;
    std::memcpy(&value, bytes.data() + i * sizeof value, sizeof value);
    return value;
  };
  const uint32_t version = word(1), bound = word(3), schema = word(4);
  if (word(0) != kMagic || version < kOldest || version > kNewest || (version & 0xff) != 0) return false;
  if (bound == 0 || bound > kMostIds || schema != 0) return false;
  size_t at = kHeaderWords;
  while (at < words) {
    const size_t length = word(at) >> 16;
    if (length == 0) return false;
    at += length;
  }
  return at == words;
}

}  // namespace anteroom::cache
