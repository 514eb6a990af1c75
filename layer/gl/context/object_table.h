// Names of objects: those that Gen* reserved, and those that are objects already.
#pragma once

#include <GLES/gl.h>

#include <memory>
#include <new>
#include <unordered_map>
#include <vector>

namespace anteroom::gl {

// Small names, which are all that Gen* gives, are indices; any other name goes into a map.
template <class T>
class ObjectTable {
 public:
  // Reserves `n` names that nobody uses. False: out of memory, and nothing is reserved.
  bool reserve(GLsizei n, GLuint* names) {
    for (GLsizei i = 0; i < n; ++i) {
      names[i] = nextFree();
      Slot* slot = make(names[i]);
      if (!slot) {
        while (i-- > 0) remove(names[i]);
        return false;
      }
      slot->used = true;
    }
    return true;
  }

  bool used(GLuint name) const {
    const Slot* slot = at(name);
    return slot && slot->used;
  }

  // Null: no object has this name, though the name may be reserved.
  std::shared_ptr<T> find(GLuint name) const {
    const Slot* slot = at(name);
    return slot ? slot->object : nullptr;
  }

  // Gives `name`, reserved or not, an object. False: out of memory.
  bool put(GLuint name, std::shared_ptr<T> object) {
    Slot* slot = make(name);
    if (!slot) return false;
    slot->used = true;
    slot->object = std::move(object);
    return true;
  }

  // The name is free again; the object, if there was one, is handed back.
  std::shared_ptr<T> remove(GLuint name) {
    Slot* slot = const_cast<Slot*>(at(name));
    if (!slot) return nullptr;
    std::shared_ptr<T> object = std::move(slot->object);
    if (name < kDense) {
      *slot = Slot{};
      if (name < lowestFree_) lowestFree_ = name;
    } else {
      sparse_.erase(name);
    }
    return object;
  }

  template <class F>
  void forEach(F&& f) const {
    for (const Slot& slot : dense_) {
      if (slot.object) f(*slot.object);
    }
    for (const auto& [name, slot] : sparse_) {
      if (slot.object) f(*slot.object);
    }
  }

 private:
  struct Slot {
    bool used = false;
    std::shared_ptr<T> object;
  };
  static constexpr GLuint kDense = 1u << 16;

  const Slot* at(GLuint name) const {
    if (name < kDense) return name < dense_.size() ? &dense_[name] : nullptr;
    auto found = sparse_.find(name);
    return found == sparse_.end() ? nullptr : &found->second;
  }

  Slot* make(GLuint name) {
    try {
      if (name >= kDense) return &sparse_[name];
      if (name >= dense_.size()) dense_.resize(name + 1);
      return &dense_[name];
    } catch (const std::bad_alloc&) {
      return nullptr;
    }
  }

  // Amortised constant: everything below lowestFree_ is in use.
  GLuint nextFree() {
    while (used(lowestFree_)) ++lowestFree_;
    return lowestFree_;
  }

  GLuint lowestFree_ = 1;
  std::vector<Slot> dense_;
  std::unordered_map<GLuint, Slot> sparse_;
};

// The object of that name, made of the name and `arguments` when there is none yet. Null: out of memory.
template <class T, class... Arguments>
std::shared_ptr<T> obtain(ObjectTable<T>& table, GLuint name, const Arguments&... arguments) {
  std::shared_ptr<T> object = table.find(name);
  if (object) return object;
  try {
    object = std::make_shared<T>(name, arguments...);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
  return table.put(name, object) ? object : nullptr;
}

}  // namespace anteroom::gl
