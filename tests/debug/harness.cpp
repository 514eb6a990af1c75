#include "tests/debug/harness.h"

#include <fstream>
#include <iterator>
#include <sstream>

namespace anteroom::test {

Ended runProgram(const std::vector<std::string>& arguments, const process::Environment& environment) {
  std::vector<std::string> words{"-c", "exec \"$0\" \"$@\" 2>&1", PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  process::Environment all{{"ANTEROOM_CACHE", "off"}, {"ANTEROOM_DEBUG", "validation=fatal"}};
  for (const auto& [name, value] : environment) all[name] = value;
  const process::Outcome outcome = process::run("/bin/sh", words, all);
  return {outcome.status, outcome.output};
}

process::Environment recorded(const std::string& log, process::Environment more) {
  more["VK_ADD_LAYER_PATH"] = LAYER_FOLDER;
  more["VK_INSTANCE_LAYERS"] = "VK_LAYER_KHRONOS_validation:VK_LAYER_ANTEROOM_recording";
  more["RECORDING_LAYER_LOG"] = log;
  more["ANTEROOM_QUIRKS"] = "-command-labels";  // they end in that layer
  return more;
}

std::string contentsOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

size_t countOf(const std::string& text, const std::string& part) {
  size_t count = 0;
  for (size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
  return count;
}

}  // namespace anteroom::test
