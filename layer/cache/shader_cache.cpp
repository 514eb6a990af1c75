#include "layer/cache/shader_cache.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <ctime>

#include "layer/cache/location.h"
#include "layer/cache/quiet_thread.h"

namespace anteroom::cache {
namespace {

using namespace std::chrono_literals;

constexpr auto kGather = 100ms;       // how long a batch is added to
constexpr auto kWaitForOpen = 100ms;  // then a look-up does without
constexpr auto kWaitForFlush = 2s;
constexpr int kTries = 10;  // at a file that other processes keep locked
constexpr auto kPause = 10ms;

uint64_t inodeOf(const std::filesystem::path& file) {
  struct stat info;
  return stat(file.c_str(), &info) == 0 ? info.st_ino : 0;
}

constexpr int64_t kMostUsual = 256;  // pipelines: no more are made ahead

std::filesystem::path& chosenFile() {
  static std::filesystem::path file;
  return file;
}

}  // namespace

ShaderCache::ShaderCache(std::filesystem::path file, uint64_t limitBytes)
    : file_(std::move(file)), limit_(limitBytes), process_(getpid()) {
  if (!file_.empty()) thread_ = quietThread([this] { run(); });
  if (!thread_.joinable()) state_ = State::Off;
}

ShaderCache::~ShaderCache() {
  close();
  cache::forget(thread_);
}

ShaderCache& ShaderCache::process() {
  // Never destroyed: other threads may still draw while the process ends.
  static ShaderCache* const cache = [] {
    CacheLocation location = chosenFile().empty() ? cacheLocation() : CacheLocation{chosenFile(), {}};
    auto* made = new ShaderCache(std::move(location.file), cacheLimit());
    if (!location.reason.empty()) made->warn(location.reason);
    return made;
  }();
  static const struct Closer {
    ~Closer() { cache->close(); }
  } closer;
  return *cache;
}

void ShaderCache::setProcessFile(std::filesystem::path file) {
  chosenFile() = std::move(file);
}

bool ShaderCache::foreignProcess() const {
  return getpid() != process_;
}

void ShaderCache::warn(const std::string& what) {
  if (!warned_) fmt::print(stderr, "anteroom: no shader cache: {}\n", what);
  warned_ = true;
}

bool ShaderCache::waitUntilOpen() {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, kWaitForOpen, [&] { return state_ != State::Opening; });
  return state_ == State::Open;
}

std::vector<uint32_t> ShaderCache::find(KeyKind kind, KeyBytes key) {
  std::vector<uint32_t> spirv;
  if (foreignProcess() || !waitUntilOpen()) return spirv;
  const int64_t id = shaderId(kind, key);
  bool firstUse = false;
  Found found = Found::Absent;
  {
    const std::lock_guard lock(readMutex_);
    if (reader_.isOpen()) {
      found = reader_.find(kind, key, spirv);
      if (found == Found::Hit) firstUse = counted_.insert(id).second;
      if (found == Found::Error && reader_.damaged()) fileDamaged_ = true;
    }
  }
  if (found == Found::Bad) ++damaged_;
  ++(found == Found::Hit ? hits_ : misses_);
  if (firstUse) {
    const std::lock_guard lock(mutex_);
    work_.used.insert(id);
    wake_.notify_one();
  }
  return spirv;
}

void ShaderCache::store(KeyKind kind, KeyBytes key, std::string glsl, std::vector<uint32_t> spirv,
                        int64_t compileMicroseconds) {
  if (foreignProcess()) return;
  {
    const std::lock_guard lock(mutex_);
    if (state_ == State::Off || stopping_) return;
  }
  ShaderRow row = makeRow(kind, key, std::move(glsl), std::move(spirv), compileMicroseconds);
  {
    const std::lock_guard lock(readMutex_);
    counted_.insert(row.id());
  }
  const std::lock_guard lock(mutex_);
  work_.shaders.push_back(std::move(row));
  wake_.notify_one();
}

void ShaderCache::use(PipelineRow row) {
  if (foreignProcess()) return;
  const std::lock_guard lock(mutex_);
  if (state_ == State::Off || stopping_) return;
  work_.pipelines.push_back(std::move(row));
  wake_.notify_one();
}

std::vector<PipelineRow> ShaderCache::usualPipelines() {
  if (foreignProcess() || !waitUntilOpen()) return {};
  Store store;
  if (store.open(file_, Store::Mode::Read) != Opened::Ok) return {};
  return store.usual(thisProgram().id, kMostUsual);
}

bool ShaderCache::filled() {
  if (foreignProcess() || !waitUntilOpen()) return false;
  const std::lock_guard lock(mutex_);
  return filled_;
}

void ShaderCache::flush() {
  if (foreignProcess()) return;
  std::unique_lock lock(mutex_);
  hurry_ = !work_.empty();
  wake_.notify_one();
  changed_.wait_for(lock, kWaitForFlush,
                    [&] { return state_ == State::Off || (work_.empty() && !writing_); });
}

void ShaderCache::close() {
  if (foreignProcess()) return;
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
    wake_.notify_one();
  }
  if (thread_.joinable()) thread_.join();
  const std::lock_guard lock(readMutex_);
  reader_.close();
}

CacheCounts ShaderCache::counts() const {
  return {hits_, misses_, damaged_, written_};
}

void ShaderCache::run() {
  bool usable = false;
  try {
    usable = open();
    std::unique_lock lock(mutex_);
    state_ = usable ? State::Open : State::Off;
    changed_.notify_all();
    while (usable) {
      wake_.wait(lock, [&] { return stopping_ || !work_.empty(); });
      if (work_.empty()) break;
      wake_.wait_for(lock, kGather, [&] { return stopping_ || hurry_; });
      const Work work = std::move(work_);
      work_ = {};
      writing_ = true;
      lock.unlock();
      write(work);
      usable = writer_.isOpen();
      lock.lock();
      writing_ = false;
      if (work_.empty()) hurry_ = false;
      changed_.notify_all();
    }
  } catch (const std::exception& problem) {
    warn(problem.what());
  }
  writer_.close();
  const std::lock_guard lock(mutex_);
  state_ = State::Off;
  changed_.notify_all();
}

// Renames the file, unless another process did so already.
void ShaderCache::moveAside() {
  ++damaged_;
  salvaged_.clear();
  if (writer_.isOpen())
    writer_.visitShaders([this](int64_t, int64_t, ShaderRow& row, const std::string& why) {
      if (why.empty()) salvaged_.push_back(std::move(row));
    });
  writer_.close();
  {
    const std::lock_guard lock(readMutex_);
    reader_.close();
  }
  const int folder = ::open(file_.parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return;
  if (flock(folder, LOCK_EX) == 0 && inodeOf(file_) == inode_) {
    std::error_code ignored;
    for (const char* suffix : {"-wal", "-shm"}) std::filesystem::remove(file_.string() + suffix, ignored);
    std::filesystem::rename(file_, file_.string() + ".damaged", ignored);
  }
  ::close(folder);
}

bool ShaderCache::open() {
  const auto folder = file_.parent_path();
  std::error_code ignored;
  std::filesystem::create_directories(folder.parent_path(), ignored);
  ::mkdir(folder.c_str(), 0700);
  Opened opened = Opened::Unusable;
  for (int i = 0; i < kTries && opened != Opened::Ok && opened != Opened::Newer; ++i) {
    if (i > 0) std::this_thread::sleep_for(kPause);
    opened = writer_.open(file_, Store::Mode::Create);
    inode_ = inodeOf(file_);
    if (opened == Opened::Damaged || opened == Opened::Foreign)
      moveAside();
    else if (opened == Opened::Unusable && !writer_.busy())
      break;
  }
  if (opened == Opened::Newer) warn(fmt::format("{} was made by a newer version", file_.string()));
  if (opened == Opened::Unusable) warn(fmt::format("{}: {}", file_.string(), writer_.message()));
  if (opened != Opened::Ok) return false;
  const bool filled = writer_.holdsCurrent();
  {
    const std::lock_guard lock(readMutex_);
    if (reader_.open(file_, Store::Mode::Write) != Opened::Ok) reader_.close();
  }
  const std::lock_guard lock(mutex_);
  filled_ = filled;
  fileDamaged_ = false;
  run_ = 0;
  return true;
}

bool ShaderCache::writeOnce(const Work& work) {
  if (!writer_.begin()) return false;
  const int64_t now = std::time(nullptr);
  bool good = true;
  for (const ShaderRow& row : salvaged_) good = good && writer_.put(row);
  for (const ShaderRow& row : work.shaders) good = good && writer_.put(row);
  for (int64_t id : work.used) good = good && writer_.touch(id, now);
  const int64_t run = run_, place = place_;
  good = good && writePipelines(work.pipelines, now);
  good = good && (work.shaders.empty() || writer_.shrink(limit_) >= 0);
  if (good && writer_.commit()) return true;
  run_ = run;
  place_ = place;
  return false;
}

bool ShaderCache::writePipelines(const std::vector<PipelineRow>& rows, int64_t now) {
  if (rows.empty()) return true;
  if (run_ == 0) {
    if (program_.id == 0) program_ = thisProgram();
    run_ = writer_.beginRun(program_, now);
    if (run_ == 0) return false;
  }
  for (PipelineRow row : rows) {
    row.created = row.used = now;
    const int64_t id = row.id();
    if (!writer_.put(row) || !writer_.touchPipeline(id, now) || !writer_.use(program_.id, id, run_, place_++))
      return false;
  }
  return true;
}

void ShaderCache::write(const Work& work) {
  for (int i = 0; i < kTries; ++i) {
    if (fileDamaged_) {
      moveAside();
      if (!open()) return writer_.close();
    }
    if (writeOnce(work)) {
      salvaged_.clear();
      written_ += work.shaders.size();
      return;
    }
    const bool busy = writer_.busy(), damaged = writer_.damaged();
    const std::string message = writer_.message();
    if (damaged) fileDamaged_ = true;
    writer_.rollback();
    if (!busy && !damaged) {
      warn(fmt::format("{}: {}", file_.string(), message));
      return writer_.close();
    }
    std::this_thread::sleep_for(kPause);
  }
}

}  // namespace anteroom::cache
