// A progress bar is drawn on a terminal only, never into a pipe or file.
#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

#include "talweg/intrinsic/progress.hpp"

namespace talweg::driver {

/// A callback that draws a bar on stderr if that is a terminal and `quiet` is not set, and that
/// cancels after the user has pressed Ctrl-C.
Progress progress_bar(bool quiet);
/// A bar that counts pieces of work: how many of the total are done and have failed, the rate, and
/// the remaining time at that rate. May be called from any thread.
class CountedBar {
 public:
  CountedBar(std::size_t total, bool quiet);
  void done(bool failed);
  /// Updates the displayed time while no piece is finished.
  void tick();

 private:
  void draw();

  std::mutex mutex_;
  std::size_t total_;
  std::size_t done_ = 0;
  std::size_t failed_ = 0;
  bool visible_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point next_;
};

/// The text of the bar: "12/500 (1 failed), 3.1/s, 2:37 left".
std::string count_text(std::size_t done, std::size_t failed, std::size_t total, double seconds);

/// Removes the bar from the terminal.
void clear_progress_bar();

}  // namespace talweg::driver
