#include "layer/egl/hud.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstring>

#include "layer/render/word_list.h"

namespace anteroom::egl {
namespace {

constexpr int kNameColumns = 10;
constexpr double kInterval = 0.5;         // seconds: numbers that change faster cannot be read
constexpr float kGoodTime = 1000 / 60.f;  // ms

struct ItemText {
  std::string_view name;
  HudItem item;
  bool usual;
  std::string_view meaning;
};
constexpr ItemText kItems[] = {
    {"fps", HudItem::Fps, true, "frames a second"},
    {"frame", HudItem::Frame, true, "time of a frame, with a graph; the line is at 1/60 s"},
    {"draws", HudItem::Draws, true, "draws a frame"},
    {"passes", HudItem::Passes, false, "render passes a frame"},
    {"submits", HudItem::Submits, false, "submissions a frame"},
    {"pipelines", HudItem::Pipelines, true, "pipelines made so far"},
    {"compiles", HudItem::Compiles, true, "shaders compiled so far"},
    {"cache", HudItem::Cache, false, "shaders from the cache so far"},
    {"memory", HudItem::Memory, false, "device memory"},
    {"uploads", HudItem::Uploads, false, "texels uploaded a frame"},
};

render::WordList wordList() {
  render::WordList list{"ANTEROOM_HUD", {}};
  for (const ItemText& item : kItems)
    list.words.push_back({std::string(item.name), std::string(item.meaning)});
  list.words.push_back({"1", "fps, frame, draws, pipelines and compiles"});
  list.words.push_back({"all", "all of these"});
  list.words.push_back({"pbuffers", "over the pictures of pbuffers, too, where programs read it"});
  return list;
}

// False: it is not known.
bool take(HudOptions& options, std::string_view word) {
  const auto add = [&](HudItem item) {
    if (std::find(options.items.begin(), options.items.end(), item) == options.items.end())
      options.items.push_back(item);
  };
  bool known = word == "1" || word == "all";
  for (const ItemText& item : kItems) {
    const bool wanted = word == item.name || word == "all" || (word == "1" && item.usual);
    if (wanted) add(item.item);
    known |= wanted;
  }
  if (word == "pbuffers") options.pbuffers = known = true;
  return known || word == "0" || word == "off";
}

// `value` to the right end of the line.
[[gnu::format(printf, 2, 3)]] void putValue(render::Hud::Line& line, const char* format, ...) {
  char value[render::Hud::kColumns - kNameColumns + 1];
  va_list arguments;
  va_start(arguments, format);
  const int length = std::vsnprintf(value, sizeof value, format, arguments);
  va_end(arguments);
  const size_t shown = std::min(static_cast<size_t>(std::max(length, 0)), sizeof value - 1);
  std::fill(line.begin() + kNameColumns, line.end(), ' ');
  std::memcpy(line.data() + line.size() - shown, value, shown);
}

void putBytes(render::Hud::Line& line, double bytes) {
  if (bytes >= 1 << 20)
    putValue(line, "%.1f MiB", bytes / (1 << 20));
  else
    putValue(line, "%.1f KiB", bytes / 1024);
}

}  // namespace

HudOptions parseHudOptions(std::string_view words, std::string& complaint) {
  HudOptions options;
  complaint += wordList().read(words, [&](std::string_view word) { return take(options, word); });
  return options;
}

const HudOptions& hudOptions() {
  // Never destroyed: surfaces may be made while the process ends.
  static const HudOptions& options = *[] {
    std::string complaint;
    auto* const parsed = new HudOptions(parseHudOptions(render::environmentWords("ANTEROOM_HUD"), complaint));
    if (!complaint.empty()) std::fputs(complaint.c_str(), stderr);
    return parsed;
  }();
  return options;
}

std::unique_ptr<Hud> createHud(bool window) {
  const HudOptions& options = hudOptions();
  if (options.items.empty() || !(window || options.pbuffers)) return nullptr;
  return std::make_unique<Hud>(options);
}

Hud::Hud(const HudOptions& options) : items_(options.items) {
  static_assert(std::size(kItems) <= render::Hud::kMostLines);
  picture_.lines = static_cast<int>(items_.size());
  picture_.nameColumns = kNameColumns;
  for (size_t i = 0; i < items_.size(); ++i) {
    render::Hud::Line& line = picture_.text[i];
    line.fill(' ');
    const std::string_view name = std::ranges::find(kItems, items_[i], &ItemText::item)->name;
    std::copy(name.begin(), name.end(), line.begin());
    if (items_[i] == HudItem::Frame) picture_.graphLine = static_cast<int>(i);
  }
}

void Hud::frame(const render::Stats& stats, const void* context, Clock::time_point now) {
  const auto seconds = [](Clock::duration time) { return std::chrono::duration<double>(time).count(); };
  if (context != context_) {
    // The first frame of a context shows what all frames of its past have cost, but not in what time.
    context_ = context;
    base_ = {};
    start_ = last_ = now;
    frames_ = 0;
    written_ = false;
  } else {
    noteTime(static_cast<float>(seconds(now - last_) * 1000));
  }
  last_ = now;
  ++frames_;
  const double interval = seconds(now - start_);
  if (written_ && interval < kInterval) return;
  write(stats, interval);
  written_ = true;
  base_ = stats;
  start_ = now;
  frames_ = 0;
}

void Hud::noteTime(float milliseconds) {
  std::move(times_.begin() + 1, times_.end(), times_.begin());
  times_.back() = milliseconds;
  if (picture_.graphLine < 0) return;
  const float longest = *std::max_element(times_.begin(), times_.end());
  float top = 2 * kGoodTime;
  while (top < longest && top < 1e6f) top *= 2;
  for (size_t i = 0; i < times_.size(); ++i) picture_.graph[i] = std::min(times_[i] / top, 1.0f);
  picture_.graphMark = kGoodTime / top;
}

void Hud::write(const render::Stats& stats, double seconds) {
  for (size_t i = 0; i < items_.size(); ++i) writeLine(i, stats, seconds);
}

void Hud::writeLine(size_t index, const render::Stats& stats, double seconds) {
  render::Hud::Line& line = picture_.text[index];
  const auto aFrame = [&](uint64_t render::Stats::*count) {
    return static_cast<double>(stats.*count - base_.*count) / frames_;
  };
  switch (items_[index]) {
    case HudItem::Fps:
      return seconds > 0 ? putValue(line, "%.1f", frames_ / seconds) : putValue(line, "-");
    case HudItem::Frame:
      return seconds > 0 ? putValue(line, "%.1f ms", 1000 * seconds / frames_) : putValue(line, "-");
    case HudItem::Draws:
      return putValue(line, "%.0f", aFrame(&render::Stats::draws));
    case HudItem::Passes:
      return putValue(line, "%.0f", aFrame(&render::Stats::renderPasses));
    case HudItem::Submits:
      return putValue(line, "%.0f", aFrame(&render::Stats::submits));
    case HudItem::Pipelines:
      return putValue(line, "%.0f", static_cast<double>(stats.pipelinesCreated));
    case HudItem::Compiles:
      return putValue(line, "%.0f", static_cast<double>(stats.shadersCompiled));
    case HudItem::Cache:
      return putValue(line, "%.0f", static_cast<double>(stats.shadersFromCache));
    case HudItem::Memory:
      return putBytes(line, static_cast<double>(stats.memoryBytes));
    case HudItem::Uploads:
      return putBytes(line, aFrame(&render::Stats::bytesUploaded));
  }
}

}  // namespace anteroom::egl
