// The cache as a renderer sees it: look-ups at once, writes on a thread of its own.
#pragma once

#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>
#include <unordered_set>
#include <vector>

#include "layer/cache/store.h"

namespace anteroom::cache {

struct CacheCounts {
  uint64_t hits = 0, misses = 0;  // look-ups
  uint64_t damaged = 0;           // rows or files that could not be believed
  uint64_t written = 0;           // rows
};

// Thread-safe; in a process forked from the one that made it, it is empty and does nothing. Nothing that it
// does fails: what cannot be read is a miss, what cannot be written is dropped with one warning.
class ShaderCache {
 public:
  // The file is opened, and made, on the cache's own thread. An empty path: no cache.
  ShaderCache(std::filesystem::path file, uint64_t limitBytes);
  ~ShaderCache();
  ShaderCache(const ShaderCache&) = delete;
  ShaderCache& operator=(const ShaderCache&) = delete;

  // This process's, where cacheLocation() says. It lasts until the process ends, and then writes what is
  // left.
  static ShaderCache& process();
  // Another file for process(). Before its first call.
  static void setProcessFile(std::filesystem::path file);

  // Empty: not there. Waits for the file to be open.
  std::vector<uint32_t> find(KeyKind kind, KeyBytes key);
  void store(KeyKind kind, KeyBytes key, std::string glsl, std::vector<uint32_t> spirv,
             int64_t compileMicroseconds);
  // Whether shaders of this generator can be expected. Waits for the file to be open.
  bool filled();

  // That this run needs the pipeline; once for each, in the order of first use.
  void use(PipelineRow row);
  // What this program, as it was called, needed lately, most used first. For a thread that draws nothing: it
  // waits for the file to be open, and reads it.
  std::vector<PipelineRow> usualPipelines();
  // Whether there may be a cache at all.
  bool wanted() const { return !file_.empty() && !foreignProcess(); }
  const std::filesystem::path& file() const { return file_; }

  // Until what was stored so far is written, or cannot be.
  void flush();
  // Writes what is left and lets go of the file. Afterwards it is empty.
  void close();
  CacheCounts counts() const;

 private:
  enum class State { Opening, Open, Off };
  struct Work {
    std::vector<ShaderRow> shaders;
    std::unordered_set<int64_t> used;
    std::vector<PipelineRow> pipelines;
    bool empty() const { return shaders.empty() && used.empty() && pipelines.empty(); }
  };

  // Not the process that made this: forked from it.
  bool foreignProcess() const;
  bool waitUntilOpen();
  void run();
  bool open();
  void moveAside();
  void write(const Work& work);
  bool writeOnce(const Work& work);
  bool writePipelines(const std::vector<PipelineRow>& rows, int64_t now);
  void warn(const std::string& what);

  const std::filesystem::path file_;
  const uint64_t limit_;
  const int process_;
  std::atomic<uint64_t> hits_{0}, misses_{0}, damaged_{0}, written_{0};
  std::atomic<bool> fileDamaged_{false};

  mutable std::mutex mutex_;  // guards the state and the work
  std::condition_variable wake_, changed_;
  State state_ = State::Opening;
  bool filled_ = false, stopping_ = false, hurry_ = false, writing_ = false;
  Work work_;

  std::mutex readMutex_;  // guards the reader
  Store reader_;
  std::unordered_set<int64_t> counted_;  // rows whose use by this process is known

  // The thread's own.
  Store writer_;
  uint64_t inode_ = 0;               // of the file that is open
  std::vector<ShaderRow> salvaged_;  // good rows of a damaged one
  Program program_;
  int64_t run_ = 0;    // of the program, in the file that is open; 0: not begun
  int64_t place_ = 0;  // of the next pipeline
  bool warned_ = false;

  std::thread thread_;
};

}  // namespace anteroom::cache
