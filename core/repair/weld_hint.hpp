// A weld hint tells what welding would give a mesh whose vertices lie at one place.
#pragma once

#include <string>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/repair/mesh_repair.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {

/// "2880 vertices lie at the place of others: with repair=weld the mesh has 1 part instead of 960
/// and no boundary instead of 960 boundary loops."
std::string weld_sentence(const MeshInspection& before, const WeldedMesh& welded);

/// That sentence after a blank, if welding helps: parts that only lie beside each other are not
/// connected. Otherwise empty. Takes the time of inspect(), and of repair() if vertices lie at one
/// place.
std::string weld_hint(const MeshLists& mesh);
std::string weld_hint(const SurfaceMesh& mesh);

/// Rethrows the error, with the hint if a curve was rejected.
[[noreturn]] void rethrow_with_weld_hint(const Error& error, const MeshLists& mesh);

}  // namespace talweg
