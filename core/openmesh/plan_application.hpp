// Applying a division plan divides faces of an OpenMesh mesh in place. The header needs only
// OpenMesh and C++17, so hosts of plugins can use it.
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

/// The marks that edges of chains get.
struct ChainMarks {
  /// Sets the status bit `feature` of the edges and their vertices. The mesh must have the status
  /// attributes of edges and vertices.
  bool feature = false;
  /// If valid, each edge of a chain gets the number of its curve, from 0; an edge of several curves
  /// gets the largest number.
  OpenMesh::EPropHandleT<int> curve = OpenMesh::EPropHandleT<int>();
};

/// The new vertices and faces, and the edges of the curves. New elements have the largest handles.
struct AppliedPlan {
  std::vector<OpenMesh::VertexHandle> vertices;  ///< the new vertices, in the order of the plan
  std::vector<OpenMesh::FaceHandle> faces;       ///< the new faces
  std::vector<OpenMesh::FaceHandle> face_from;  ///< per new face, the old face that it is a part of
  std::vector<std::vector<OpenMesh::HalfedgeHandle>> chains;  ///< one per curve, in its direction
};

/// Throws PlanError if a triangle is turned over or has no area after rounding to the mesh's scalar
/// type.
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

/// Marks the edges of chains. Cannot fail.
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

/// Divides faces and edges according to the plan, in place. `numbers` converts numbers of the plan
/// to handles. Old vertices do not move and no element is deleted. Handles stay valid: the handle
/// of a divided face names its first triangle, the handle of a divided edge one of its parts.
/// Properties:
/// - parts of a face or an edge get its properties, status included; edges inside faces get none;
/// - a new vertex gets the properties of the nearest old vertex of its edge or face (the first of
///   equally near ones), except: its normal, colour and texture coordinates are interpolated, and
///   it gets the status bits that all these old vertices have;
/// - a halfedge inside a face gets the properties of the old face's halfedge that points to the
///   nearest corner (except properties named "h:..."), without status. Normals, colours and texture
///   coordinates of halfedges belong to the corner at the head, and are interpolated between the
///   corners of the old face.
///
/// O(divided elements), and O(mesh) when the mesh's arrays must grow. Throws PlanError,
/// std::bad_alloc, or an exception from copying a property; the mesh is then unchanged.
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
