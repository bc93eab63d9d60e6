// Embedding turns curves into edges of an OpenMesh mesh, in place.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "talweg/core/cutting/cut_plan.hpp"
#include "talweg/core/cutting/vertex_origin.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/openmesh/openmesh_adaptor.hpp"
#include "talweg/core/openmesh/plan_application.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {

struct EmbedOptions {
  double merge = CutOptions{}.merge;  ///< as in CutOptions
  ChainMarks marks;                   ///< how the edges of the curves are marked
};

struct Embedding : AppliedPlan {
  std::size_t crossings = 0;  ///< new vertices at crossings of curves
  std::size_t merged = 0;     ///< curve points that were moved onto a vertex or an edge
  double largest_move = 0;    ///< largest move of a merged point, mesh units
};

/// Converts a cut plan to a division plan, whose vertices are weighted means of old vertices.
inline DivisionPlan division_of(const CutPlan& cut, const Surface& surface) {
  DivisionPlan plan;
  plan.old_vertices = static_cast<std::uint32_t>(cut.old_vertices);
  for (std::size_t k = 0; k < cut.points.size(); ++k) {
    const VertexOrigin origin = origin_of(cut.vertex_from[k], surface);
    plan.vertices.push_back(origin.vertices);
    plan.weights.push_back(origin.weights);
    plan.positions.push_back({cut.points[k].x(), cut.points[k].y(), cut.points[k].z()});
  }
  plan.faces = cut.faces;
  for (std::size_t k = 0; k < cut.faces.size(); ++k) {
    plan.parts.push_back(static_cast<std::uint32_t>(cut.parts(k).size()));
  }
  plan.triangles = cut.triangles;
  for (const CutChain& chain : cut.chains) plan.chains.push_back({chain.closed, chain.vertices});
  return plan;
}

/// Converts ids of the opened mesh to handles of the OpenMesh mesh.
class NumbersOfIds {
 public:
  explicit NumbersOfIds(const OpenMeshIds& ids) : ids_(ids) {}
  [[nodiscard]] OpenMesh::VertexHandle vertex(std::uint32_t v) const {
    return ids_.handle(VertexId{v});
  }
  [[nodiscard]] OpenMesh::FaceHandle face(std::uint32_t f) const { return ids_.handle(FaceId{f}); }

 private:
  const OpenMeshIds& ids_;
};

/// Throws Error(kBadMesh) if a face that the plan divides has other corners or points than at
/// opening.
template <class Mesh>
void check_opened(const Mesh& mesh, const SurfaceMesh& opened, const OpenMeshIds& ids,
                  const CutPlan& plan) {
  const auto check = [&](bool same, const char* element, std::size_t number) {
    if (same) return;
    throw Error(ErrorCode::kBadMesh, std::string("The mesh has changed since it was opened, at ") +
                                         element + " " + std::to_string(number) + ".");
  };
  for (const std::uint32_t number : plan.faces) {
    const OpenMesh::FaceHandle f = ids.handle(FaceId{number});
    check(mesh.is_valid_handle(f) && !(mesh.has_face_status() && mesh.status(f).deleted()), "face",
          static_cast<std::size_t>(f.idx()));
    auto h = mesh.halfedge_handle(f);
    std::array<OpenMesh::VertexHandle, 3> corners;
    for (OpenMesh::VertexHandle& corner : corners) {
      corner = mesh.to_vertex_handle(h);
      h = mesh.next_halfedge_handle(h);
    }
    for (const VertexId v : opened.surface().corners(FaceId{number})) {
      const OpenMesh::VertexHandle corner = ids.handle(v);
      check(std::find(corners.begin(), corners.end(), corner) != corners.end(), "face",
            static_cast<std::size_t>(f.idx()));
      for (unsigned k = 0; k < 3; ++k) {
        check(static_cast<double>(mesh.point(corner)[k]) == opened.point(v)[k], "vertex",
              static_cast<std::size_t>(corner.idx()));
      }
    }
  }
}

/// The distance, in mesh units, above which two points near the curves stay different after
/// rounding to Scalar; 0 for double.
template <class Scalar>
double resolution_near(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves) {
  if constexpr (sizeof(Scalar) >= sizeof(double)) return 0;
  double largest = 0;
  for (const SurfaceCurve& curve : curves) {
    for (const SurfacePoint& point : curve.points) {
      largest = std::max(largest, mesh.position(point).cwiseAbs().maxCoeff());
    }
  }
  // Two points stay different after rounding if one coordinate differs by twice the spacing of the
  // numbers. The largest of three coordinate differences is at least distance / √3.
  return 2 * std::sqrt(3.0) * largest * static_cast<double>(std::numeric_limits<Scalar>::epsilon());
}

/// Turns the curves into chains of edges of `mesh`. Crossings and merging follow cut_along(); the
/// elements and properties change as in apply_plan(). `opened` and `ids` come from surface_of() or
/// open_mesh() of this mesh, and are out of date afterwards. In a mesh of single precision, points
/// that would round to the same position are merged. O(elements near the curves). Throws
/// Error(kBadCurve) as cut_along() does, Error(kBadMesh) if the mesh has changed since it was
/// opened or if rounding would turn a triangle over, and the other errors of apply_plan(); the mesh
/// is then unchanged.
template <class Traits>
Embedding embed_curves(OpenMesh::TriMesh_ArrayKernelT<Traits>& mesh, const SurfaceMesh& opened,
                       const OpenMeshIds& ids, std::span<const SurfaceCurve> curves,
                       const EmbedOptions& options = {}) {
  using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;
  using Scalar = typename OpenMesh::vector_traits<typename Mesh::Point>::value_type;
  if (ids.vertex_count() != opened.surface().vertex_count() ||
      ids.triangle_count() != opened.surface().face_count()) {
    throw Error(ErrorCode::kBadUsage,
                "The ids belong to another mesh: they count other numbers of vertices or triangles "
                "than the opened mesh.");
  }
  check_on(opened.surface(), curves);
  const CutPlan cut =
      plan_cut(opened, curves, {options.merge, resolution_near<Scalar>(opened, curves)});
  check_opened(mesh, opened, ids, cut);
  try {
    return {apply_plan(mesh, division_of(cut, opened.surface()), NumbersOfIds(ids), options.marks),
            cut.crossings, cut.merged, cut.largest_move};
  } catch (const PlanError& error) {
    throw Error(ErrorCode::kBadMesh, error.what());
  }
}
/// Opens the mesh first, which costs O(mesh) and has the errors of surface_of(), and embeds the
/// curves.
template <class Traits>
Embedding embed_curves(OpenMesh::TriMesh_ArrayKernelT<Traits>& mesh,
                       std::span<const SurfaceCurve> curves, const EmbedOptions& options = {}) {
  OpenMeshIds ids;
  const SurfaceMesh opened = surface_of(mesh, &ids);
  return embed_curves(mesh, opened, ids, curves, options);
}

}  // namespace talweg
