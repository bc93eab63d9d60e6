// Cleaning removes parts of a stroke that its hand did not mean: rests, scribbles, hooks at the
// ends.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// A stroke after cleaning, and the numbers of removed parts.
struct CleanedStroke {
  SurfaceCurve curve;
  /// The place of each point on the given curve: k + t lies at part t of the segment from point k
  /// to the next. Empty if the curve is the given one.
  std::vector<double> places;
  std::size_t rests = 0;  ///< places where the hand stood still
  std::size_t hooks = 0;  ///< ends that were cut off, 0 to 2
  double farthest = 0;    ///< mesh units: of removed parts from the cleaned stroke, in space

  [[nodiscard]] bool is_cleaned() const { return !places.empty(); }
};

/// Whether the ends of an open stroke may be cut off.
struct FreeEnds {
  bool start = true, end = true;
};

/// Removes the rests of a stroke (hand_rests.hpp). One point of each rest stays, and straight lines
/// through the faces join it to the stroke before and after the rest. O(points).
CleanedStroke without_rests(const SurfaceMesh& mesh, const SurfaceCurve& stroke);

/// Removes rests and, where `trembling` (mesh units, >= 0) is not 0, detail within a quarter of
/// `trembling` from the cleaned stroke: the stroke is walked with a compass (compass_walk.hpp,
/// rejoining), and straight lines join the places of the walk through the faces that the stroke
/// passes. A stroke that hooks back at a free end by more than half of `trembling` begins where the
/// hook turns. Strokes whose points are nowhere nearer to each other than an eighth of `trembling`
/// stay as they are, to the last bit. O(points).
CleanedStroke cleaned_stroke(const SurfaceMesh& mesh, const SurfaceCurve& stroke, double trembling,
                             FreeEnds ends = {});

/// The straight line between the ends of an open curve, through the faces that the curve passes;
/// none where no straight line exists in these faces. O(points).
std::optional<CleanedStroke> straight_line_along(const Surface& surface, const SurfaceCurve& curve);

}  // namespace talweg
