// The origin (talweg_meshes.h) of a mesh that a plugin made with OpenMesh, stored in properties.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "talweg_meshes.h"
#include "talweg_openmesh_curves.hpp"
#include "talweg_openmesh_mesh.hpp"

namespace talweg::openmesh {

/// VProp<int> and FProp<int>: the index of each vertex and face in the host's mesh; -1: no origin.
/// A changed face counts as a part of the face that it was.
inline constexpr const char* kVertexNumber = "talweg:vertex";
inline constexpr const char* kFaceNumber = "talweg:face";
/// VProp<Between>, optional: the places of vertices without an index.
inline constexpr const char* kBetween = "talweg:between";

/// A place in a triangle or on an edge of the host's mesh: weights, with the sum 1, of vertices by
/// their indices. Unneeded vertices are TALWEG_NO_VERTEX and have the weight 0.
struct Between {
  std::array<std::uint32_t, 3> vertices = {TALWEG_NO_VERTEX, TALWEG_NO_VERTEX, TALWEG_NO_VERTEX};
  std::array<double, 3> weights = {};
};

/// Stores the index of each element of a mesh. Functions that copy properties also copy the
/// indices.
template <class Mesh>
void number_elements(Mesh& mesh) {
  OpenMesh::VPropHandleT<int> vertex;
  OpenMesh::FPropHandleT<int> face;
  if (!mesh.get_property_handle(vertex, kVertexNumber)) mesh.add_property(vertex, kVertexNumber);
  if (!mesh.get_property_handle(face, kFaceNumber)) mesh.add_property(face, kFaceNumber);
  for (int k = 0; k < static_cast<int>(mesh.n_vertices()); ++k) {
    mesh.property(vertex, VertexHandle(k)) = k;
  }
  for (int k = 0; k < static_cast<int>(mesh.n_faces()); ++k) {
    mesh.property(face, FaceHandle(k)) = k;
  }
}

/// The origin of a made mesh, with the chains of the host's curves in it. A curve has a chain only
/// if all its points are vertices that the made mesh still has, and successive vertices are
/// neighbours there.
template <class Mesh>
class MadeOrigin {
 public:
  MadeOrigin(const Mesh& mesh, const MeshNumbers& numbers, const std::vector<Curve>& curves)
      : mesh_(mesh), numbers_(numbers) {
    add_vertices();
    OpenMesh::FPropHandleT<int> number;
    const bool known = mesh.get_property_handle(number, kFaceNumber);
    for (std::size_t k = 0; k < numbers.faces.size(); ++k) {
      const int from = known ? mesh.property(number, numbers.faces.handle(k)) : -1;
      triangles_.push_back(from < 0 ? TALWEG_NO_TRIANGLE : static_cast<std::uint32_t>(from));
    }
    for (const Curve& curve : curves) add_chain(curve);
  }

  [[nodiscard]] talweg_origin view() const {
    talweg_origin origin = {};
    origin.curve_count = static_cast<std::uint32_t>(closed_.size());
    origin.vertices = plugin::view(vertices_.data(), vertices_.size() / 3, 3);
    origin.weights = plugin::view(weights_.data(), weights_.size() / 3, 3);
    origin.triangles = plugin::view(triangles_.data(), triangles_.size());
    origin.closed = plugin::view(closed_.data(), closed_.size());
    origin.lengths = plugin::view(lengths_.data(), lengths_.size());
    origin.chains = plugin::view(chains_.data(), chains_.size() / 3, 3);
    return origin;
  }

 private:
  void add_vertices() {
    OpenMesh::VPropHandleT<int> number;
    OpenMesh::VPropHandleT<Between> between;
    const bool known = mesh_.get_property_handle(number, kVertexNumber);
    const bool has_between = mesh_.get_property_handle(between, kBetween);
    for (std::size_t k = 0; k < numbers_.vertices.size(); ++k) {
      const VertexHandle v = numbers_.vertices.handle(k);
      Between from;
      if (known && mesh_.property(number, v) >= 0) {
        from.vertices[0] = static_cast<std::uint32_t>(mesh_.property(number, v));
        from.weights[0] = 1;
        if (from.vertices[0] >= now_.size()) now_.resize(from.vertices[0] + std::size_t{1});
        now_[from.vertices[0]] = v;
      } else if (has_between) {
        from = mesh_.property(between, v);
      }
      vertices_.insert(vertices_.end(), from.vertices.begin(), from.vertices.end());
      weights_.insert(weights_.end(), from.weights.begin(), from.weights.end());
    }
  }

  void add_chain(const Curve& curve) {
    std::vector<VertexHandle> chain;
    for (const CurvePoint& point : curve.points) {
      const auto from = static_cast<std::size_t>(point.vertex.idx());
      chain.push_back(point.vertex.is_valid() && from < now_.size() ? now_[from] : VertexHandle());
    }
    bool whole = true;
    for (std::size_t k = 0; k < chain.size(); ++k) {
      whole = whole && chain[k].is_valid();
      if (!whole || (k + 1 == chain.size() && !curve.closed)) continue;
      const VertexHandle next = chain[(k + 1) % chain.size()];
      whole = next.is_valid() && mesh_.find_halfedge(chain[k], next).is_valid();
    }
    const auto number = static_cast<std::uint32_t>(closed_.size());
    closed_.push_back(curve.closed ? 1 : 0);
    lengths_.push_back(whole ? static_cast<std::uint32_t>(chain.size()) : 0);
    for (std::uint32_t k = 0; k < lengths_.back(); ++k) {
      const std::uint32_t v = numbers_.vertices.number(chain[k]);
      chains_.insert(chains_.end(), {number, k, v});
    }
  }

  const Mesh& mesh_;
  const MeshNumbers& numbers_;
  std::vector<VertexHandle> now_;  // indexed by the vertices of the host's mesh
  std::vector<std::uint32_t> vertices_, triangles_, closed_, lengths_, chains_;
  std::vector<double> weights_;
};

}  // namespace talweg::openmesh
