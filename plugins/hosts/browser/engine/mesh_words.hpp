// Describes a mesh in words.
#pragma once

#include <string>

#include "talweg/editing/mesh_arrays.hpp"

namespace talweg::browser {

/// Sizes and defects of the mesh, from a report of talweg.repair, one on each line. `talweg info`
/// has more.
std::string words_of(const host::Results& inspection);

/// The first lines of this text, for a mesh that is too large to be inspected while the user waits.
std::string words_of(const editing::MeshArrays& mesh, double mean_edge);

}  // namespace talweg::browser
