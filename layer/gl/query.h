// Tables of what can be asked for: a query is a row of a name, how its values convert (section 6.1.2), and
// where they come from. It is answered in every type that a program can ask in.
#pragma once

#include <algorithm>
#include <array>

#include "layer/gl/params.h"

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

// The rows of a table, by name. A table that has a name twice does not compile.
template <class Row, size_t N>
consteval std::array<Row, N> sortedByName(const Row (&rows)[N]) {
  std::array<Row, N> sorted;
  std::copy(std::begin(rows), std::end(rows), sorted.begin());
  std::ranges::sort(sorted, {}, &Row::name);
  if (std::ranges::adjacent_find(sorted, {}, &Row::name) != sorted.end()) throw "a name is there twice";
  return sorted;
}

// The row of `name`; null: there is none.
template <class Row, size_t N>
constexpr const Row* rowOf(const std::array<Row, N>& sorted, GLenum name) {
  const auto found = std::ranges::lower_bound(sorted, name, {}, &Row::name);
  return found != sorted.end() && found->name == name ? &*found : nullptr;
}

// False: no such name.
template <class Subject, size_t N>
bool answer(const std::array<Query<Subject>, N>& queries, Subject& subject, GLenum name, Results& results) {
  const Query<Subject>* query = rowOf(queries, name);
  if (query) query->answer(subject, query->kind, results);
  return query != nullptr;
}

}  // namespace anteroom::gl
