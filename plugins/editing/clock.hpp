// The clock by which work is timed.
#pragma once

#include <chrono>

namespace talweg::editing {

/// The time in milliseconds since an arbitrary moment in the past. It never decreases.
inline double now_ms() {
  const auto since = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::milli>(since).count();
}

}  // namespace talweg::editing
