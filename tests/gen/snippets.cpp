// Every snippet says which names it expects, and is one function of the file's name.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>

#include "gen/gen.h"
#include "gen/snippets.h"

namespace anteroom::gen {
namespace {

std::string withoutComments(std::string_view text) {
  return std::regex_replace(std::string(text), std::regex("//[^\n]*"), "");
}

std::set<std::string> identifiers(const std::string& text) {
  std::set<std::string> names;
  const std::regex word(R"([A-Za-z_]\w*)");
  for (std::sregex_iterator it(text.begin(), text.end(), word), end; it != end; ++it) names.insert(it->str());
  return names;
}

bool compiles(const std::string& functions) {
  return !compile(Stage::Fragment, "#version 450\n" + functions + "void main() {}\n").spirv.empty();
}

std::string withExpected(const Snippet& snippet, std::string_view leftOut) {
  std::string text;
  for (std::string_view name : expectations(snippet))
    if (name != leftOut) text += withExpected(*findSnippet(name), "");
  return text + std::string(body(snippet));
}

TEST(Snippets, AllFilesAreEmbedded) {
  size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(ANTEROOM_SOURCE_DIR "/shaders"))
    files += entry.path().extension() == ".glsl";
  EXPECT_EQ(files, snippets().size());
  EXPECT_GT(files, 15u);
  EXPECT_TRUE(std::is_sorted(snippets().begin(), snippets().end(),
                             [](const Snippet& a, const Snippet& b) { return a.function < b.function; }));
  for (const Snippet& snippet : snippets()) EXPECT_EQ(findSnippet(snippet.function), &snippet);
  EXPECT_EQ(findSnippet("noSuchSnippet"), nullptr);
}

TEST(Snippets, DefineTheFunctionOfTheirName) {
  for (const Snippet& snippet : snippets()) {
    const std::regex head("\\n(float|int|vec[234]) " + std::string(snippet.function) + "\\(");
    EXPECT_TRUE(std::regex_search(std::string(snippet.text), head)) << snippet.text;
  }
}

TEST(Snippets, ExpectExactlyTheSnippetsTheyCall) {
  for (const Snippet& snippet : snippets()) {
    EXPECT_TRUE(snippet.text.starts_with("// Expects: ")) << snippet.text;
    const std::set<std::string> words = identifiers(withoutComments(body(snippet)));
    std::set<std::string> called, listed;
    for (const Snippet& other : snippets())
      if (&other != &snippet && words.contains(std::string(other.function))) called.emplace(other.function);
    for (std::string_view name : expectations(snippet)) listed.emplace(name);
    EXPECT_EQ(called, listed) << snippet.function;
  }
}

// With what it lists a snippet compiles; it needs every name of the list, and no other.
TEST(Snippets, CompileWithWhatTheyExpect) {
  for (const Snippet& snippet : snippets()) {
    EXPECT_TRUE(compiles(withExpected(snippet, ""))) << snippet.text;
    for (std::string_view name : expectations(snippet))
      EXPECT_FALSE(compiles(withExpected(snippet, name))) << name;
  }
}

}  // namespace
}  // namespace anteroom::gen
