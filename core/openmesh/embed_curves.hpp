// Embedding makes curves edges of a mesh of OpenMesh, in place.
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
  double merge = CutOptions{}.merge;  ///< as CutOptions have it
  ChainMarks marks;                   ///< how the edges of the curves are marked
};

struct Embedding : AppliedPlan {
  std::size_t crossings = 0;  ///< new vertices that were made where curves cross
  std::size_t merged = 0;     ///< points of the curves that were moved onto a vertex or an edge
  double largest_move = 0;    ///< largest move of such a point, mesh units
};

/// The plan in plain numbers.
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

/// Handles of ids.
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

/// Throws Error(kBadMesh) unless the mesh is as it was opened, where the plan touches it.
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

/// The distance from which on two points near the curves stay two in these numbers.
template <class Scalar>
double resolution_near(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves) {
  if constexpr (sizeof(Scalar) >= sizeof(double)) return 0;
  double largest = 0;
  for (const SurfaceCurve& curve : curves) {
    for (const SurfacePoint& point : curve.points) {
      largest = std::max(largest, mesh.position(point).cwiseAbs().maxCoeff());
    }
  }
  // Points that differ by twice the step between numbers in one coordinate round to two. Of three
  // coordinates one differs by at least the distance over the square root of three.
  return 2 * std::sqrt(3.0) * largest * static_cast<double>(std::numeric_limits<Scalar>::epsilon());
}

/// Makes the curves chains of edges of `mesh`, by the rules of cut_along() and as apply_plan()
/// changes it. `opened` and `ids` are those that surface_of() or open_mesh() made of it; afterwards
/// they no longer fit it. In single precision points that its numbers cannot tell apart are merged.
/// O(what the curves touch). Throws Error(kBadCurve) as cut_along() does, Error(kBadMesh) where the
/// mesh is no longer as it was opened, or where rounding would turn a part of a face over, and
/// otherwise what apply_plan() throws; the mesh is then as before.
template <class Traits>
Embedding embed_curves(OpenMesh::TriMesh_ArrayKernelT<Traits>& mesh, const SurfaceMesh& opened,
                       const OpenMeshIds& ids, std::span<const SurfaceCurve> curves,
                       const EmbedOptions& options = {}) {
  using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;
  using Scalar = typename OpenMesh::vector_traits<typename Mesh::Point>::value_type;
  if (ids.vertex_count() != opened.surface().vertex_count() ||
      ids.triangle_count() != opened.surface().face_count()) {
    throw Error(ErrorCode::kBadUsage, "The numbers of elements are not those of the opened mesh.");
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
/// The same, after opening the mesh, which costs O(mesh) and throws as surface_of() does.
template <class Traits>
Embedding embed_curves(OpenMesh::TriMesh_ArrayKernelT<Traits>& mesh,
                       std::span<const SurfaceCurve> curves, const EmbedOptions& options = {}) {
  OpenMeshIds ids;
  const SurfaceMesh opened = surface_of(mesh, &ids);
  return embed_curves(mesh, opened, ids, curves, options);
}

}  // namespace talweg
