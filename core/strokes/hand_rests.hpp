// A rest of a hand is a place where many samples of a stroke lie and the stroke does not move on.
#pragma once

#include <cstddef>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The points first to last of a stroke lie in one rest. Point `kept` is the one nearest to their
/// mean, or an end of an open stroke.
struct HandRest {
  std::size_t first = 0, kept = 0, last = 0;
};

/// The rests of a stroke, ascending and disjoint.
///
/// Samples are the stroke's ends, its points inside faces and the points at which it turns
/// (turning_points.hpp). The usual distance of samples is 1.5 steps of the longest compass walk
/// (compass_walk.hpp) whose median step passes one sample at most. Steps are halved from a 16th to
/// a 4000th of the stroke's length; no rests are found where the longest or the shortest step is
/// the answer, or where samples are too few.
///
/// A rest has at least 20 samples, and eight times the usual number, within a radius of 3, 1 or 1/3
/// usual distances. The median step between its samples is at most half of the usual distance. The
/// width of a rest is six times the median distance of its samples from their mean; the path
/// through the samples is at least four times as long as the width, and the means of its first and
/// last thirds are at most a third of the width apart. So a slow hand, which moves on, does not
/// rest, and neither does a hand that winds a few times around something. A rest at the first point
/// of a closed stroke may be found as two. O(points · steps).
std::vector<HandRest> hand_rests(const SurfaceMesh& mesh, const SurfaceCurve& stroke);

}  // namespace talweg
