#pragma once

#include <cstdint>
#include <ctime>

namespace bench {

using Nanoseconds = std::int64_t;

// Time that passes for everybody, or that all threads of this process spend on a processor.
enum class Clock { kWall, kProcessor };

inline Nanoseconds now(Clock clock) {
  timespec time;
  clock_gettime(clock == Clock::kWall ? CLOCK_MONOTONIC : CLOCK_PROCESS_CPUTIME_ID, &time);
  return Nanoseconds{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

class Stopwatch {
 public:
  explicit Stopwatch(Clock clock) : Stopwatch(clock, now(clock)) {}
  Stopwatch(Clock clock, Nanoseconds start) : clock_(clock), start_(start) {}
  double milliseconds() const { return double(now(clock_) - start_) / 1e6; }

 private:
  Clock clock_;
  Nanoseconds start_;
};

}  // namespace bench
