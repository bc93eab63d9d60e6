// A distance that is known near curves is carried on over the rest of a surface, in little time.
#pragma once

#include <vector>

#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

/// Fills in distances that are infinite from those that are known, mesh units, one per vertex.
/// Known ones stay; what no known one is connected with stays infinite.
///
/// The front goes over the faces in the order of distance (Kimmel & Sethian 1998). Across a face it
/// is that of the one point, in the face's plane, which has the known distances from two corners
/// (Novotni & Klein 2002): exact on a plane around a point, elsewhere a few per cent too long or
/// too short, at most by what the front bends in a face. Never longer than along edges. O(n log n)
/// for n vertices. Throws std::invalid_argument for another number of distances than vertices, and
/// Cancelled when the asker does.
void march_distance(const Surface& surface, std::vector<double>& distance, Asker& asker);

}  // namespace talweg
