#include "tests/measure/implementations.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace measure {
namespace {

TEST(Implementations, OfFoldersAndVariables) {
  const process::TemporaryDirectory folder;
  EXPECT_THROW(fromFolder("other=" + folder.path()), std::invalid_argument) << "no library there";
  std::ofstream(folder.path() + "/libEGL.so.1") << "library";
  const Implementation other = fromFolder("other=" + folder.path());
  EXPECT_EQ(other.name, "other");
  EXPECT_EQ(other.environment, (process::Environment{{"LD_LIBRARY_PATH", folder.path()}}));
  for (const char* text : {"", "other", "=folder"}) EXPECT_THROW(fromFolder(text), std::invalid_argument);

  const Implementation variables = fromVariables("slow:A=1,B=x=y");
  EXPECT_EQ(variables.name, "slow");
  EXPECT_EQ(variables.environment, (process::Environment{{"A", "1"}, {"B", "x=y"}}));
  EXPECT_THROW(fromVariables("slow:A"), std::invalid_argument);
  EXPECT_THROW(fromVariables("slow"), std::invalid_argument);
}

TEST(Implementations, CachesAreOffOrOfThisRunAlone) {
  const process::TemporaryDirectory folder;
  const process::Environment cold = withoutCaches({{"A", "1"}, {"ANTEROOM_CACHE", "on"}});
  EXPECT_EQ(cold.at("A"), "1");
  EXPECT_EQ(cold.at("ANTEROOM_CACHE"), "off");
  EXPECT_EQ(cold.at("MESA_SHADER_CACHE_DISABLE"), "true");
  const process::Environment warm = withCaches(cold, folder.path());
  EXPECT_EQ(warm.at("ANTEROOM_CACHE"), "on");
  EXPECT_EQ(warm.at("MESA_SHADER_CACHE_DISABLE"), "false");
  for (const char* cache : {"ANTEROOM_CACHE_DIR", "MESA_SHADER_CACHE_DIR"}) {
    EXPECT_TRUE(warm.at(cache).starts_with(folder.path()));
    EXPECT_TRUE(std::filesystem::is_directory(warm.at(cache))) << cache;
  }
}

TEST(Implementations, TakeTurnsAndBeginInTurns) {
  std::vector<std::size_t> order;
  for (std::size_t round = 0; round < 3; ++round)
    takeTurns(round, 3, [&](std::size_t i) { order.push_back(i); });
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 1, 2, 0, 2, 0, 1}));
}

}  // namespace
}  // namespace measure
