// Progress is a callback of the caller's, which hears how far a call is and may cancel it.
#pragma once

#include <cstddef>
#include <functional>
#include <utility>

namespace talweg {

/// Called from time to time with the stage's name and the done fraction in [0, 1].
/// Returning false cancels; the call that was cancelled returns a typed result and stays usable.
using Progress = std::function<bool(const char* stage, double fraction)>;

/// True when the caller asks to go on. An empty callback never cancels.
inline bool go_on(const Progress& progress, const char* stage, double fraction) {
  return !progress || progress(stage, fraction);
}

/// What leaves long work that was cancelled in its middle. The calls that return typed results
/// catch it; functions that let it out say so.
struct Cancelled {};

/// Asks a Progress at once and then once in so much work. Work is counted, not timed: in units of
/// about a tenth of a microsecond, so that a question comes about every millisecond.
class Asker {
 public:
  static constexpr std::size_t kEvery = 8192;  ///< units

  /// Throws Cancelled, as all of these do.
  Asker(Progress progress, const char* stage) : progress_(std::move(progress)), stage_(stage) {
    ask();
  }

  /// So much has been done since the last call.
  void did(std::size_t units) {
    if (!progress_) return;
    if ((done_ += units) >= kEvery) ask();
  }
  /// How far the stage is, in [0, 1], for the questions to come.
  void is_at(double fraction) { fraction_ = fraction; }
  void ask() {
    done_ = 0;
    if (!go_on(progress_, stage_, fraction_)) throw Cancelled();
  }

 private:
  Progress progress_;
  const char* stage_;
  double fraction_ = 0;
  std::size_t done_ = 0;
};

}  // namespace talweg
