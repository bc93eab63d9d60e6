// A mesh for a first try of the page.
#pragma once

#include "talweg/editing/mesh_arrays.hpp"

namespace talweg::browser {

/// A rounded stone with bumps, of 20 * 4^`level` faces, about 100 mesh units wide. The same for
/// each call.
editing::MeshArrays sample_mesh(int level = 6);

}  // namespace talweg::browser
