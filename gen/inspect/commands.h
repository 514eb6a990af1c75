// What `anteroom-cache` can do. Every command returns an exit status.
#pragma once

#include <string>
#include <vector>

#include "gen/cache/store.h"

namespace anteroom::inspect {

// 0: done. 1: the answer is no (rows are bad, keys differ, nothing was found). 2: the command line is wrong.
// 3: no file. 4: the file is not a cache, damaged, or of a newer version. 5: it cannot be read or written.
enum Status { kDone = 0, kNo = 1, kUsage = 2, kMissing = 3, kNotACache = 4, kUnusable = 5 };

struct Listed {
  int64_t id = 0;
  gen::Row row;
  std::string why;  // empty: a good row
};

struct Settings {
  std::string file;
  bool json = false;
};

// Opens, or says on stderr what is wrong.
Status open(const std::string& file, gen::Store::Mode mode, gen::Store& store);
Status readRows(const std::string& file, std::vector<Listed>& rows);

Status list(const Settings& settings, const std::string& sort, size_t most);
Status show(const Settings& settings, const std::string& key);
Status diff(const Settings& settings, const std::string& first, const std::string& second);
Status stats(const Settings& settings);
Status explain(const Settings& settings);
// Compiles every key again, and compares.
Status verify(const Settings& settings, bool repair);
Status prune(const Settings& settings, uint64_t bytes, int unusedDays);
// Keys as text; import compiles them, so that no machine trusts another's SPIR-V.
Status exportKeys(const Settings& settings, const std::string& to);
Status importKeys(const Settings& settings, const std::string& from);
// The good rows of all of `from`.
Status merge(const Settings& settings, const std::vector<std::string>& from);

}  // namespace anteroom::inspect
