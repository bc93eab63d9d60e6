// Progress is a callback of the caller's, which hears how far a call is and may cancel it.
#pragma once

#include <cstddef>
#include <functional>
#include <utility>

namespace talweg {

/// Called from time to time with the stage's name and the done fraction in [0, 1]. Returning false
/// cancels the call, which then returns a typed result and stays usable.
using Progress = std::function<bool(const char* stage, double fraction)>;

/// True if the caller wants to go on. An empty callback never cancels.
inline bool go_on(const Progress& progress, const char* stage, double fraction) {
  return !progress || progress(stage, fraction);
}

/// Thrown by long work that is cancelled. Calls that return typed results catch it; functions that
/// let it through say so.
struct Cancelled {};

/// Asks a Progress at once and then at regular amounts of work. Work is counted, not timed, in
/// units of about a tenth of a microsecond, so that the Progress is asked about every millisecond.
class Asker {
 public:
  static constexpr std::size_t kEvery = 8192;  ///< units

  /// `fraction`: where the work begins that is asked about. Throws Cancelled, as all member
  /// functions that ask do.
  Asker(Progress progress, const char* stage, double fraction = 0)
      : progress_(std::move(progress)), stage_(stage), fraction_(fraction) {
    ask();
  }

  /// Reports the units of work done since the last call.
  void did(std::size_t units) {
    if (!progress_) return;
    if ((done_ += units) >= kEvery) ask();
  }
  /// Sets the fraction of the stage, in [0, 1], that later questions report.
  void is_at(double fraction) { fraction_ = fraction; }
  void ask() {
    done_ = 0;
    if (!go_on(progress_, stage_, fraction_)) throw Cancelled();
  }

 private:
  Progress progress_;
  const char* stage_;
  double fraction_;
  std::size_t done_ = 0;
};

}  // namespace talweg
