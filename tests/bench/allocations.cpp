#include "allocations.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <link.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <string_view>

// glibc's own, under the names that stay when a program defines the usual ones.
extern "C" {
void* __libc_malloc(std::size_t size);                           // NOLINT(bugprone-reserved-identifier)
void* __libc_calloc(std::size_t count, std::size_t size);        // NOLINT(bugprone-reserved-identifier)
void* __libc_realloc(void* block, std::size_t size);             // NOLINT(bugprone-reserved-identifier)
void* __libc_memalign(std::size_t alignment, std::size_t size);  // NOLINT(bugprone-reserved-identifier)
}

namespace bench {

namespace {

struct Range {
  std::uintptr_t begin = 0;
  std::uintptr_t end = 0;
};

std::atomic<bool> counting = false;
std::atomic<unsigned> number = 0;
std::array<std::atomic<void*>, 8> callers;

// Filled before counting starts, since looking for a library may allocate.
std::array<Range, 64> drivers;
std::size_t driverRanges = 0;

bool isDriver(std::string_view path) {
  const std::string_view name = path.substr(path.rfind('/') + 1);
  return name.starts_with("libvulkan") || name.starts_with("libLLVM") || name.starts_with("libVkLayer");
}

int addRanges(dl_phdr_info* info, std::size_t, void*) {
  if (!isDriver(info->dlpi_name)) return 0;
  for (int i = 0; i < info->dlpi_phnum && driverRanges < drivers.size(); ++i) {
    const auto& segment = info->dlpi_phdr[i];
    if (segment.p_type != PT_LOAD || !(segment.p_flags & PF_X)) continue;
    const std::uintptr_t begin = info->dlpi_addr + segment.p_vaddr;
    drivers[driverRanges++] = {begin, begin + segment.p_memsz};
  }
  return 0;
}

void note(void* caller) {
  if (!counting.load(std::memory_order_relaxed)) return;
  const auto address = reinterpret_cast<std::uintptr_t>(caller);
  for (std::size_t i = 0; i < driverRanges; ++i)
    if (address >= drivers[i].begin && address < drivers[i].end) return;
  const unsigned index = number++;
  if (index < callers.size()) callers[index] = caller;
}

std::string describe(void* caller) {
  Dl_info info;
  if (!dladdr(caller, &info)) return fmt::format("{}", caller);
  const std::size_t offset = std::size_t(static_cast<char*>(caller) - static_cast<char*>(info.dli_fbase));
  return fmt::format("{}+0x{:x} {}", info.dli_fname, offset, info.dli_sname ? info.dli_sname : "");
}

}  // namespace

void beginCountingAllocations() {
  driverRanges = 0;
  dl_iterate_phdr(addRanges, nullptr);
  number = 0;
  counting = true;
}

AllocationCount endCountingAllocations() {
  counting = false;
  AllocationCount result{number, {}};
  for (std::size_t i = 0; i < callers.size() && i < result.number; ++i)
    result.callers.push_back(describe(callers[i]));
  return result;
}

}  // namespace bench

extern "C" {

__attribute__((visibility("default"))) void* malloc(std::size_t size) {
  bench::note(__builtin_return_address(0));
  return __libc_malloc(size);
}

__attribute__((visibility("default"))) void* calloc(std::size_t count, std::size_t size) {
  bench::note(__builtin_return_address(0));
  return __libc_calloc(count, size);
}

__attribute__((visibility("default"))) void* realloc(void* block, std::size_t size) {
  bench::note(__builtin_return_address(0));
  return __libc_realloc(block, size);
}

__attribute__((visibility("default"))) void* aligned_alloc(std::size_t alignment, std::size_t size) {
  bench::note(__builtin_return_address(0));
  return __libc_memalign(alignment, size);
}

__attribute__((visibility("default"))) int posix_memalign(void** block, std::size_t alignment,
                                                          std::size_t size) {
  bench::note(__builtin_return_address(0));
  void* const result = __libc_memalign(alignment, size);
  if (!result) return ENOMEM;
  *block = result;
  return 0;
}
}
