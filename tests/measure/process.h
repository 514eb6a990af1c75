// Fresh processes under another implementation.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace process {

using Environment = std::map<std::string, std::string>;  // added to or put in place of the inherited one

struct Outcome {
  int status = 0;      // exit status; 128 + signal when killed
  std::string output;  // standard output
};

// Runs `program` and waits; it is killed after 20 minutes, which is for programs that hang, not for slow
// ones. Throws std::system_error when it cannot be started.
Outcome run(const std::string& program, const std::vector<std::string>& arguments,
            const Environment& environment);

// A directory that is gone, with its contents, when this is.
class TemporaryDirectory {
 public:
  TemporaryDirectory();  // throws std::system_error
  ~TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

// The directory of this program's executable.
std::string executableDirectory();

}  // namespace process
