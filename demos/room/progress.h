// A progress bar on stderr.
#pragma once

#include <chrono>
#include <string>

namespace room {

// On a terminal shows what is going on from the start, and how far it is; elsewhere tells it in plain lines
// when a run of many frames has taken longer than a few seconds.
class Progress {
 public:
  Progress(std::string label, int total);
  ~Progress();
  void advance();

 private:
  void paintBar(double seconds) const;

  using Clock = std::chrono::steady_clock;
  std::string label_;
  int total_;
  int done_ = 0;
  bool terminal_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point shown_ = start_;
};

}  // namespace room
