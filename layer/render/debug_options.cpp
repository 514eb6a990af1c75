#include "layer/render/debug_options.h"

#include <charconv>
#include <cstdio>

#include "layer/render/word_list.h"

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

WordList wordList() {
  WordList list{"ANTEROOM_DEBUG", {}};
  for (const Word& word : kWords)
    list.words.push_back({std::string(word.name).append(word.value), std::string(word.meaning)});
  return list;
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
  complaint += wordList().read(words, [&](std::string_view word) { return take(options, word); });
  return options;
}

const DebugOptions& debugOptions() {
  // Never destroyed: contexts may end while the process ends.
  static const DebugOptions& options = *[] {
    std::string complaint;
    auto* const parsed = new DebugOptions(parseDebugOptions(environmentWords("ANTEROOM_DEBUG"), complaint));
    if (!complaint.empty()) std::fputs(complaint.c_str(), stderr);
    return parsed;
  }();
  return options;
}

}  // namespace anteroom::render
