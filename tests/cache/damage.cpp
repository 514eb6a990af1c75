// Files that are not what they should be: never a crash, never SPIR-V that was not stored, and good again
// after.
#include <algorithm>

#include "layer/cache/database.h"
#include "tests/cache/rows.h"

namespace anteroom::test {
namespace {

constexpr int kRows = 4;

// A closed cache of kRows rows, all in the one file.
void fill(const std::filesystem::path& file) {
  cache::ShaderCache cache(file, kNoLimit);
  for (int i = 0; i < kRows; ++i) storeRow(cache, i);
}

// As a program does: look up, else store. How many were found; each of them right.
int use(cache::ShaderCache& cache) {
  int found = 0;
  for (int i = 0; i < kRows; ++i) {
    const auto spirv = findRow(cache, i);
    if (spirv.empty()) {
      storeRow(cache, i);
      continue;
    }
    ++found;
    EXPECT_EQ(spirv, spirvOf(i));
  }
  return found;
}

int useOnce(const std::filesystem::path& file) {
  cache::ShaderCache cache(file, kNoLimit);
  return use(cache);
}

// Damage that no look-up meets is met when rows are written.
bool repairs(const std::filesystem::path& file) {
  for (int i = 0; i < 3; ++i)
    if (useOnce(file) == kRows) return true;
  return false;
}

void run(const std::filesystem::path& file, const char* sql) {
  cache::Database database;
  ASSERT_EQ(database.open(file, SQLITE_OPEN_READWRITE, 1000), SQLITE_OK);
  ASSERT_EQ(database.run(sql), SQLITE_OK) << database.message();
}

void place(const std::filesystem::path& file, const std::string& bytes) {
  for (const char* suffix : {"-wal", "-shm", ".damaged"}) std::filesystem::remove(file.string() + suffix);
  replace(file, bytes);
}

TEST(Damage, EveryByteFlippedOnceGivesNoWrongShader) {
  const Folder folder;
  fill(folder.file());
  const std::string good = contents(folder.file());
  ASSERT_LT(good.size(), 64u << 10);
  int hits = 0;
  for (size_t at = 0; at < good.size(); ++at) {
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ (1 << at % 8));
    place(folder.file(), bad);
    cache::Store store;
    if (store.open(folder.file(), cache::Store::Mode::Write) != cache::Opened::Ok) continue;
    for (int i = 0; i < kRows; ++i) {
      const std::string key = keyText(i);
      std::vector<uint32_t> spirv;
      if (store.find(cache::KeyKind::VertexText, keyBytes(key), spirv) != cache::Found::Hit) continue;
      ++hits;
      ASSERT_EQ(spirv, spirvOf(i)) << "byte " << at;
    }
  }
  // Most bytes of a file are nobody's.
  EXPECT_GT(hits, static_cast<int>(good.size()));
}

TEST(Damage, IsRepaired) {
  const Folder folder;
  fill(folder.file());
  const std::string good = contents(folder.file());
  int repaired = 0;
  for (size_t at = 0; at < good.size(); at += at < 64 ? 4 : 97) {
    if (at == 60) continue;  // the version: Newer
    std::string bad = good;
    bad[at] = static_cast<char>(~bad[at]);
    place(folder.file(), bad);
    if (useOnce(folder.file()) < kRows) ++repaired;
    ASSERT_TRUE(repairs(folder.file())) << "byte " << at;
  }
  EXPECT_GT(repaired, 0);
}

TEST(Damage, TruncatedAndEmptyFiles) {
  const Folder folder;
  fill(folder.file());
  const std::string good = contents(folder.file());
  for (size_t size = 0; size < good.size(); size += size < 128 ? 32 : 1000) {
    place(folder.file(), good.substr(0, size));
    useOnce(folder.file());
    ASSERT_TRUE(repairs(folder.file())) << "cut to " << size;
  }
}

TEST(Damage, IsCountedARow) {
  const Folder folder;
  fill(folder.file());
  run(folder.file(),
      "UPDATE shader SET checksum = checksum + 1 WHERE id = (SELECT min(id) FROM shader);"
      "UPDATE shader SET spirv = zeroblob(length(spirv)) WHERE id = (SELECT max(id) FROM shader)");
  cache::ShaderCache cache(folder.file(), kNoLimit);
  EXPECT_EQ(use(cache), kRows - 2);
  EXPECT_EQ(cache.counts().damaged, 2u);
  cache.flush();
  EXPECT_EQ(use(cache), kRows);
  EXPECT_EQ(cache.counts().damaged, 2u);
}

TEST(Damage, AForeignFileIsKeptAside) {
  const Folder folder;
  const std::string poem(5000, 'x');
  replace(folder.file(), poem);
  cache::ShaderCache cache(folder.file(), kNoLimit);
  EXPECT_EQ(use(cache), 0);
  EXPECT_EQ(cache.counts().damaged, 1u);
  cache.flush();
  EXPECT_EQ(use(cache), kRows);
  EXPECT_EQ(contents(folder.file().string() + ".damaged"), poem);
}

TEST(Damage, SomebodyElsesDatabaseIsKeptAside) {
  const Folder folder;
  {
    cache::Database database;
    ASSERT_EQ(database.open(folder.file(), SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, 100), SQLITE_OK);
    ASSERT_EQ(database.run("CREATE TABLE shader(a); INSERT INTO shader VALUES(1)"), SQLITE_OK);
  }
  const std::string before = contents(folder.file());
  useOnce(folder.file());
  EXPECT_EQ(useOnce(folder.file()), kRows);
  EXPECT_EQ(contents(folder.file().string() + ".damaged"), before);
}

TEST(Damage, ANewerFileIsLeftAlone) {
  const Folder folder;
  fill(folder.file());
  run(folder.file(), "PRAGMA user_version = 3");
  testing::internal::CaptureStderr();
  {
    cache::ShaderCache cache(folder.file(), kNoLimit);
    EXPECT_EQ(use(cache), 0);
    cache.flush();
    EXPECT_EQ(use(cache), 0);
  }
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("newer version"), std::string::npos) << said;
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
  run(folder.file(), "PRAGMA user_version = 2");
  EXPECT_EQ(useOnce(folder.file()), kRows);
}

// As version 1 of the file was.
TEST(Damage, AnOlderFileIsBroughtUpToDate) {
  const Folder folder;
  fill(folder.file());
  run(folder.file(),
      "CREATE TABLE old(id INTEGER PRIMARY KEY, kind INTEGER NOT NULL, generator TEXT NOT NULL,"
      " created INTEGER NOT NULL, used INTEGER NOT NULL, uses INTEGER NOT NULL, compile_us INTEGER NOT NULL,"
      " checksum INTEGER NOT NULL, key BLOB NOT NULL, description TEXT NOT NULL, spirv BLOB NOT NULL,"
      " glsl TEXT NOT NULL);"
      "INSERT INTO old SELECT id, kind, generator, created, used, uses, compile_us, checksum, key, "
      "description,"
      " spirv, glsl FROM shader;"
      "DROP TABLE shader; DROP TABLE pipeline; DROP TABLE program; DROP TABLE usage;"
      "ALTER TABLE old RENAME TO shader; CREATE INDEX shader_used ON shader(used); PRAGMA user_version = 1");
  cache::Store store;
  EXPECT_EQ(store.open(folder.file(), cache::Store::Mode::Read), cache::Opened::Older);
  EXPECT_EQ(useOnce(folder.file()), kRows);
  EXPECT_EQ(store.open(folder.file(), cache::Store::Mode::Read), cache::Opened::Ok);
}

TEST(Damage, RowsOfAnotherGeneratorAreMadeAgain) {
  const Folder folder;
  fill(folder.file());
  run(folder.file(), "UPDATE shader SET generator = 'another', number = number + 1");
  cache::ShaderCache cache(folder.file(), kNoLimit);
  EXPECT_FALSE(cache.filled());
  EXPECT_EQ(use(cache), 0);
  cache.flush();
  EXPECT_EQ(use(cache), kRows);
  EXPECT_EQ(cache.counts().damaged, 0u);
  cache.close();
  cache::Store store;
  ASSERT_EQ(store.open(folder.file(), cache::Store::Mode::Read), cache::Opened::Ok);
  EXPECT_EQ(store.database().ask("SELECT count(*) FROM shader WHERE generator = 'another'", 0), kRows);
}

}  // namespace
}  // namespace anteroom::test
