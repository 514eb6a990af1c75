// Keys as text and back, their validity and their hash. One table of fields serves all of these.
#define XXH_INLINE_ALL
#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <charconv>
#include <span>
#include <string_view>

#include "gen/combiner.h"
#include "gen/gen.h"
#include "gen/reduce.h"
#include "gen/words.h"

namespace anteroom::gen {
namespace {

using Words = std::span<const std::string_view>;

constexpr auto kFetchWords = wordsTo<Fetch::Last>("unread", "constant", "float", "fixed", "fixed-w1", "int",
                                                  "int-w1", "uint", "normed-byte", "normed-short");
constexpr auto kAttributeWords =
    wordsTo<kAttributeCount - 1>("position", "normal", "color", "size", "coord0", "coord1", "coord2",
                                 "coord3", "coord4", "coord5", "coord6", "coord7", "index", "weight");
constexpr auto kColorWords = wordsTo<VertexColor::Last>("none", "unlit", "lit");
constexpr auto kPointSizeWords = wordsTo<PointSize::Last>("none", "1", "constant", "varying");
constexpr auto kPointShapeWords = wordsTo<PointShape::Last>("square", "smooth", "samples");
constexpr auto kCoordinateWords = wordsTo<Coordinate::Last>("none", "st", "stq", "str", "strq", "point");
constexpr auto kTexGenWords = wordsTo<TexGen::Last>("none", "reflection", "normal");
constexpr auto kTargetWords = wordsTo<TextureTarget::Last>("none", "2d", "cube", "3d");
constexpr auto kEdgeWords = wordsTo<MirroredEdge::Last>("none", "texel", "half", "whole", "hard");
constexpr auto kFogWords = wordsTo<FogMode::Last>("none", "linear", "exp", "exp2");
constexpr auto kAlphaTestWords =
    wordsTo<AlphaTest::Last>("always", "never", "less", "equal", "lequal", "greater", "notequal", "gequal");
constexpr auto kFunctionWords =
    wordsTo<Function::Last>("keep", "replace", "modulate", "add", "addsigned", "interpolate", "subtract",
                            "dot3", "modulateadd", "modulatesignedadd", "modulatesubtract");
constexpr auto kSourceWords =
    wordsTo<Source::Last>("previous", "primary", "constant", "0", "1", "texture0", "texture1", "texture2",
                          "texture3", "texture4", "texture5", "texture6", "texture7", "fog", "output0",
                          "output1", "output2", "output3", "output4", "output5", "output6", "output7");

// A field of one byte: its name, a number after the name (or -1), and its values, as words or as a range from
// 0.
struct Field {
  std::string_view name;
  int index;
  Words words;
  int most;
  std::string fullName() const { return index < 0 ? std::string(name) : fmt::format("{}{}", name, index); }
};

// Calls visit(field, byte) for every field. `Key` may be const.
template <class Key, class Visit>
void visitVertex(Key& key, Visit visit) {
  const auto words = [&](std::string_view name, auto& value, Words list, int index = -1) {
    visit(Field{name, index, list, static_cast<int>(list.size()) - 1}, value);
  };
  const auto number = [&](std::string_view name, auto& value, int most, int index = -1) {
    visit(Field{name, index, {}, most}, value);
  };
  for (int a = 0; a < kAttributeCount; ++a) words(kAttributeWords[a], key.fetch[a], kFetchWords);
  words("shade", key.color, kColorWords);
  number("two-sided", key.twoSided, 1);
  number("color-material", key.colorMaterial, 1);
  number("normalize", key.normalize, 1);
  number("specular", key.specular, 1);
  number("shininess", key.shininess, 1);
  number("lights", key.lights, kMaxLights);
  number("positional", key.positional, 255);
  number("attenuated", key.attenuated, 255);
  number("spot", key.spot, 255);
  number("spot-exponent", key.spotExponent, 255);
  number("fog", key.fog, 1);
  number("fog-w", key.fogW, 1);
  number("clip", key.clipPlanes, kMaxClipPlanes);
  number("clip-varyings", key.clipVaryings, 1);
  words("point-size", key.pointSize, kPointSizeWords);
  number("point-attenuation", key.pointAttenuation, 1);
  number("point-round", key.pointRound, 1);
  words("point-shape", key.pointShape, kPointShapeWords);
  number("point-fade", key.pointFade, 1);
  number("palette", key.palette, kMaxVertexUnits);
  number("palette-w", key.paletteW, 1);
  number("palette-normals", key.paletteNormals, 1);
  number("own-values", key.ownValues, 1);
  for (int u = 0; u < kMaxTextureUnits; ++u) {
    words("out", key.units[u].output, Words(kCoordinateWords).first(5), u);
    words("texgen", key.units[u].texGen, kTexGenWords, u);
    number("matrix", key.units[u].matrix, 1, u);
    number("q1-", key.units[u].q1, 1, u);
  }
}

template <class Key, class Visit>
void visitFragment(Key& key, Visit visit) {
  const auto words = [&](std::string_view name, auto& value, Words list, int index = -1) {
    visit(Field{name, index, list, static_cast<int>(list.size()) - 1}, value);
  };
  const auto number = [&](std::string_view name, auto& value, int most) {
    visit(Field{name, -1, {}, most}, value);
  };
  for (int u = 0; u < kMaxTextureUnits; ++u) {
    words("unit", key.units[u].target, kTargetWords, u);
    words("read", key.units[u].coordinate, kCoordinateWords, u);
    constexpr std::string_view kEdges[] = {"edge-s", "edge-t", "edge-r"};
    for (size_t axis = 0; axis < 3; ++axis) words(kEdges[axis], key.units[u].edges[axis], kEdgeWords, u);
  }
  words("fog", key.fog, kFogWords);
  words("fog-source", key.fogSource, kFogWords);
  words("alpha-test", key.alphaTest, kAlphaTestWords);
  words("point-shape", key.pointShape, kPointShapeWords);
  number("point-fade", key.pointFade, 1);
  number("flat", key.flatColor, 1);
  number("two-sided", key.twoSided, 1);
  number("point-y-up", key.pointYUp, 1);
  number("discard-planes", key.discardPlanes, kMaxClipPlanes);
  number("switch-over", key.switchOver, 255);
}

void visitFields(VertexKey& key, auto visit) {
  visitVertex(key, visit);
}
void visitFields(const VertexKey& key, auto visit) {
  visitVertex(key, visit);
}
void visitFields(FragmentKey& key, auto visit) {
  visitFragment(key, visit);
}
void visitFields(const FragmentKey& key, auto visit) {
  visitFragment(key, visit);
}

// ---- Combiners: interpolate(texture0,1-previous.a,constant)*2

std::string describe(Argument argument) {
  return fmt::format("{}{}{}", complements(argument.operand) ? "1-" : "",
                     kSourceWords[static_cast<int>(argument.source)],
                     readsAlpha(argument.operand) ? ".a" : "");
}

std::string describe(const Combiner& combiner) {
  std::string arguments;
  for (int i = 0; i < argumentCount(combiner.function); ++i)
    arguments += fmt::format("{}{}", i ? "," : "", describe(combiner.arguments[i]));
  const std::string scale = combiner.scaleLog2 ? fmt::format("*{}", 1 << combiner.scaleLog2) : "";
  return fmt::format("{}({}){}", kFunctionWords[static_cast<int>(combiner.function)], arguments, scale);
}

int find(Words words, std::string_view word) {
  for (size_t i = 0; i < words.size(); ++i)
    if (words[i] == word) return static_cast<int>(i);
  return -1;
}

bool parse(std::string_view text, Argument& out) {
  const bool complement = text.starts_with("1-");
  if (complement) text.remove_prefix(2);
  const bool alpha = text.ends_with(".a");
  if (alpha) text.remove_suffix(2);
  const int source = find(kSourceWords, text);
  if (source < 0) return false;
  out.source = static_cast<Source>(source);
  out.operand = static_cast<Operand>(alpha * 2 + complement);
  return true;
}

bool parse(std::string_view text, Combiner& out) {
  if (text.ends_with("*2") || text.ends_with("*4")) {
    out.scaleLog2 = text.back() == '2' ? 1 : 2;
    text.remove_suffix(2);
  }
  const size_t open = text.find('(');
  if (open == std::string_view::npos || !text.ends_with(')')) return false;
  const int function = find(kFunctionWords, text.substr(0, open));
  if (function < 0) return false;
  out.function = static_cast<Function>(function);
  text = text.substr(open + 1, text.size() - open - 2);
  const int count = argumentCount(out.function);
  for (int i = 0; i < count; ++i) {
    const size_t comma = text.find(',');
    if ((comma == std::string_view::npos) != (i == count - 1)) return false;
    if (!parse(text.substr(0, comma), out.arguments[i])) return false;
    text.remove_prefix(std::min(comma, text.size() - 1) + 1);
  }
  return true;
}

bool inRange(const Combiner& combiner) {
  if (static_cast<size_t>(combiner.function) >= std::size(kFunctionWords) || combiner.scaleLog2 > 2)
    return false;
  for (const Argument& a : combiner.arguments) {
    if (static_cast<size_t>(a.source) >= std::size(kSourceWords)) return false;
    if (static_cast<int>(a.operand) > 3) return false;
  }
  return true;
}

void describeCombiners(const VertexKey&, std::string&) {}
void describeCombiners(const FragmentKey& key, std::string& text) {
  for (int u = 0; u < kMaxTextureUnits; ++u) {
    if (key.units[u].rgb.function != Function::Keep)
      text += fmt::format(" rgb{}={}", u, describe(key.units[u].rgb));
    if (key.units[u].alpha.function != Function::Keep)
      text += fmt::format(" alpha{}={}", u, describe(key.units[u].alpha));
  }
}

bool parseCombiner(std::string_view, std::string_view, VertexKey&) {
  return false;
}
bool parseCombiner(std::string_view name, std::string_view value, FragmentKey& key) {
  for (int u = 0; u < kMaxTextureUnits; ++u) {
    if (name == fmt::format("rgb{}", u)) return parse(value, key.units[u].rgb);
    if (name == fmt::format("alpha{}", u)) return parse(value, key.units[u].alpha);
  }
  return false;
}

bool combinersInRange(const VertexKey&) {
  return true;
}
bool combinersInRange(const FragmentKey& key) {
  for (const FragmentUnit& unit : key.units)
    if (!inRange(unit.rgb) || !inRange(unit.alpha)) return false;
  return true;
}

// ---- Keys

template <class Key>
std::string describeKey(std::string_view stage, const Key& key) {
  std::string text(stage);
  visitFields(key, [&](const Field& field, auto value) {
    const int v = static_cast<int>(value);
    if (v == 0) return;
    text += ' ' + field.fullName();
    if (!field.words.empty())
      text += fmt::format("={}", field.words[v]);
    else if (field.most > 1)
      text += fmt::format("={}", v);
  });
  describeCombiners(key, text);
  return text;
}

int parseValue(const Field& field, std::string_view text) {
  if (!field.words.empty()) return find(field.words, text);
  if (field.most == 1) return text.empty() ? 1 : -1;
  int value = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? value : -1;
}

template <class Key>
bool parseToken(std::string_view token, Key& key) {
  const size_t equals = token.find('=');
  const std::string_view name = token.substr(0, equals);
  const std::string_view value = equals == std::string_view::npos ? "" : token.substr(equals + 1);
  bool found = false;
  visitFields(key, [&](const Field& field, auto& out) {
    if (found || field.fullName() != name) return;
    const int v = parseValue(field, value);
    if (v <= 0 || v > field.most) return;
    out = static_cast<std::remove_reference_t<decltype(out)>>(v);
    found = true;
  });
  return found || parseCombiner(name, value, key);
}

template <class Key>
bool parseKey(std::string_view stage, std::string_view text, Key& key) {
  Key parsed{};
  if (!text.starts_with(stage)) return false;
  text.remove_prefix(stage.size());
  while (!text.empty()) {
    if (text[0] != ' ') return false;
    text.remove_prefix(1);
    const std::string_view token = text.substr(0, text.find(' '));
    if (!parseToken(token, parsed)) return false;
    text.remove_prefix(token.size());
  }
  if (!valid(parsed)) return false;
  key = parsed;
  return true;
}

template <class Key>
bool fieldsInRange(const Key& key) {
  bool good = combinersInRange(key);
  visitFields(key,
              [&](const Field& field, auto value) { good = good && static_cast<int>(value) <= field.most; });
  return good;
}

template <class Key>
bool isReduced(const Key& key) {
  Key reduced = key;
  reduce(reduced);
  return reduced == key;
}

bool oneOf(Fetch fetch, std::initializer_list<Fetch> list) {
  return std::find(list.begin(), list.end(), fetch) != list.end();
}

bool fetchSuits(Attribute attribute, Fetch fetch) {
  if (oneOf(fetch, {Fetch::Unread, Fetch::Constant, Fetch::Float})) return true;
  switch (attribute) {
    case kNormal:
      return oneOf(fetch, {Fetch::Fixed, Fetch::NormedByte, Fetch::NormedShort});
    case kColor:
    case kPointSize:
      return fetch == Fetch::Fixed;
    case kMatrixIndex:
      return fetch == Fetch::Uint;
    case kWeight:
      return fetch == Fetch::Fixed;
    default:
      return oneOf(fetch, {Fetch::Fixed, Fetch::FixedW1, Fetch::Int, Fetch::IntW1});
  }
}

}  // namespace

std::string describe(const VertexKey& key) {
  return describeKey("vertex", key);
}
std::string describe(const FragmentKey& key) {
  return describeKey("fragment", key);
}
bool parse(const std::string& text, VertexKey& key) {
  return parseKey("vertex", text, key);
}
bool parse(const std::string& text, FragmentKey& key) {
  return parseKey("fragment", text, key);
}

bool valid(const VertexKey& key) {
  if (!fieldsInRange(key)) return false;
  for (int a = 0; a < kAttributeCount; ++a)
    if (!fetchSuits(static_cast<Attribute>(a), key.fetch[a])) return false;
  // Whatever is unread could have been fetched and reduced away; what is read stays, and differs.
  VertexKey fetched = key;
  for (Fetch& fetch : fetched.fetch)
    if (fetch == Fetch::Unread) fetch = Fetch::Constant;
  reduce(fetched);
  return fetched == key && isReduced(key);
}

bool valid(const FragmentKey& key) {
  return fieldsInRange(key) && isReduced(key);
}

uint64_t hash(const VertexKey& key) {
  return XXH3_64bits(&key, sizeof key);
}
uint64_t hash(const FragmentKey& key) {
  return XXH3_64bits(&key, sizeof key);
}

}  // namespace anteroom::gen
