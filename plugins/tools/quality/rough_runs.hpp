// Rough runs measure what curves through clicks become when the mesh gets rough.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/quality/runs.hpp"

namespace talweg::quality {

/// One curve through clicks on a mesh with noise along its normals, beside that on the mesh as it
/// is. All is measured on the latter, where the same points of the same faces lie; lengths in h₀.
struct RoughRun {
  std::string mesh, drawing;
  double roughness = 0;  ///< standard deviation of the noise
  double told = 0;       ///< roughness_near in the report
  double bending = 0;    ///< in windows of 2 h₀, over that of the curve on the mesh as it is
  double swing = 0;      ///< farthest from the straight legs, over the same of that curve
  double apart = 0;      ///< from that curve, both ways
  double time = 0;       ///< of a new drawing and its result, over the same; the ground was there
  bool warned = false;
};

/// The longest open and closed drawings as clicks, every 25th vertex, at roughness 0.1 to 1.
std::vector<RoughRun> rough_runs(const Subject& subject, std::span<const NamedPath> drawings);

/// As Markdown: a row for each roughness.
std::string tables(std::span<const RoughRun> runs);
std::string csv(std::span<const RoughRun> runs);

}  // namespace talweg::quality
