// GLSL in its parts, for terminals and pages.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace anteroom::inspect {

enum class Part { Plain, Comment, Directive, Keyword, Type, Number, Builtin, Call };

struct Piece {
  Part part;
  std::string_view text;  // of what was given
};
// The pieces together are the text.
std::vector<Piece> glslPieces(std::string_view text);

std::string coloredGlsl(std::string_view glsl);          // by ANSI escapes
std::string coloredAssembly(std::string_view assembly);  // SPIR-V's
std::string htmlGlsl(std::string_view glsl);             // spans with classes
std::string htmlText(std::string_view text);

}  // namespace anteroom::inspect
