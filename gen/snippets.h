// The files of shaders/, embedded by CMake. Each defines one function, whose name is the file's in camel
// case.
#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace anteroom::gen {

struct Snippet {
  std::string_view function;
  std::string_view text;  // the whole file
};

// Sorted by function.
std::span<const Snippet> snippets();
// Null when there is none.
const Snippet* findSnippet(std::string_view function);
// The names of the file's first line: `// Expects: a, b` or `// Expects: nothing`.
std::vector<std::string_view> expectations(const Snippet& snippet);
// The text without that line.
std::string_view body(const Snippet& snippet);

}  // namespace anteroom::gen
