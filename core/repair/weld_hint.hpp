// A weld hint describes the result of welding a mesh with vertices at the same position.
#pragma once

#include <string>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/repair/mesh_repair.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {

/// "2880 vertices lie at the place of others: with repair=weld the mesh has 1 part instead of 960
/// and no boundary instead of 960 boundary loops."
std::string weld_sentence(const MeshInspection& before, const WeldedMesh& welded);

/// weld_sentence() after a blank, if welding joins components or closes boundary; otherwise empty.
/// A curve cannot cross between components that touch without sharing vertices. Takes the time of
/// inspect(), and of repair() if there are vertices to weld.
std::string weld_hint(const MeshLists& mesh);
std::string weld_hint(const SurfaceMesh& mesh);

/// Rethrows the error, with the hint if a curve was rejected.
[[noreturn]] void rethrow_with_weld_hint(const Error& error, const MeshLists& mesh);

}  // namespace talweg
