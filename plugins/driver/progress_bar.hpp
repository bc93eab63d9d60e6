// A progress bar on a terminal, nothing when piped.
#pragma once

#include "talweg/intrinsic/progress.hpp"

namespace talweg::driver {

/// A callback that draws a bar on stderr where that is a terminal and `quiet` is not set, and that
/// cancels when the user has pressed Ctrl-C.
Progress progress_bar(bool quiet);
/// Takes the bar off the terminal.
void clear_progress_bar();

}  // namespace talweg::driver
