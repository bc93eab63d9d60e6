// Curve separation tells whether a curve of a cut separates the mesh, and why not.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "talweg/core/cutting/mesh_cutting.hpp"
#include "talweg/core/cutting/seam_opening.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"

namespace talweg {

/// Whether a curve has pieces on both sides, and no piece lies on both sides.
bool separates(const OpenedSeams& seams, std::size_t curve);

/// A sentence about a curve that does not separate the mesh: its number, the reason, and the curve
/// that would separate. `cut` may be without its lists. O(points of all curves + edges of the
/// mesh).
std::string why_not_separated(const SurfaceMesh& mesh, const CutMesh& cut, const OpenedSeams& seams,
                              std::size_t curve);

/// Sentences of why_not_separated() for the first eight curves that do not separate, and the number
/// of further ones.
std::vector<std::string> separation_notes(const SurfaceMesh& mesh, const CutMesh& cut,
                                          const OpenedSeams& seams);

}  // namespace talweg
