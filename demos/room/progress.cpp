#include "progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace room {

Progress::Progress(std::string label, int total)
    : label_(std::move(label)), total_(total), terminal_(isatty(STDERR_FILENO) == 1) {
  if (!terminal_) return;
  fmt::print(stderr, "\r{} ...\033[K", label_);
  std::fflush(stderr);
}

Progress::~Progress() {
  if (terminal_) fmt::print(stderr, "\r\033[K");
}

void Progress::advance() {
  ++done_;
  const auto now = Clock::now();
  const auto since = std::chrono::duration<double>(now - shown_).count();
  if (total_ < 2 || since < (terminal_ ? 0.1 : 5.0)) return;
  shown_ = now;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  if (terminal_) {
    paintBar(seconds);
  } else {
    fmt::print(stderr, "{}: {} of {} frames, {:.0f} s\n", label_, done_, total_, seconds);
  }
}

void Progress::paintBar(double seconds) const {
  constexpr int kWidth = 40;
  const int full = kWidth * done_ / total_;
  const double left = seconds / done_ * (total_ - done_);
  fmt::print(stderr, "\r{} [{:=>{}}{:>{}}] {}/{}  {:.0f} s left\033[K", label_, "", full, "", kWidth - full,
             done_, total_, left);
  std::fflush(stderr);
}

}  // namespace room
