// Turns a mesh that is inside out, so that pictures show its outside.
#pragma once

#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg::picture {

/// The mesh, with all triangles turned over if its normals point inwards. Only a mesh whose
/// normals, weighted by area, nearly cancel is judged: a closed one, or one with small or opposite
/// holes, as a tube. Some files are written inside out (the bunny of VTK); the view then shows a
/// curve through a hole from inside. O(faces).
MeshLists turned_outward(MeshLists mesh);

}  // namespace talweg::picture
