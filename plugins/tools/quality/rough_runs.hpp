// Measures curves through clicks on meshes of growing roughness.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/quality/runs.hpp"

namespace talweg::quality {

/// A curve through clicks on a mesh with noise along its normals, compared with the curve on the
/// smooth mesh. Measures are taken on the smooth mesh, on the same points of the same faces;
/// lengths in h₀.
struct RoughRun {
  std::string mesh, drawing;
  double roughness = 0;  ///< standard deviation of the noise
  double told = 0;       ///< roughness_near of the report
  double bending = 0;    ///< in windows of 2 h₀ / bending of the curve on the smooth mesh
  double swing = 0;      ///< largest distance from the straight legs / the same for that curve
  double apart = 0;      ///< largest distance from that curve, both ways
  double time = 0;       ///< time of a new drawing and its result / the same for that curve,
                         ///< without work done once per mesh
  bool warned = false;
};

/// The longest open and closed drawings as clicks, every 25th vertex, at roughness 0.1 to 1.
std::vector<RoughRun> rough_runs(const Subject& subject, std::span<const NamedPath> drawings);

/// A table in Markdown with a row for each roughness.
std::string tables(std::span<const RoughRun> runs);
std::string csv(std::span<const RoughRun> runs);

}  // namespace talweg::quality
