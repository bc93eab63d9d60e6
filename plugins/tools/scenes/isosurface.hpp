// Makes a mesh of an implicit solid.
#pragma once

#include "tools/scenes/solids.hpp"

namespace talweg::scenes {

/// The zero set of the field within the box as an oriented manifold (normals point to where the
/// field is positive), by marching tetrahedra over a body-centred cubic lattice of this cell size.
/// The mesh has a boundary where the solid leaves the box. Only the component with the most faces
/// is kept.
MeshLists isosurface(const Field& field, const Point& low, const Point& high, double cell);

}  // namespace talweg::scenes
