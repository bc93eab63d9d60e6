// Improves the shape of triangles.
#pragma once

#include "tools/scenes/solids.hpp"

namespace talweg::scenes {

/// Moves every vertex `rounds` times halfway towards the mean of its neighbours (along the
/// boundary: of its boundary neighbours) and back onto the zero set of the field. Connectivity
/// stays.
void relax(MeshLists& mesh, const Field& field, double step, int rounds);

}  // namespace talweg::scenes
