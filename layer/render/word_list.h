// Environment variables that hold words with commas between them: ANTEROOM_DEBUG, ANTEROOM_HUD and
// ANTEROOM_QUIRKS. Each knows `help`, too, which lists what it knows.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace anteroom::render {

struct WordList {
  struct Word {
    std::string text;     // as people write it: `name`, or `name[=VALUE]`
    std::string meaning;  // for `help`
  };
  const char* variable;
  std::vector<Word> words;  // in the order in which they are listed

  // Calls take() for each word of `text` that is neither empty nor `help`; it returns false for a word that
  // it does not know. Returns lines for stderr: about unknown words, and the list that `help` asks for; else
  // nothing.
  std::string read(std::string_view text, const std::function<bool(std::string_view word)>& take) const;

 private:
  std::string help() const;
  std::string known() const;
};

// What the variable holds. Nothing where it is not set, and in programs that run with another's rights.
std::string_view environmentWords(const char* variable);

}  // namespace anteroom::render
