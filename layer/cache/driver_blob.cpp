#include "layer/cache/driver_blob.h"

#define XXH_INLINE_ALL
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xxhash.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string>

namespace anteroom::cache {
namespace {

constexpr uint64_t kMagic = 0x31424c42544e41;  // "ANTBLB1"
constexpr uint64_t kMost = 256 << 20;          // bytes

struct Head {
  uint64_t magic, size, checksum;
};

class File {
 public:
  explicit File(int handle) : handle_(handle) {}
  ~File() {
    if (handle_ >= 0) ::close(handle_);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  explicit operator bool() const { return handle_ >= 0; }

  bool read(void* to, size_t size) {
    auto* at = static_cast<char*>(to);
    while (size > 0) {
      const ssize_t done = ::read(handle_, at, size);
      if (done <= 0) return false;
      at += done;
      size -= static_cast<size_t>(done);
    }
    return true;
  }
  bool write(const void* from, size_t size) {
    const auto* at = static_cast<const char*>(from);
    while (size > 0) {
      const ssize_t done = ::write(handle_, at, size);
      if (done <= 0) return false;
      at += done;
      size -= static_cast<size_t>(done);
    }
    return true;
  }
  uint64_t size() const {
    struct stat info;
    return fstat(handle_, &info) == 0 && S_ISREG(info.st_mode) ? static_cast<uint64_t>(info.st_size) : 0;
  }

 private:
  const int handle_;
};

}  // namespace

std::vector<std::byte> readDriverBlob(const std::filesystem::path& path) {
  File file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  Head head;
  const uint64_t size = file ? file.size() : 0;
  if (size <= sizeof head || size > kMost || !file.read(&head, sizeof head)) return {};
  if (head.magic != kMagic || head.size != size - sizeof head) return {};
  std::vector<std::byte> bytes(head.size);
  if (!file.read(bytes.data(), bytes.size())) return {};
  if (XXH3_64bits(bytes.data(), bytes.size()) != head.checksum) return {};
  return bytes;
}

bool writeDriverBlob(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  if (bytes.size() + sizeof(Head) > kMost) return false;
  std::string temporary = path.string() + ".XXXXXX";
  bool good;
  {
    File file(mkostemp(temporary.data(), O_CLOEXEC));
    if (!file) return false;
    const Head head{kMagic, bytes.size(), XXH3_64bits(bytes.data(), bytes.size())};
    good = file.write(&head, sizeof head) && file.write(bytes.data(), bytes.size());
  }
  good = good && rename(temporary.c_str(), path.c_str()) == 0;
  if (!good) unlink(temporary.c_str());
  return good;
}

void keepNewestBlobs(const std::filesystem::path& folder, const std::string& prefix, size_t most) {
  std::error_code ignored;
  std::vector<std::pair<std::filesystem::file_time_type, std::filesystem::path>> found;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
    if (entry.path().filename().string().starts_with(prefix))
      found.emplace_back(entry.last_write_time(ignored), entry.path());
  std::sort(found.rbegin(), found.rend());
  for (size_t i = most; i < found.size(); ++i) std::filesystem::remove(found[i].second, ignored);
}

}  // namespace anteroom::cache
