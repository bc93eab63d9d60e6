// A division plan says by number which faces of a mesh are divided into which triangles. It needs
// OpenMesh and nothing else, so that hosts of plugins can apply one to a mesh of theirs; in C++17.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include <OpenMesh/Core/Mesh/Handles.hh>

namespace talweg {

/// The plan that talweg_cut_plan.h describes. New vertices have the numbers that follow those of
/// the old ones; each lies on an old edge or in an old face.
struct DivisionPlan {
  using Three = std::array<std::uint32_t, 3>;
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
  struct Chain {
    bool closed = false;
    std::vector<std::uint32_t> vertices;  ///< each is joined to the next by an edge
  };

  std::uint32_t old_vertices = 0;
  std::vector<Three> vertices;  ///< the old ones that each new one lies between; kNone on an edge
  std::vector<std::array<double, 3>> weights;    ///< of these; they sum to 1
  std::vector<std::array<double, 3>> positions;  ///< of each new one
  std::vector<std::uint32_t> faces;              ///< old ones that are divided
  std::vector<std::uint32_t> parts;              ///< how many triangles each becomes
  std::vector<Three> triangles;                  ///< those of the first face, of the second, ...
  std::vector<Chain> chains;                     ///< one per curve
};

/// Says in one sentence why a plan cannot be applied to a mesh, which is then unchanged.
class PlanError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The plan that a host got from talweg.cut: any struct with the arrays of talweg_cut_plan as
/// vectors, such as talweg::host::CutPlan.
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

/// Numbers of elements that are those of their handles.
struct SameNumbers {
  [[nodiscard]] OpenMesh::VertexHandle vertex(std::uint32_t number) const {
    return OpenMesh::VertexHandle(static_cast<int>(number));
  }
  [[nodiscard]] OpenMesh::FaceHandle face(std::uint32_t number) const {
    return OpenMesh::FaceHandle(static_cast<int>(number));
  }
};

/// A position in the numbers of the mesh.
template <class Mesh>
typename Mesh::Point stored_point(const std::array<double, 3>& position) {
  typename Mesh::Point point;
  using Scalar = std::decay_t<decltype(point[0])>;
  for (unsigned k = 0; k < 3; ++k) point[k] = static_cast<Scalar>(position[k]);
  return point;
}

}  // namespace talweg
