#include "layer/render/debug_options.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>

namespace anteroom::render {
namespace {

// Takes what stands behind `=`, or nothing. False: it makes no sense.
using Take = bool (*)(DebugOptions& options, std::string_view value);

struct Word {
  std::string_view name;
  std::string_view value;  // how the list shows what may follow
  std::string_view meaning;
  Take take;
};

bool takeValidation(DebugOptions& options, std::string_view value) {
  using enum DebugOptions::Validation;
  options.validation = value == "fatal" ? Abort : Log;
  return value.empty() || value == "fatal";
}

bool takeGlsl(DebugOptions& options, std::string_view value) {
  options.glsl = true;
  options.glslFolder = value;
  return true;
}

bool takeCapture(DebugOptions& options, std::string_view value) {
  options.captureFrame = 1;
  if (value.empty()) return true;
  const char* const end = value.data() + value.size();
  const auto [stop, error] = std::from_chars(value.data(), end, options.captureFrame);
  if (error == std::errc() && stop == end && options.captureFrame > 0) return true;
  options.captureFrame = 0;
  return false;
}

template <bool DebugOptions::*kFlag>
bool takeFlag(DebugOptions& options, std::string_view value) {
  options.*kFlag = value.empty();
  return value.empty();
}

constexpr Word kWords[] = {
    {"capture", "[=N]", "RenderDoc captures the first frame, or the Nth", takeCapture},
    {"errors", "", "log every GL and EGL error with its command and reason", takeFlag<&DebugOptions::errors>},
    {"glsl", "[=FOLDER]", "log every shader, or write each to a file", takeGlsl},
    {"markers", "", "name Vulkan objects and group commands as the GL program does",
     takeFlag<&DebugOptions::markers>},
    {"stats", "", "log what a context has done when it ends", takeFlag<&DebugOptions::stats>},
    {"validation", "[=fatal]", "the Khronos validation layer; its first message aborts", takeValidation},
};

std::string listOfWords() {
  std::string list;
  for (const Word& word : kWords) list.append(list.empty() ? "" : ", ").append(word.name).append(word.value);
  return list + ", help";
}

std::string help() {
  std::string text = "anteroom: ANTEROOM_DEBUG takes, separated by commas:\n";
  for (const Word& word : kWords) {
    std::string shown = std::string(word.name) + std::string(word.value);
    shown.resize(20, ' ');
    text.append("  ").append(shown).append(word.meaning).append("\n");
  }
  return text;
}

// False: it is not one of kWords.
bool take(DebugOptions& options, std::string_view text) {
  const size_t equals = text.find('=');
  const std::string_view name = text.substr(0, equals);
  const std::string_view value = equals == text.npos ? std::string_view() : text.substr(equals + 1);
  for (const Word& word : kWords)
    if (word.name == name) return word.take(options, value);
  return false;
}

}  // namespace

DebugOptions parseDebugOptions(std::string_view words, std::string& complaint) {
  DebugOptions options;
  std::string unknown;
  while (!words.empty()) {
    const size_t comma = std::min(words.find(','), words.size());
    const std::string_view text = words.substr(0, comma);
    words.remove_prefix(std::min(comma + 1, words.size()));
    if (text == "help")
      complaint += help();
    else if (!text.empty() && !take(options, text))
      unknown.append(unknown.empty() ? "" : ", ").append(text);
  }
  if (!unknown.empty())
    complaint += "anteroom: ANTEROOM_DEBUG does not know " + unknown + "; it knows: " + listOfWords() + "\n";
  return options;
}

const DebugOptions& debugOptions() {
  // Never destroyed: contexts may end while the process ends.
  static const DebugOptions& options = *[] {
    const char* const words = secure_getenv("ANTEROOM_DEBUG");
    std::string complaint;
    auto* const parsed = new DebugOptions(parseDebugOptions(words ? words : "", complaint));
    if (!complaint.empty()) std::fputs(complaint.c_str(), stderr);
    return parsed;
  }();
  return options;
}

}  // namespace anteroom::render
