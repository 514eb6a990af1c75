// What of this process is in memory, proc(5).
#pragma once

#include <cstdio>
#include <cstring>
#include <fstream>
#include <map>
#include <string>

// One line a file, in KiB; what is of no file is "anonymous". The last is the sum.
inline void printResident() {
  std::map<std::string, long> files;
  long sum = 0;
  std::string file;
  std::ifstream maps("/proc/self/smaps");
  for (std::string line; std::getline(maps, line);) {
    if (line.rfind("Rss:", 0) == 0) {
      const long size = std::stol(line.substr(4));
      files[file] += size;
      sum += size;
    } else if (const size_t dash = line.find('-'); dash != line.npos && dash < line.find(' ')) {
      const size_t slash = line.find('/');
      file = slash == line.npos ? "anonymous" : line.substr(line.rfind('/') + 1);
    }
  }
  for (const auto& [name, size] : files) std::printf("%ld %s\n", size, name.c_str());
  std::printf("%ld sum\n", sum);
}
