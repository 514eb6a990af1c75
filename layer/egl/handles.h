// Handles as programs see them: numbers that are never used twice, so that a stale or invented one is always
// noticed.
#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>

#include "layer/egl/debug.h"

namespace anteroom::egl {

// A new handle, unlike every other of any kind (and unlike a config's, which is its small id). Called under
// the lock.
void* newHandle();

template <typename Object>
class Handles {
 public:
  // Object has a member `handle`.
  void* add(std::shared_ptr<Object> object) {
    object->handle = newHandle();
    void* handle = object->handle;
    objects_.emplace(handle, std::move(object));
    return handle;
  }
  // Null: no such object.
  std::shared_ptr<Object> find(const void* handle) const {
    const auto found = objects_.find(handle);
    if (found == objects_.end()) return nullptr;
    notePrimary(handle, false);
    return found->second;
  }
  std::shared_ptr<Object> take(const void* handle) {
    auto node = objects_.extract(handle);
    if (node.empty()) return nullptr;
    forgetLabel(handle);
    return std::move(node.mapped());
  }
  void clear() {
    for (const auto& [handle, object] : objects_) forgetLabel(handle);
    objects_.clear();
  }
  template <typename Visitor>
  void forEach(Visitor visit) const {
    for (const auto& [handle, object] : objects_) visit(*object);
  }

 private:
  std::unordered_map<const void*, std::shared_ptr<Object>> objects_;
};

}  // namespace anteroom::egl
