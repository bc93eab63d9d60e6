// Drawings as by unsteady hands, open and closed, small and large, on any mesh.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "talweg/core/mesh/opened_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg::quality {

struct NamedPath {
  std::string name;  ///< "open 48", "loop 12", "section 80": kind and number of points
  std::vector<VertexId> path;
  bool closed = false;

  [[nodiscard]] SurfaceCurve curve(const Surface& surface) const;
};

/// Five open and five closed drawings along mesh edges, if the mesh has room for them: shortest
/// edge paths through way-points that a hand missed by up to a third of their distance. Closed
/// drawings are loops about a vertex (12 to 150 edges) and plane sections. Deterministic.
std::vector<NamedPath> generated_drawings(const OpenedMesh& mesh, std::uint64_t seed);

/// The drawings MESH.txt and MESH_*.txt of a folder.
std::vector<NamedPath> stored_drawings(const std::filesystem::path& folder,
                                       const std::string& mesh);

}  // namespace talweg::quality
