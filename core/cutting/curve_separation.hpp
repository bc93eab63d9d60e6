// Curve separation tells whether the curves of a cut part the mesh, and why one does not.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "talweg/core/cutting/mesh_cutting.hpp"
#include "talweg/core/cutting/seam_opening.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"

namespace talweg {

/// Whether no piece lies on both sides of a curve, and one on either.
bool separates(const OpenedSeams& seams, std::size_t curve);

/// A sentence on a curve that does not separate the mesh, which names it by its number, says why
/// and what would. `cut` may be without its lists. O(points of all curves + edges of the mesh).
std::string why_not_separated(const SurfaceMesh& mesh, const CutMesh& cut, const OpenedSeams& seams,
                              std::size_t curve);

/// These sentences on the first curves that do not, and how many more there are.
std::vector<std::string> separation_notes(const SurfaceMesh& mesh, const CutMesh& cut,
                                          const OpenedSeams& seams);

}  // namespace talweg
