// A closed mesh that is turned inside out is drawn with its outside outside.
#pragma once

#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg::picture {

/// The mesh, with all triangles turned over if it is closed but for small holes and its normals
/// point inwards. Some files are written so (the bunny of VTK); the view then shows a curve through
/// a hole from inside. O(faces).
MeshLists turned_outward(MeshLists mesh);

}  // namespace talweg::picture
