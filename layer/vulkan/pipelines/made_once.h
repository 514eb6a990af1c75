#pragma once

#include <condition_variable>
#include <mutex>
#include <unordered_map>

namespace anteroom::vulkan {

// Values by key. Each is made once, by the thread that asks for it first; who asks meanwhile waits for that
// one alone. References stay valid.
template <class Key, class Value, class Hash>
class MadeOnce {
 public:
  // make(key, value): false when the next to ask shall try again.
  template <class Make>
  Value& get(const Key& key, Make make) {
    std::unique_lock lock(mutex_);
    auto found = entries_.find(key);
    if (found == entries_.end()) found = entries_.try_emplace(key).first;
    const Key& kept = found->first;
    Entry& entry = found->second;
    made_.wait(lock, [&] { return entry.state != State::Making; });
    if (entry.state == State::Made) return entry.value;
    entry.state = State::Making;
    lock.unlock();
    // Also when it throws, nobody may wait for good.
    struct Finish {
      MadeOnce& owner;
      Entry& entry;
      bool good = false;
      ~Finish() {
        const std::lock_guard again(owner.mutex_);
        entry.state = good ? State::Made : State::Empty;
        owner.made_.notify_all();
      }
    } finish{*this, entry};
    finish.good = make(kept, entry.value);
    return entry.value;
  }

  // For the end: no thread may ask any more.
  template <class Visit>
  void visit(Visit visit) {
    for (auto& [key, entry] : entries_) visit(entry.value);
  }

 private:
  enum class State { Empty, Making, Made };
  struct Entry {
    State state = State::Empty;
    Value value;
  };

  std::mutex mutex_;
  std::condition_variable made_;
  std::unordered_map<Key, Entry, Hash> entries_;
};

}  // namespace anteroom::vulkan
