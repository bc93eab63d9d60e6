// Goals for the results, beside the measured values.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/quality/clicked_runs.hpp"
#include "tools/quality/hand_runs.hpp"
#include "tools/quality/runs.hpp"

namespace talweg::quality {

struct Goal {
  std::string what, asked, reached;
  bool met = false;
};

/// The goals of the default settings. Goals without measured values are left out.
std::vector<Goal> goals(std::span<const Run> runs, std::span<const Sweep> sweeps,
                        std::span<const Subdivision> subdivisions,
                        std::span<const ClickedRun> clicked = {},
                        std::span<const HandRun> hands = {});

/// The goals as a table in Markdown.
std::string tables(std::span<const Goal> goals);

}  // namespace talweg::quality
