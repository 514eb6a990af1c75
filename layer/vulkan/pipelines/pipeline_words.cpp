#include "layer/vulkan/pipelines/pipeline_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <span>
#include <string_view>
#include <type_traits>

#include "gen/words.h"

namespace anteroom::vulkan {
namespace {

using Words = std::span<const std::string_view>;

// By Vulkan's numbers.
constexpr auto kTopologies = gen::wordsTo<VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN>(
    "points", "lines", "line-strip", "triangles", "triangle-strip", "triangle-fan");
constexpr auto kCulls = gen::wordsTo<VK_CULL_MODE_FRONT_AND_BACK>("none", "front", "back", "both");
constexpr auto kFaces = gen::wordsTo<VK_FRONT_FACE_CLOCKWISE>("ccw", "cw");
constexpr auto kCompares = gen::wordsTo<VK_COMPARE_OP_ALWAYS>("never", "less", "equal", "lequal", "greater",
                                                              "notequal", "gequal", "always");
constexpr auto kStencilOps = gen::wordsTo<VK_STENCIL_OP_DECREMENT_AND_WRAP>(
    "keep", "zero", "replace", "incr", "decr", "invert", "incr-wrap", "decr-wrap");
constexpr auto kLogicOps = gen::wordsTo<VK_LOGIC_OP_SET>(
    "clear", "and", "and-reverse", "copy", "and-inverted", "noop", "xor", "or", "nor", "equiv", "invert",
    "or-reverse", "copy-inverted", "or-inverted", "nand", "set");
constexpr auto kFactors = gen::wordsTo<VK_BLEND_FACTOR_SRC_ALPHA_SATURATE>(
    "0", "1", "src-color", "1-src-color", "dst-color", "1-dst-color", "src-alpha", "1-src-alpha", "dst-alpha",
    "1-dst-alpha", "constant-color", "1-constant-color", "constant-alpha", "1-constant-alpha",
    "src-alpha-saturate");
constexpr auto kBlendOps = gen::wordsTo<VK_BLEND_OP_MAX>("add", "subtract", "reverse-subtract", "min", "max");
constexpr auto kLineModes = gen::wordsTo<VK_LINE_RASTERIZATION_MODE_RECTANGULAR_SMOOTH_EXT>(
    "default", "rectangular", "bresenham", "smooth");

// Of an attribute of ours.
constexpr uint32_t kMostLocation = gen::kOwnValuesLocation + gen::kMostOwnValues - 1;
static_assert(gen::kAttributeCount <= gen::kOwnValuesLocation && kMostLocation < 32);

struct Format {
  std::string_view name;
  VkFormat format;
};
#define FORMAT(name) \
  { #name, VK_FORMAT_##name }
constexpr Format kFormats[] = {FORMAT(R8G8B8A8_UNORM),
                               FORMAT(B8G8R8A8_UNORM),
                               FORMAT(R8G8B8A8_SRGB),
                               FORMAT(B8G8R8A8_SRGB),
                               FORMAT(R5G6B5_UNORM_PACK16),
                               FORMAT(R4G4B4A4_UNORM_PACK16),
                               FORMAT(A4R4G4B4_UNORM_PACK16_EXT),
                               FORMAT(B4G4R4A4_UNORM_PACK16),
                               FORMAT(R5G5B5A1_UNORM_PACK16),
                               FORMAT(A1R5G5B5_UNORM_PACK16),
                               FORMAT(A2B10G10R10_UNORM_PACK32),
                               FORMAT(R16G16B16A16_SFLOAT),
                               FORMAT(D16_UNORM),
                               FORMAT(X8_D24_UNORM_PACK32),
                               FORMAT(D32_SFLOAT),
                               FORMAT(S8_UINT),
                               FORMAT(D24_UNORM_S8_UINT),
                               FORMAT(D32_SFLOAT_S8_UINT),
                               FORMAT(R8_UNORM),
                               FORMAT(R8G8_UNORM),
                               FORMAT(R8G8B8_UNORM),
                               FORMAT(R8_UINT),
                               FORMAT(R8G8_UINT),
                               FORMAT(R8G8B8_UINT),
                               FORMAT(R8G8B8A8_UINT),
                               FORMAT(R8_SINT),
                               FORMAT(R8G8_SINT),
                               FORMAT(R8G8B8_SINT),
                               FORMAT(R8G8B8A8_SINT),
                               FORMAT(R16_SINT),
                               FORMAT(R16G16_SINT),
                               FORMAT(R16G16B16_SINT),
                               FORMAT(R16G16B16A16_SINT),
                               FORMAT(R32_SINT),
                               FORMAT(R32G32_SINT),
                               FORMAT(R32G32B32_SINT),
                               FORMAT(R32G32B32A32_SINT),
                               FORMAT(R32_SFLOAT),
                               FORMAT(R32G32_SFLOAT),
                               FORMAT(R32G32B32_SFLOAT),
                               FORMAT(R32G32B32A32_SFLOAT)};
#undef FORMAT

// Calls visit(name, words, most, value) for every field of a byte.
template <class State, class Visit>
void visitFields(State& s, Visit visit) {
  const auto field = [&](std::string_view name, auto& value, const auto& values) {
    if constexpr (std::is_same_v<std::decay_t<decltype(values)>, int>)
      visit(name, Words{}, static_cast<uint32_t>(values), value);
    else
      visit(name, Words(values), static_cast<uint32_t>(values.size()) - 1, value);
  };
#define BAKED_PART(member, word, values, primitives, place, command) field(word, s.member, values);
#include "layer/vulkan/pipelines/baked_state.inc"
}

std::string nameOf(uint32_t format) {
  for (const Format& known : kFormats)
    if (known.format == static_cast<VkFormat>(format)) return std::string(known.name);
  return std::to_string(format);
}

bool parseNumber(std::string_view text, uint32_t most, uint32_t& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && value <= most;
}

bool parseFormat(std::string_view text, uint32_t& format) {
  for (const Format& known : kFormats)
    if (known.name == text) return format = known.format, true;
  return false;
}

std::string wordsOf(const Features& f) {
  return fmt::format("{}{}{}{}", f.dynamicState1 ? "1" : "", f.dynamicState2 ? "2" : "",
                     f.dynamicState3 ? "3" : "", f.dynamicVertexInput ? "v" : "");
}

// "array4=R32G32_SFLOAT/8": location, format, stride in bytes.
bool parseArray(std::string_view name, std::string_view value, VertexLayout& layout) {
  if (layout.count == kMostArrays) return false;
  VertexLayout::Array& array = layout.arrays[layout.count++];
  const size_t slash = value.find('/');
  if (slash == std::string_view::npos || !parseNumber(name.substr(5), kMostLocation, array.location))
    return false;
  for (uint32_t i = 0; i + 1 < layout.count; ++i)
    if (layout.arrays[i].location == array.location) return false;
  return parseFormat(value.substr(0, slash), array.format) &&
         parseNumber(value.substr(slash + 1), 1 << 20, array.stride);
}

bool parseToken(std::string_view token, PipelineKey& key, DynamicStates& dynamic) {
  const size_t equals = token.find('=');
  const std::string_view name = token.substr(0, equals);
  const std::string_view value = equals == std::string_view::npos ? "1" : token.substr(equals + 1);
  if (name == "color") return parseFormat(value, key.colorFormat);
  if (name == "depth") return parseFormat(value, key.depthFormat);
  if (name == "samples") return parseNumber(value, 64, key.samples);
  if (name == "dynamic") {
    const auto has = [&](char c) { return value.find(c) != std::string_view::npos; };
    dynamic = {has('1'), has('2'), has('3'), has('v')};
    return value.find_first_not_of("123v") == std::string_view::npos;
  }
  if (name.starts_with("array")) return parseArray(name, value, key.layout);
  bool found = false;
  visitFields(key.state, [&](std::string_view field, Words words, uint32_t most, uint8_t& out) {
    if (field != name) return;
    uint32_t number = most + 1;
    for (uint32_t i = 0; i < words.size(); ++i)
      if (words[i] == value) number = i;
    found = words.empty() ? parseNumber(value, most, number) : number <= most;
    if (found) out = static_cast<uint8_t>(number);
  });
  return found;
}

}  // namespace

std::string describe(const PipelineKey& key, const Features& features) {
  std::string text;
  visitFields(key.state, [&](std::string_view name, Words words, uint32_t most, uint8_t value) {
    if (value == 0 && name != "primitive") return;
    text += fmt::format("{}{}", text.empty() ? "" : " ", name);
    if (!words.empty())
      text += fmt::format("={}", words[value]);
    else if (most > 1)
      text += fmt::format("={}", value);
  });
  if (key.colorFormat) text += " color=" + nameOf(key.colorFormat);
  if (key.depthFormat) text += " depth=" + nameOf(key.depthFormat);
  text += fmt::format(" samples={}", key.samples);
  for (uint32_t i = 0; i < key.layout.count; ++i) {
    const VertexLayout::Array& array = key.layout.arrays[i];
    text += fmt::format(" array{}={}/{}", array.location, nameOf(array.format), array.stride);
  }
  if (const std::string dynamic = wordsOf(features); !dynamic.empty()) text += " dynamic=" + dynamic;
  return text;
}

bool parse(const std::string& words, PipelineKey& key, DynamicStates& dynamic) {
  PipelineKey parsed;
  DynamicStates states;
  std::string_view text = words;
  while (!text.empty()) {
    const std::string_view token = text.substr(0, text.find(' '));
    if (!parseToken(token, parsed, states)) return false;
    text.remove_prefix(std::min(token.size() + 1, text.size()));
  }
  key = parsed;
  dynamic = states;
  return true;
}

bool feeds(const VertexLayout& layout, const gen::VertexKey& vertex, const gen::FragmentKey& fragment) {
  const auto classOf = [](uint32_t format) {
    const std::string name = nameOf(format);
    return name.ends_with("_SINT")   ? gen::InputClass::Int
           : name.ends_with("_UINT") ? gen::InputClass::Uint
                                     : gen::InputClass::Float;
  };
  uint32_t missing = gen::attributesRead(vertex);
  if (vertex.ownValues)
    for (uint32_t at = 0; at < gen::blocks(vertex, fragment).pushSize; at += 16)
      missing |= 1u << (gen::kOwnValuesLocation + at / 16);
  for (uint32_t i = 0; i < layout.count; ++i) {
    const VertexLayout::Array& array = layout.arrays[i];
    const gen::InputClass wanted = array.location < gen::kOwnValuesLocation
                                       ? gen::inputClass(vertex, static_cast<gen::Attribute>(array.location))
                                       : gen::InputClass::Float;
    if (missing >> array.location & 1 && classOf(array.format) == wanted) missing &= ~(1u << array.location);
  }
  return missing == 0;
}

}  // namespace anteroom::vulkan
