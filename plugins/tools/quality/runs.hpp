// Runs and their measures: with default settings, with τ swept, and on finer meshes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "talweg/core/smoothing/curve_smoother.hpp"
#include "tools/quality/drawings.hpp"

namespace talweg::quality {

/// A mesh with its drawings.
struct Subject {
  std::string name;
  MeshLists lists;
  std::shared_ptr<const OpenedMesh> mesh;
  std::vector<NamedPath> drawings;
};

/// A drawing at one τ. Lengths in h₀, the mean edge near the drawing; angles in radians.
struct Run {
  std::string mesh, drawing;
  bool closed = false;
  double edge = 0;  ///< h₀, mesh units
  double tau = 0;
  double bending_before = 0, bending_after = 0;  ///< with h₀
  double window_turning = 0, largest_turn = 0;   ///< of the result: in a window of h₀, and at one
                                                 ///< point
  double curvature_before = 0, curvature_after = 0;
  double least_curvature = 0;                      ///< lower bound for closed curves, by Gauss and
                                                   ///< Bonnet
  double to_drawn = 0, from_drawn = 0, slack = 0;  ///< h₀
  double length_ratio = 0;                         ///< after / before
  double solve_ms = 0, smooth_ms = 0;              ///< time of the distance, and of the stages that
                                                   ///< a new τ repeats
  Outcome termination = Outcome::kConverged;
  bool warned = false;
  bool touches = false;    ///< the result touches itself at more places than its drawing
  bool left_taut = false;  ///< the result is taut, wholly or in a stretch, with a warning

  /// Total curvature after / before, both without the lower bound of a closed curve.
  [[nodiscard]] double ratio() const {
    return (curvature_after - least_curvature) / (curvature_before - least_curvature);
  }
};

/// A run of every drawing at four τ. `relax_rounds` are rounds of the paper's relaxation.
std::vector<Run> default_runs(const Subject& subject, const CurveOptions& curve_options,
                              int relax_rounds = 0);

/// τ from 0.25 to 4 in steps of 1 %.
struct Sweep {
  std::string mesh, drawing;
  std::size_t steps = 0;
  std::size_t rises = 0;  ///< steps in which the deviation rises by more than 0.1 h₀
  std::size_t moves = 0;  ///< steps in which the curve moves by more than 0.2 h₀
  double largest_move = 0, largest_rise = 0;  ///< h₀
};
Sweep sweep(const Subject& subject, const NamedPath& drawing, const CurveOptions& curve_options);

/// A drawing on the mesh, and on the mesh with every face divided into four once and twice; slack
/// and characteristic length as on the coarsest mesh.
struct Subdivision {
  std::string mesh, drawing;
  double curvature[3] = {};  ///< by level
  double bending[3] = {};    ///< by level, in windows of the coarsest mesh's h₀
  double apart[3] = {};      ///< Hausdorff distance to the coarsest mesh's result, in its h₀
};
Subdivision subdivision(const Subject& subject, const NamedPath& drawing, double tau,
                        const CurveOptions& curve_options);

}  // namespace talweg::quality
