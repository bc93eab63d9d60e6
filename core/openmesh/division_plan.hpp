// A division plan lists, by number, the faces of a mesh to divide and the triangles of each. The
// header needs only OpenMesh and C++17, so hosts of plugins can apply a plan to their own mesh.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include <OpenMesh/Core/Mesh/Handles.hh>

namespace talweg {

/// The plan that talweg_cut_plan.h describes. New vertices are numbered after the old vertices;
/// each new vertex lies on an old edge or in an old face.
struct DivisionPlan {
  using Three = std::array<std::uint32_t, 3>;
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
  struct Chain {
    bool closed = false;
    std::vector<std::uint32_t> vertices;  ///< neighbours in the list share an edge
  };

  std::uint32_t old_vertices = 0;
  std::vector<Three> vertices;  ///< corners of the old face, or ends of the edge and kNone
  std::vector<std::array<double, 3>> weights;    ///< of the corners or ends in `vertices`; sum 1
  std::vector<std::array<double, 3>> positions;  ///< per new vertex
  std::vector<std::uint32_t> faces;              ///< the old faces to divide
  std::vector<std::uint32_t> parts;              ///< the number of triangles of each
  std::vector<Three> triangles;                  ///< of the first divided face, of the second, ...
  std::vector<Chain> chains;                     ///< one per curve
};

/// A plan cannot be applied to a mesh; the message is one sentence with the reason. The mesh is
/// unchanged.
class PlanError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Converts the plan that a host got from talweg.cut. `Given` is any struct with the arrays of
/// talweg_cut_plan as vectors, such as talweg::host::CutPlan.
template <class Given>
DivisionPlan division_from(const Given& given) {
  DivisionPlan plan;
  plan.old_vertices = static_cast<std::uint32_t>(given.vertex_count);
  plan.vertices = given.vertices;
  plan.weights = given.weights;
  plan.positions = given.positions;
  plan.faces = given.divided;
  plan.parts = given.parts;
  plan.triangles = given.triangles;
  auto next = given.chains.begin();
  for (std::size_t c = 0; c < given.lengths.size(); ++c) {
    const auto end = next + static_cast<std::ptrdiff_t>(given.lengths[c]);
    plan.chains.push_back({given.closed[c] != 0, {next, end}});
    next = end;
  }
  return plan;
}

/// Element numbers that equal the indices of their handles.
struct SameNumbers {
  [[nodiscard]] OpenMesh::VertexHandle vertex(std::uint32_t number) const {
    return OpenMesh::VertexHandle(static_cast<int>(number));
  }
  [[nodiscard]] OpenMesh::FaceHandle face(std::uint32_t number) const {
    return OpenMesh::FaceHandle(static_cast<int>(number));
  }
};

/// A position in the scalar type of the mesh.
template <class Mesh>
typename Mesh::Point stored_point(const std::array<double, 3>& position) {
  typename Mesh::Point point;
  using Scalar = std::decay_t<decltype(point[0])>;
  for (unsigned k = 0; k < 3; ++k) point[k] = static_cast<Scalar>(position[k]);
  return point;
}

}  // namespace talweg
