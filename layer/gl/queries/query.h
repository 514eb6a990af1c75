// Tables of what can be asked for: a query is a row of a name, how its values convert (section 6.1.2), and
// where they come from. It is answered in every type that a program can ask in.
#pragma once

#include <array>
#include <bit>

#include "layer/gl/context/params.h"

namespace anteroom::gl {

// `Subject` is what is asked: the context, or a light, a texture and so on.
template <class Subject>
struct Query {
  GLenum name = 0;
  Results::Kind kind = {};
  void (*answer)(Subject&, Results::Kind, Results&) = nullptr;

  constexpr Query() = default;
  // `Getter`: a lambda without captures, from the subject to a number, a vector, a matrix or a list.
  template <class Getter>
  constexpr Query(GLenum queryName, Results::Kind queryKind, Getter)
      : name(queryName), kind(queryKind), answer([](Subject& subject, Results::Kind k, Results& results) {
          results.put(k, Getter{}(subject));
        }) {}
};

// Rows that have a `name`, found by it: a hash table that the compiler makes. One that has a name twice does
// not compile.
template <class Row, size_t N>
class Table {
 public:
  consteval explicit Table(const Row (&rows)[N]) {
    for (size_t i = 0; i < N; ++i) {
      rows_[i] = rows[i];
      uint8_t& slot = slots_[slotOf(rows[i].name)];
      if (slot != 0) throw "a name is there twice";
      slot = static_cast<uint8_t>(i + 1);
    }
  }

  // Null: no row has the name.
  constexpr const Row* find(GLenum name) const {
    const uint8_t row = slots_[slotOf(name)];
    return row != 0 ? &rows_[row - 1] : nullptr;
  }

 private:
  static_assert(N < 256);
  static constexpr size_t kSlots = std::bit_ceil(2 * N);

  // Where the name is, or else the empty slot that ends the search for it.
  constexpr size_t slotOf(GLenum name) const {
    size_t slot = (name * 0x9E3779B1u) >> (32 - std::countr_zero(kSlots));
    while (slots_[slot] != 0 && rows_[slots_[slot] - 1].name != name) slot = (slot + 1) % kSlots;
    return slot;
  }

  std::array<Row, N> rows_;
  std::array<uint8_t, kSlots> slots_{};  // 0: empty, otherwise 1 + the index of a row
};

template <class Row, size_t N>
consteval Table<Row, N> tableOf(const Row (&rows)[N]) {
  return Table<Row, N>(rows);
}

// False: no such name.
template <class Subject, size_t N>
bool answer(const Table<Query<Subject>, N>& queries, Subject& subject, GLenum name, Results& results) {
  const Query<Subject>* query = queries.find(name);
  if (query) query->answer(subject, query->kind, results);
  return query != nullptr;
}

}  // namespace anteroom::gl
