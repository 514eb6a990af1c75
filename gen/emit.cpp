#include "gen/emit.h"

#include <algorithm>
#include <cassert>

#include "gen/snippets.h"
#include "gen/words.h"

namespace anteroom::gen {

std::string_view coordinateType(Coordinate coordinate) {
  constexpr auto kTypes = wordsTo<Coordinate::Last>("", "vec2", "vec3", "vec3", "vec4", "vec2");
  return kTypes[static_cast<int>(coordinate)];
}

std::string_view Shader::call(std::string_view function) {
  if (std::find(called_.begin(), called_.end(), function) != called_.end()) return function;
  const Snippet* snippet = findSnippet(function);
  assert(snippet);
  if (!snippet) return function;
  for (std::string_view expected : expectations(*snippet)) call(expected);
  called_.push_back(snippet->function);
  return function;
}

std::string Shader::text() const {
  std::string text = "// " + description_ + "\n#version 450\n\n" + declarations_ + '\n';
  for (std::string_view function : called_) text += body(*findSnippet(function));
  if (!called_.empty()) text += '\n';
  text += functions_;
  return text + "void main() {\n" + body_ + "}\n";
}

}  // namespace anteroom::gen
