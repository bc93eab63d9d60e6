// Measures whether a bound keeps curves close whose default results lie far from the drawing.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/quality/runs.hpp"

namespace talweg::quality {

/// A drawing whose result at τ = 2 is farther than 3 h₀, smoothed again with the bound 3 h₀.
struct BoundedRun {
  std::string mesh, drawing;
  double strayed = 0;    ///< h₀: the larger deviation without the bound, of both directions
  double deviation = 0;  ///< h₀: the larger deviation with the bound
  double ratio = 0;      ///< total curvature after / before with the bound, as Run::ratio()
  std::size_t pins = 0;  ///< points of the drawing that the bound had to pin
  bool within = false;
};

/// `runs` are the subject's default runs. Takes 20 to 60 smoothings for every run beyond 3 h₀.
std::vector<BoundedRun> bounded_runs(const Subject& subject, std::span<const Run> runs,
                                     const CurveOptions& curve_options);

/// Markdown: the number of runs that the bound cured with their change of curvature, and a row for
/// each.
std::string tables(std::span<const BoundedRun> runs);

}  // namespace talweg::quality
