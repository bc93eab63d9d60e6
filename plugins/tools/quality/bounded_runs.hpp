// Bounded runs tell whether a bound cures drawings that the default strays far from.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/quality/runs.hpp"

namespace talweg::quality {

/// One drawing whose result at τ = 2 lies beyond 3 h₀, smoothed once more within 3 h₀.
struct BoundedRun {
  std::string mesh, drawing;
  double strayed = 0;    ///< h₀: the larger deviation without the bound
  double deviation = 0;  ///< h₀: the larger deviation with it
  double ratio = 0;      ///< total curvature after / before with it, as Run::ratio()
  std::size_t pins = 0;  ///< points of the drawing that the bound had to pin
  bool within = false;
};

/// `runs` are the subject's default runs. 20 to 60 smoothings for every run that strayed.
std::vector<BoundedRun> bounded_runs(const Subject& subject, std::span<const Run> runs,
                                     const CurveOptions& curve_options);

/// As Markdown: how many were cured at what price, then each.
std::string tables(std::span<const BoundedRun> runs);

}  // namespace talweg::quality
