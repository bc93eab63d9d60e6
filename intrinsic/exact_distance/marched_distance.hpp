// Fast marching extends distances that are known near curves over the rest of a surface.
#pragma once

#include <vector>

#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

/// Fills in the infinite entries of `distance` (mesh units, one per vertex) from the finite ones.
/// Finite entries stay; entries stay infinite in components without a finite entry.
///
/// The front passes the vertices in the order of distance (Kimmel & Sethian 1998). Across a face,
/// the distance at a corner is measured from a virtual source, the point in the face's plane that
/// has the known distances from the two other corners (Novotni & Klein 2002). Distances from a
/// point in a plane are exact; other distances are a few per cent too long or too short, depending
/// on how much the front bends within a face. No distance is longer than the shortest path along
/// edges. O(n log n) for n vertices. Throws std::invalid_argument when the number of distances is
/// not the number of vertices, and Cancelled when the poller does.
void march_distance(const Surface& surface, std::vector<double>& distance, ProgressPoller& poller);

}  // namespace talweg
