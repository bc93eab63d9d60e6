// What a mesh is, in words.
#pragma once

#include <string>

#include "talweg/editing/mesh_arrays.hpp"

namespace talweg::browser {

/// What `talweg info` tells, of a report of talweg.repair: a line each.
std::string words_of(const host::Results& inspection);

/// The first lines of it, of a mesh that is too large to look at everything while somebody waits.
std::string words_of(const editing::MeshArrays& mesh, double mean_edge);

}  // namespace talweg::browser
