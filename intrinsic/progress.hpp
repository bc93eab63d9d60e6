// Progress and cancellation, handed down by the caller.
#pragma once

#include <functional>

namespace talweg {

/// Called from time to time with the stage's name and the done fraction in [0, 1].
/// Returning false cancels; the call that was cancelled returns a typed result and stays usable.
using Progress = std::function<bool(const char* stage, double fraction)>;

/// True when the caller asks to go on. An empty callback never cancels.
inline bool go_on(const Progress& progress, const char* stage, double fraction) {
  return !progress || progress(stage, fraction);
}

}  // namespace talweg
