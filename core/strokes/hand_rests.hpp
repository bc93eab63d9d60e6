// A rest of a hand is a place where many samples of a stroke lie and the stroke does not move on.
#pragma once

#include <cstddef>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The points first to last of a stroke lie in one rest; `kept` of them is nearest to their mean,
/// or an end of an open stroke.
struct HandRest {
  std::size_t first = 0, kept = 0, last = 0;
};

/// The rests of a stroke, ascending and disjoint. Samples are its ends, the points inside faces and
/// those at which it turns (turning_points.hpp). Their usual distance is 1.5 steps of the longest
/// compass walk (compass_walk.hpp) whose median step passes one sample at most; steps are halved
/// from a 16th to a 4000th of the way, and at a 16th it is more, or there are too few samples to
/// tell. In a rest, 20 samples or more, and eight times as many as usual, lie within
/// a radius of three times that distance, once or one third of it. The median step from one to the
/// next is at most half of the usual distance. They are six times as wide as the median of them is
/// from their mean; the way through them is at least four times as long, and the means of their
/// first and last thirds are no farther apart than a third of that. So a slow hand, which moves on,
/// does not rest, and neither does one that winds a few times around something. A rest at the first
/// point of a closed stroke may be found as two. O(points · steps).
std::vector<HandRest> hand_rests(const SurfaceMesh& mesh, const SurfaceCurve& stroke);

}  // namespace talweg
