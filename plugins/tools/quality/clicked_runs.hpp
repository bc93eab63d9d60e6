// Measures splines through a few points of a drawing.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "tools/quality/runs.hpp"

namespace talweg::quality {

/// One spline at τ = 1. Lengths in h₀, the mean edge near the drawing through the clicks; angles in
/// radians.
struct ClickedRun {
  std::string mesh, drawing;
  std::size_t clicks = 0;
  double leg = 0;      ///< mean length of the geodesic legs
  double missed = 0;   ///< largest distance of a click from the result
  double bending = 0;  ///< of the result / of the taut curve, as if the drawing were a stroke
  double window_turning = 0, largest_turn = 0;
  double swing = 0;     ///< largest distance from the geodesic legs / length of the shorter
                        ///< adjacent leg
  double longer = 0;    ///< length / length of the geodesic legs
  double inserted = 0;  ///< movement of the curve when a point in its middle becomes a click
  double ms = 0;        ///< time of a new drawing and its result
  bool warned = false;
};

/// A run for every drawing that has at least three clicks (loops: four), at each 25th of its
/// vertices.
std::vector<ClickedRun> clicked_runs(const Subject& subject);

/// Markdown: a row for each mesh, and one for all.
std::string tables(std::span<const ClickedRun> runs);

}  // namespace talweg::quality
