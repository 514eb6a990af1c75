#include "options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

namespace program {
namespace {

// Two numbers with one character between them; nothing else in the text.
bool parsePair(const std::string& text, char between, int& a, int& b) {
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, a);
  if (first.ec != std::errc() || first.ptr == end || *first.ptr != between) return false;
  const auto second = std::from_chars(first.ptr + 1, end, b);
  return second.ec == std::errc() && second.ptr == end;
}

}  // namespace

Size parseSize(const std::string& text) {
  Size size{};
  if (!parsePair(text, 'x', size.width, size.height) || size.width < 1 || size.height < 1 ||
      size.width > 16384 || size.height > 16384) {
    throw UsageError(fmt::format("--size {}: expected WIDTHxHEIGHT in pixels, as in 640x480", text));
  }
  return size;
}

FrameRange parseFrames(const std::string& text) {
  constexpr int kMost = 10'000'000;
  FrameRange range{};
  if (parsePair(text, '-', range.first, range.last)) {
    if (range.first >= 0 && range.last >= range.first && range.last < kMost)
      return {range.first, range.last, true};
  } else {
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), range.last);
    const bool whole = parsed.ec == std::errc() && parsed.ptr == text.data() + text.size();
    if (whole && range.last > 0 && range.last <= kMost) return {0, range.last - 1, range.last > 1};
  }
  throw UsageError(fmt::format("--frames {}: expected a count, as in 60, or a range, as in 30-59", text));
}

std::vector<const room::DemoEntry*> chosenDemos(const std::vector<room::DemoEntry>& demos,
                                                const std::string& name) {
  std::vector<const room::DemoEntry*> chosen;
  std::vector<std::string_view> names;
  for (const room::DemoEntry& entry : demos) {
    names.push_back(entry.name);
    if (name == "all" || name == entry.name) chosen.push_back(&entry);
  }
  if (chosen.empty()) {
    throw UsageError(name.empty() ? fmt::format("which demo? There are: {}, or all", fmt::join(names, ", "))
                                  : fmt::format("there is no demo '{}'; there are: {}, or all", name,
                                                fmt::join(names, ", ")));
  }
  return chosen;
}

std::vector<std::string_view> chosenStages(const room::Demo& demo, std::string_view name,
                                           const std::string& stage) {
  const auto known = demo.stages();
  if (stage.empty()) return {known.back()};
  if (stage == "all") return {known.begin(), known.end()};
  if (const auto found = std::find(known.begin(), known.end(), stage); found != known.end()) return {*found};
  throw UsageError(
      fmt::format("{} has no stage '{}'; its stages are: {}, or all", name, stage, fmt::join(known, ", ")));
}

}  // namespace program
