// Applying a division plan changes a mesh of OpenMesh in place. It needs OpenMesh and nothing of
// the library, so hosts of plugins use it, too; in C++17.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "talweg/core/openmesh/division_plan.hpp"
#include "talweg/core/openmesh/planned_relinking.hpp"
#include "talweg/core/openmesh/relinking.hpp"
#include "talweg/core/openmesh/relinking_in_place.hpp"

namespace talweg {

/// How the edges of chains are marked.
struct ChainMarks {
  /// Gives them and their vertices the status bit `feature`. The mesh must have these status
  /// attributes.
  bool feature = false;
  /// If valid, each edge of a chain gets the number of its curve, from 0; the last one where
  /// several run.
  OpenMesh::EPropHandleT<int> curve = OpenMesh::EPropHandleT<int>();
};

/// What there is now that was not there before. New elements are the mesh's last.
struct AppliedPlan {
  std::vector<OpenMesh::VertexHandle> vertices;  ///< in the order of the plan
  std::vector<OpenMesh::FaceHandle> faces;       ///< the new ones
  std::vector<OpenMesh::FaceHandle> face_from;   ///< for each of these the old face it is a part of
  std::vector<std::vector<OpenMesh::HalfedgeHandle>> chains;  ///< one per curve, in its direction
};

/// Throws PlanError if rounding to the mesh's numbers would turn a triangle over or make it flat.
template <class Mesh, class Numbers>
void check_turned(const Mesh& mesh, const DivisionPlan& plan, const Numbers& numbers) {
  using Vector = OpenMesh::Vec3d;
  const auto as_vector = [](const typename Mesh::Point& p) {
    return Vector(static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]));
  };
  const auto at = [&](std::uint32_t number) {
    if (number < plan.old_vertices) return as_vector(mesh.point(numbers.vertex(number)));
    return as_vector(stored_point<Mesh>(plan.positions[number - plan.old_vertices]));
  };
  std::size_t first = 0;
  for (std::size_t k = 0; k < plan.faces.size(); first += plan.parts[k], ++k) {
    std::array<Vector, 3> corner;
    auto h = mesh.halfedge_handle(numbers.face(plan.faces[k]));
    for (Vector& p : corner) {
      p = as_vector(mesh.point(mesh.to_vertex_handle(h)));
      h = mesh.next_halfedge_handle(h);
    }
    const Vector normal = (corner[1] - corner[0]) % (corner[2] - corner[0]);
    for (std::size_t i = first; i < first + plan.parts[k]; ++i) {
      const auto& [a, b, c] = plan.triangles[i];
      const Vector p = at(a);
      if ((((at(b) - p) % (at(c) - p)) | normal) > 0) continue;
      throw PlanError("Face " + std::to_string(plan.faces[k]) +
                      " cannot be divided in single precision: rounding would turn a part of it "
                      "over.");
    }
  }
}

/// Marks the edges of chains. Nothing here can fail.
template <class Mesh>
void mark(Mesh& mesh, const Relinking& changes, const ChainMarks& marks) noexcept {
  for (std::size_t c = 0; c < changes.chains.size(); ++c) {
    for (const auto h : changes.chains[c]) {
      const auto e = mesh.edge_handle(h);
      if (marks.curve.is_valid()) mesh.property(marks.curve, e) = static_cast<int>(c);
      if (!marks.feature) continue;
      mesh.status(e).set_feature(true);
      mesh.status(mesh.from_vertex_handle(h)).set_feature(true);
      mesh.status(mesh.to_vertex_handle(h)).set_feature(true);
    }
  }
}

inline AppliedPlan applied(const Relinking& changes) {
  AppliedPlan applied;
  for (const auto& mixed : changes.vertices) applied.vertices.push_back(mixed.vertex);
  for (const auto& [from, part] : changes.face_parts) {
    applied.faces.push_back(part);
    applied.face_from.push_back(from);
  }
  applied.chains = changes.chains;
  return applied;
}

/// Divides faces and edges as the plan says, in place. `numbers` knows the handle of each number.
/// No old vertex moves; handles stay valid; a divided face keeps its handle for one of its
/// triangles and a divided edge for one of its parts; nothing is deleted. Properties:
/// - parts of a face or an edge have those of it, status included; edges inside faces have none;
/// - a vertex has those of the nearest old one of its edge or face (the first of equals), but its
///   normal, colour and texture coordinates lie between those of all, and of the status bits it has
///   those that all have;
/// - a halfedge inside a face has those of the one that points to the nearest corner (names that
///   begin with "h:" left out), without status; normals, colours and texture coordinates of
///   halfedges belong to the corner at their head, and lie between those of the old face's corners.
/// O(what the plan divides), but for the room that the mesh's lists need when they are full. Throws
/// PlanError, std::bad_alloc, or what copying a property throws; the mesh is then as before.
template <class Traits, class Numbers = SameNumbers>
AppliedPlan apply_plan(OpenMesh::TriMesh_ArrayKernelT<Traits>& mesh, const DivisionPlan& plan,
                       const Numbers& numbers = {}, const ChainMarks& marks = {}) {
  using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;
  using Scalar = typename OpenMesh::vector_traits<typename Mesh::Point>::value_type;
  if (marks.feature && !(mesh.has_edge_status() && mesh.has_vertex_status())) {
    throw PlanError(
        "Edges cannot be marked as features: the mesh has no status of edges and vertices.");
  }
  const Relinking changes = RelinkingFinder<Mesh, Numbers>(mesh, plan, numbers).run();
  if constexpr (sizeof(Scalar) < sizeof(double)) check_turned(mesh, plan, numbers);
  AppliedPlan result = applied(changes);
  change(mesh, changes, [&](auto& properties) { properties.fill_vertices(plan); });
  mark(mesh, changes, marks);
  return result;
}

}  // namespace talweg
