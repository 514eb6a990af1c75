// Where no cache can be: the program draws all the same, and one line says why.
#include <sys/mount.h>

#include <algorithm>

#include "tests/cache/rows.h"

namespace anteroom::test {
namespace {

std::string saidBy(const std::filesystem::path& file, int rows) {
  testing::internal::CaptureStderr();
  {
    cache::ShaderCache cache(file, kNoLimit);
    for (int i = 0; i < rows; ++i) {
      const auto found = findRow(cache, i);
      if (found.empty())
        storeRow(cache, i, 1000);
      else
        EXPECT_EQ(found, spirvOf(i, 1000));
      if (i % 8 == 0) cache.flush();
    }
  }
  return testing::internal::GetCapturedStderr();
}

void expectOneLine(const std::string& said) {
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
  EXPECT_TRUE(said.starts_with("anteroom: no shader cache: ")) << said;
}

TEST(Places, BelowAFile) {
  const Folder folder;
  replace(folder.path / "file", "x");
  expectOneLine(saidBy(folder.path / "file" / "anteroom.db", 20));
}

TEST(Places, InAFolderThatCannotBeWritten) {
  expectOneLine(saidBy("/proc/anteroom/anteroom.db", 20));
}

TEST(Places, AFolderInItsPlace) {
  const Folder folder;
  std::filesystem::create_directories(folder.file());
  expectOneLine(saidBy(folder.file(), 20));
}

TEST(Places, FoldersAreMade) {
  const Folder folder;
  const auto file = folder.path / "a" / "b" / "anteroom.db";
  EXPECT_EQ(saidBy(file, 20), "");
  EXPECT_EQ(saidBy(file, 20), "");
  EXPECT_EQ(std::filesystem::status(file.parent_path()).permissions(), std::filesystem::perms::owner_all);
}

TEST(Places, AFullDisk) {
  const Folder folder;
  if (mount("none", folder.path.c_str(), "tmpfs", 0, "size=256k") != 0)
    GTEST_SKIP() << "a file system cannot be mounted here";
  expectOneLine(saidBy(folder.file(), 200));
  umount(folder.path.c_str());
}

TEST(Places, NoHome) {
  const Output output =
      runProgram(CACHE_PROGRAM, {"ANTEROOM_CACHE", "ANTEROOM_CACHE_DIR", "XDG_CACHE_HOME", "HOME"});
  EXPECT_EQ(output.status, 0);
  EXPECT_NE(output.out.find("cached 0"), std::string::npos) << output.out;
  expectOneLine(output.err);
}

TEST(Places, TheEnvironmentSaysWhere) {
  const Folder folder;
  const std::string home = folder.path, cache = folder.path / "xdg";
  const std::vector<std::string> environment{"ANTEROOM_CACHE", "ANTEROOM_CACHE_DIR", "HOME=" + home};
  auto run = [&](std::vector<std::string> more) {
    more.insert(more.begin(), environment.begin(), environment.end());
    EXPECT_EQ(runProgram(CACHE_PROGRAM, more).status, 0);
  };
  run({"XDG_CACHE_HOME=" + cache});
  EXPECT_TRUE(std::filesystem::exists(folder.path / "xdg" / "anteroom" / "anteroom.db"));
  EXPECT_FALSE(std::filesystem::exists(folder.path / ".cache"));
  run({"XDG_CACHE_HOME=relative", "MESA_SHADER_CACHE_DISABLE=true"});
  EXPECT_TRUE(std::filesystem::exists(folder.path / ".cache" / "anteroom" / "anteroom.db"));
}

}  // namespace
}  // namespace anteroom::test
