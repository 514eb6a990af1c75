// What `anteroom-cache` can do. Every command returns an exit status.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace anteroom::inspect {

// 0: done. 1: the answer is no (rows are bad, keys differ, nothing was found). 2: the command line is wrong.
// 3: no file. 4: the file is not a cache, damaged, or of another version. 5: it cannot be read or written.
enum Status { kDone = 0, kNo = 1, kUsage = 2, kMissing = 3, kNotACache = 4, kUnusable = 5 };

struct Settings {
  std::string file;
  bool json = false;
  bool color = false;  // GLSL and assembly for a terminal
};

Status list(const Settings& settings, const std::string& sort, size_t most, bool pipelines);
Status show(const Settings& settings, const std::string& key);
Status diff(const Settings& settings, const std::string& first, const std::string& second);
Status stats(const Settings& settings);
// Why there are as many pipelines as there are: of one program's, or of all.
Status explain(const Settings& settings, const std::string& program);
// Compiles every key again, and compares.
Status verify(const Settings& settings, bool repair);
Status prune(const Settings& settings, uint64_t bytes, int unusedDays);
// Keys as text; import compiles them, so that no machine trusts another's SPIR-V.
Status exportKeys(const Settings& settings, const std::string& to);
Status importKeys(const Settings& settings, const std::string& from);
// The good rows of all of `from`.
Status merge(const Settings& settings, const std::vector<std::string>& from);
// Every shader for this version, every pipeline for this machine's Vulkan device (empty: the best one).
Status warm(const Settings& settings, const std::string& device);
// One page that needs nothing else.
Status report(const Settings& settings, const std::string& to);

}  // namespace anteroom::inspect
