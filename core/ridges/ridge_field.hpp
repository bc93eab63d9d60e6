// A ridge field tells by how much a surface turns at its ridges and valleys.
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

/// Which lines count: the side from which faces are counterclockwise is outside.
enum class RidgeKind {
  kBoth,
  kConvex,   ///< ridges: edges of a solid, crests, margins that stand out
  kConcave,  ///< valleys: fissures, grooves, the foot of a wall
};
/// The kind with the name "both", "convex" or "concave". Throws Error(kBadUsage) for other names.
RidgeKind ridge_kind(std::string_view name);

/// Values are angles, so they do not depend on units. Nothing is computed before it is asked for:
/// memory for a number per vertex is taken, and written only where something was asked. The mesh
/// must outlive the field. One thread at a time.
class RidgeField {
 public:
  /// The scale is a radius in mesh units, > 0; `roughness` is that of roughness_along() there.
  RidgeField(const SurfaceMesh& mesh, RidgeKind kind, double scale, double roughness);

  /// By how much the surface turns at a vertex over the scale, more than beside it: radians, in
  /// [0, π). Of a sharp crease that is about its angle; on planes, spheres and cylinders it is 0;
  /// across a ridge it falls off within half of the scale. It comes from the quadric that fits the
  /// vertices within the scale best, which averages noise. O(vertices within three scales), each
  /// once.
  double at(VertexId vertex);

  /// The angle of the crease along an edge, without what is usual around it and what the mesh's
  /// roughness makes: radians, in [0, π). O(edges within two rings).
  double along(EdgeId edge);

 private:
  /// How the surface turns at a vertex: first to the inside, as on ridges, then to the outside.
  struct Turn {
    std::array<double, 2> angle{};  ///< radians, >= 0
    std::array<Point, 2> across;    ///< unit direction in which it turns most
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
