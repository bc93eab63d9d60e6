// Plan points are the vertices and faces of a division plan as handles of a mesh.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "talweg/core/openmesh/division_plan.hpp"
#include "talweg/core/openmesh/relinking.hpp"

namespace talweg {

/// A new vertex on an old edge.
struct EdgePoint {
  OpenMesh::VertexHandle low, high;  ///< the edge's ends; low has the smaller handle
  double t = 0;                      ///< position on the edge, 0 at low, 1 at high
  OpenMesh::VertexHandle vertex;

  friend bool operator<(const EdgePoint& a, const EdgePoint& b) {
    if (a.low != b.low) return a.low < b.low;
    if (a.high != b.high) return a.high < b.high;
    return a.t != b.t ? a.t < b.t : a.vertex < b.vertex;
  }
};

/// Converts numbers of a plan to handles, also of vertices that are still to be made. Throws
/// PlanError for a number that names no element. O(n log n) for n new vertices, O(log n) for an
/// edge.
template <class Mesh, class Numbers>
class PlanPoints {
 public:
  using Vertex = OpenMesh::VertexHandle;
  using Halfedge = OpenMesh::HalfedgeHandle;
  using Face = OpenMesh::FaceHandle;
  using Range = std::array<std::vector<EdgePoint>::const_iterator, 2>;

  PlanPoints(const Mesh& mesh, const DivisionPlan& plan, const Numbers& numbers)
      : mesh_(mesh), plan_(plan), numbers_(numbers) {
    check_sizes();
    for (std::size_t k = 0; k < plan.vertices.size(); ++k) add(k);
    std::sort(on_edges_.begin(), on_edges_.end());
  }

  [[nodiscard]] bool is_old(Vertex v) const {
    return v.idx() < static_cast<int>(mesh_.n_vertices());
  }
  [[nodiscard]] Vertex vertex(std::uint32_t number) const {
    if (number >= plan_.old_vertices) return new_vertex(number - plan_.old_vertices);
    const Vertex v = numbers_.vertex(number);
    if (!mesh_.is_valid_handle(v) || (mesh_.has_vertex_status() && mesh_.status(v).deleted())) {
      refuse("Vertex " + std::to_string(number) + " of the plan is not in the mesh");
    }
    return v;
  }
  [[nodiscard]] Face face(std::uint32_t number) const {
    const Face f = numbers_.face(number);
    if (!mesh_.is_valid_handle(f) || (mesh_.has_face_status() && mesh_.status(f).deleted())) {
      refuse("Face " + std::to_string(number) + " of the plan is not in the mesh");
    }
    return f;
  }
  /// The new vertices on an edge, in order from the end with the smaller handle.
  [[nodiscard]] Range on(Vertex a, Vertex b) const {
    const EdgePoint least{std::min(a, b), std::max(a, b), -1, Vertex()};
    const EdgePoint most{least.low, least.high, 2, Vertex()};
    return {std::lower_bound(on_edges_.begin(), on_edges_.end(), least),
            std::lower_bound(on_edges_.begin(), on_edges_.end(), most)};
  }
  [[nodiscard]] const std::vector<Relinking::Mixed>& mixed() const { return mixed_; }
  [[nodiscard]] const Relinking::Mixed& mixed(Vertex v) const {
    return mixed_[static_cast<std::size_t>(v.idx()) - mesh_.n_vertices()];
  }

  [[noreturn]] static void refuse(const std::string& what) {
    throw PlanError(
        what +
        ": the mesh has changed since the plan was made, or the plan belongs to another mesh.");
  }

 private:
  [[nodiscard]] Vertex new_vertex(std::size_t k) const {
    if (k < plan_.vertices.size()) return Vertex(static_cast<int>(mesh_.n_vertices() + k));
    throw PlanError("The plan uses vertex " + std::to_string(plan_.old_vertices + k) +
                    ", which is neither a vertex of the mesh nor a new one of the plan.");
  }
  void check_sizes() const {
    std::size_t triangles = 0;
    for (const std::uint32_t n : plan_.parts) triangles += n;
    const std::size_t n = plan_.vertices.size();
    if (plan_.weights.size() == n && plan_.positions.size() == n &&
        plan_.parts.size() == plan_.faces.size() && plan_.triangles.size() == triangles) {
      return;
    }
    throw PlanError(
        "The lists of the plan do not fit together: each new vertex needs weights and a position, "
        "and the parts of the faces must add up to the number of triangles.");
  }
  void add(std::size_t k) {
    const DivisionPlan::Three& from = plan_.vertices[k];
    const std::array<double, 3>& weights = plan_.weights[k];
    Relinking::Mixed mixed;
    mixed.vertex = new_vertex(k);
    mixed.weights = weights;
    const std::size_t n = from[2] == DivisionPlan::kNone ? 2 : 3;
    for (std::size_t c = 0; c < 3; ++c) {
      const bool is_weight = c < n ? weights[c] > 0 && weights[c] < 1 : weights[c] == 0;
      if (!is_weight || (c < n && from[c] >= plan_.old_vertices)) {
        throw PlanError("New vertex " + std::to_string(k) +
                        " of the plan lies on no edge and in no face.");
      }
      if (c < n) mixed.from[c] = vertex(from[c]);
      if (!std::isfinite(plan_.positions[k][c])) {
        throw PlanError("New vertex " + std::to_string(k) + " of the plan has no position.");
      }
    }
    mixed_.push_back(mixed);
    if (n == 3) return;
    const bool rising = mixed.from[0] < mixed.from[1];
    on_edges_.push_back({std::min(mixed.from[0], mixed.from[1]),
                         std::max(mixed.from[0], mixed.from[1]), weights[rising ? 1 : 0],
                         mixed.vertex});
  }

  const Mesh& mesh_;
  const DivisionPlan& plan_;
  const Numbers& numbers_;
  std::vector<Relinking::Mixed> mixed_;
  std::vector<EdgePoint> on_edges_;
};

}  // namespace talweg
