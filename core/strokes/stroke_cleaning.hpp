// Cleaning a stroke leaves out what its hand did not mean: rests, scribbles, hooks at the ends.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// What is left of a stroke, and what was left out.
struct CleanedStroke {
  SurfaceCurve curve;
  /// Per point of the curve where it was on the given one: k + t is at t of the way from its point
  /// k to the next. Empty if nothing was left out, and the curve is the given one.
  std::vector<double> places;
  std::size_t rests = 0;  ///< places where the hand stood still
  std::size_t hooks = 0;  ///< ends that were cut off, 0 to 2
  double farthest = 0;    ///< mesh units, through space: of what was left out from what is left

  [[nodiscard]] bool is_cleaned() const { return !places.empty(); }
};

/// Whether the ends of an open stroke may be cut off.
struct FreeEnds {
  bool start = true, end = true;
};

/// Leaves out the rests of a stroke (hand_rests.hpp): of each, one point is left, which straight
/// lines through the faces join to what lies before and after it. O(points).
CleanedStroke without_rests(const SurfaceMesh& mesh, const SurfaceCurve& stroke);

/// Leaves out rests and, where `trembling` (mesh units, >= 0) is not 0, what lies within a quarter
/// of it of what is left: the stroke is walked with a compass (compass_walk.hpp, rejoining), and
/// its places are joined by straight lines through the faces that it passes. An end that hooks back
/// by more than half of `trembling` begins where the hook turns. Strokes whose points are no nearer
/// to each other than an eighth of `trembling` stay as they are, to the last bit. O(points).
CleanedStroke cleaned_stroke(const SurfaceMesh& mesh, const SurfaceCurve& stroke, double trembling,
                             FreeEnds ends = {});

/// The straight line between the ends of an open curve, through the faces that it passes; none
/// where there is none. O(points).
std::optional<CleanedStroke> straight_line_along(const Surface& surface, const SurfaceCurve& curve);

}  // namespace talweg
