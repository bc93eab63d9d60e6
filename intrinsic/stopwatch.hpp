// A stopwatch measures elapsed time.
#pragma once

#include <chrono>

namespace talweg {

class Stopwatch {
 public:
  /// Milliseconds since construction, or since the last lap.
  [[nodiscard]] double ms() const {
    return std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
  }
  /// Like ms(), and starts a new lap.
  double lap() {
    const Clock::time_point now = Clock::now();
    const std::chrono::duration<double, std::milli> passed = now - start_;
    start_ = now;
    return passed.count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

}  // namespace talweg
