// A weld hint describes the result of welding a mesh with vertices at the same position.
#pragma once

#include <string>
#include <string_view>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/repair/mesh_repair.hpp"

namespace talweg {

/// "2880 vertices lie at the place of others: with repair=weld the mesh has 1 part instead of 960
/// and no boundary instead of 960 boundary loops." `option`: the text before the steps.
std::string weld_sentence(const MeshInspection& before, const WeldedMesh& welded,
                          std::string_view option = "repair=");

/// weld_sentence() after a blank, if welding joins components or closes boundary; otherwise empty.
/// A curve cannot cross between components that touch without sharing vertices. Takes the time of
/// inspect(), and of repair() if there are vertices to weld.
std::string weld_hint(const MeshLists& mesh, std::string_view option = "repair=");
std::string weld_hint(const SurfaceMesh& mesh, std::string_view option = "repair=");

}  // namespace talweg
