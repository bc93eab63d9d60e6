// A ridge field measures the angles by which a surface turns at its ridges and valleys.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/ids.hpp"
#include "talweg/intrinsic/surface/zeroed_memory.hpp"

namespace talweg {

/// The lines that count as ridges. The outside is the side from which faces are counterclockwise.
enum class RidgeKind {
  kBoth,
  kConvex,   ///< lines that stand out: edges of a solid, crests, raised margins
  kConcave,  ///< lines that lie deep: fissures, grooves, the foot of a wall
};
/// The kind with the name "both", "convex" or "concave". Throws Error(kBadUsage) for other names.
RidgeKind ridge_kind(std::string_view name);

/// The strength of ridges at vertices and along edges, as angles, which do not depend on the unit
/// of length. The dihedral angle of an edge is here the angle between the normals of its two faces,
/// 0 on a plane. A value is computed at its first query. Arrays over all vertices are zeroed memory
/// (zeroed_memory.hpp), so only the pages that queries touch take memory. The mesh must outlive the
/// field. One thread at a time.
class RidgeField {
 public:
  /// `scale`: the radius within which turning is measured, mesh units, > 0. `roughness`:
  /// roughness_along() of the curves there.
  RidgeField(const SurfaceMesh& mesh, RidgeKind kind, double scale, double roughness);

  /// The angle by which the surface turns at a vertex, within the scale, minus the angle beside the
  /// vertex: radians, in [0, π). The value is about the dihedral angle at a sharp crease, and 0 on
  /// planes, spheres and cylinders; across a ridge it falls off within half of the scale. The angle
  /// follows from the quadric that fits the vertices within the scale best, which averages noise.
  /// O(vertices within three scales), once per vertex.
  double at(VertexId vertex);

  /// The dihedral angle of an edge minus the larger of the usual dihedral angle around the edge and
  /// the angle that the mesh's roughness explains; 0 if the edge exceeds the latter angle by 0.05
  /// or less: radians, in [0, π). O(edges within two rings).
  double along(EdgeId edge);

 private:
  /// The turn of the surface at a vertex: first as on a ridge, then as in a valley.
  struct Turn {
    std::array<double, 2> angle{};  ///< radians, >= 0
    std::array<Point, 2> across;    ///< unit direction in which the surface turns most
    Point along_normal;             ///< the unit normal of the fit
    bool fitted = false;
  };
  /// The values computed so far for a vertex.
  struct Known {
    std::optional<Point> normal;  ///< area-weighted
    std::optional<Turn> turn;
    std::array<std::optional<double>, 2> height;
    std::optional<double> at;
  };

  Known& known(VertexId vertex);
  void gather(VertexId vertex, double radius, std::vector<VertexId>& ball);
  const Point& normal(VertexId vertex);
  const Turn& turn(VertexId vertex);
  [[nodiscard]] Turn fitted(VertexId vertex);
  double height(VertexId vertex, std::size_t side);
  double sharpened(VertexId vertex, std::size_t side);
  [[nodiscard]] double dihedral(EdgeId edge) const;
  double usual_dihedral(VertexId vertex);

  const SurfaceMesh* mesh_;
  double scale_, rough_angle_;
  std::array<bool, 2> counts_;         // ridges, valleys
  ZeroedVector<std::uint32_t> slot_;   // per vertex: 1 + its place in known_, or 0
  ZeroedVector<std::uint32_t> stamp_;  // per vertex: of the last gather() that met it
  std::uint32_t gathered_ = 0;
  std::vector<Known> known_;
};

}  // namespace talweg
