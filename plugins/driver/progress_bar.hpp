// A progress bar is shown on a terminal, and not when piped.
#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

#include "talweg/intrinsic/progress.hpp"

namespace talweg::driver {

/// A callback that draws a bar on stderr where that is a terminal and `quiet` is not set, and that
/// cancels when the user has pressed Ctrl-C.
Progress progress_bar(bool quiet);
/// A bar that counts work of a known number of pieces: how many are done and have failed, how fast,
/// and how long the rest takes at that rate. Any thread may call.
class CountedBar {
 public:
  CountedBar(std::size_t total, bool quiet);
  void done(bool failed);
  /// Lets the time go on while nothing is done.
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

/// What it says, without the bar itself: "12/500 (1 failed), 3.1/s, 2:37 left".
std::string count_text(std::size_t done, std::size_t failed, std::size_t total, double seconds);

/// Takes the bar off the terminal.
void clear_progress_bar();

}  // namespace talweg::driver
