#include "layer/tools/cache/highlight.h"

#include <algorithm>
#include <cctype>

namespace anteroom::inspect {
namespace {

constexpr std::string_view kKeywords[] = {
    "break", "const",     "continue", "discard", "else",   "false",  "flat", "for",     "if",   "in",
    "inout", "invariant", "layout",   "out",     "return", "struct", "true", "uniform", "while"};
constexpr std::string_view kTypes[] = {
    "bool",  "bvec2", "bvec3", "bvec4",  "float",  "int",       "ivec2",     "ivec3",       "ivec4",
    "mat2",  "mat3",  "mat4",  "mat3x4", "mat4x3", "sampler2D", "sampler3D", "samplerCube", "uint",
    "uvec2", "uvec3", "uvec4", "vec2",   "vec3",   "vec4",      "void"};
constexpr const char* kClasses[] = {"", "c", "d", "k", "t", "n", "b", "f"};
constexpr const char* kColors[] = {"",         "\033[90m", "\033[35m", "\033[34m",
                                   "\033[36m", "\033[33m", "\033[32m", "\033[1m"};
constexpr const char* kPlain = "\033[0m";

bool isLetter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) || c == '_';
}
bool isDigit(char c) {
  return std::isdigit(static_cast<unsigned char>(c));
}

bool among(std::string_view word, auto& list) {
  return std::find(std::begin(list), std::end(list), word) != std::end(list);
}

template <class Accept>
size_t run(std::string_view text, size_t at, Accept accept) {
  while (at < text.size() && accept(text[at])) ++at;
  return at;
}

Part partOfWord(std::string_view word, std::string_view rest) {
  if (among(word, kKeywords)) return Part::Keyword;
  if (among(word, kTypes)) return Part::Type;
  if (word.starts_with("gl_")) return Part::Builtin;
  return rest.starts_with('(') ? Part::Call : Part::Plain;
}

// What `text` begins with.
Piece next(std::string_view text, bool lineBegins) {
  const auto first = [&](Part part, size_t length) { return Piece{part, text.substr(0, length)}; };
  const auto line = [&] { return std::min(text.find('\n'), text.size()); };
  const char c = text[0];
  if (text.starts_with("//")) return first(Part::Comment, line());
  if (text.starts_with("/*")) {
    const size_t end = text.find("*/", 2);
    return first(Part::Comment, end == std::string_view::npos ? text.size() : end + 2);
  }
  if (c == '#' && lineBegins) return first(Part::Directive, line());
  if (isLetter(c)) {
    const size_t end = run(text, 0, [](char x) { return isLetter(x) || isDigit(x); });
    return first(partOfWord(text.substr(0, end), text.substr(end)), end);
  }
  if (isDigit(c))
    return first(Part::Number, run(text, 0, [](char x) { return isLetter(x) || isDigit(x) || x == '.'; }));
  const size_t end = run(text, 1, [](char x) { return !isLetter(x) && !isDigit(x) && x != '/' && x != '#'; });
  return first(Part::Plain, end);
}

}  // namespace

std::vector<Piece> glslPieces(std::string_view text) {
  std::vector<Piece> pieces;
  bool lineBegins = true;
  while (!text.empty()) {
    pieces.push_back(next(text, lineBegins));
    const std::string_view taken = pieces.back().text;
    lineBegins = taken.find_last_not_of(" \t") != std::string_view::npos
                     ? taken[taken.find_last_not_of(" \t")] == '\n'
                     : lineBegins;
    text.remove_prefix(taken.size());
  }
  return pieces;
}

std::string coloredGlsl(std::string_view glsl) {
  std::string result;
  for (const Piece& piece : glslPieces(glsl)) {
    const std::string_view color = kColors[static_cast<int>(piece.part)];
    result.append(color).append(piece.text);
    if (!color.empty()) result += kPlain;
  }
  return result;
}

std::string coloredAssembly(std::string_view assembly) {
  const auto partOf = [](std::string_view word) {
    if (word.starts_with("Op")) return Part::Keyword;
    if (word.starts_with('%')) return Part::Type;
    if (word.starts_with('"')) return Part::Builtin;
    return isDigit(word[0]) || (word[0] == '-' && word.size() > 1) ? Part::Number : Part::Plain;
  };
  std::string result;
  while (!assembly.empty()) {
    const size_t space = run(assembly, 0, [](char c) { return c == ' ' || c == '\n'; });
    result.append(assembly.substr(0, space));
    assembly.remove_prefix(space);
    if (assembly.empty()) break;
    const bool comment = assembly[0] == ';';
    const size_t end =
        std::min(comment ? assembly.find('\n') : assembly.find_first_of(" \n"), assembly.size());
    const std::string_view word = assembly.substr(0, end);
    const std::string_view color = kColors[static_cast<int>(comment ? Part::Comment : partOf(word))];
    result.append(color).append(word);
    if (!color.empty()) result += kPlain;
    assembly.remove_prefix(end);
  }
  return result;
}

std::string htmlText(std::string_view text) {
  std::string result;
  for (const char c : text) switch (c) {
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '&':
        result += "&amp;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  return result;
}

std::string htmlGlsl(std::string_view glsl) {
  std::string result;
  for (const Piece& piece : glslPieces(glsl)) {
    const std::string_view kind = kClasses[static_cast<int>(piece.part)];
    if (kind.empty())
      result += htmlText(piece.text);
    else
      result.append("<i class=").append(kind).append(">").append(htmlText(piece.text)).append("</i>");
  }
  return result;
}

}  // namespace anteroom::inspect
