// Strands are curves as chains of nodes on edges and vertices, changed one node at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg::plugins {

/// A point of a curve, with its neighbours.
struct StrandNode {
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
  SurfacePoint at;
  Point position;           ///< position in space
  std::uint32_t curve = 0;  ///< the curve that it belongs to
  std::uint32_t before = kNone,
                after = kNone;  ///< neighbours; kNone beyond the end of an open curve
  bool fixed = false;           ///< set for ends, pins, and vertices that are passed twice
  bool alive = true;
};

/// The nodes of some curves, and the nodes that share an edge or a vertex. Different curves, and
/// different parts of one, never pass each other on an edge or at a vertex.
class Strands {
 public:
  /// Points inside faces are left out, except for ends and pins: the curve continues straight
  /// inside the face. The mesh must outlive the object.
  Strands(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
          std::span<const SurfacePoint> pins);

  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] const StrandNode& operator[](std::uint32_t node) const { return nodes_[node]; }
  [[nodiscard]] std::size_t count(std::uint32_t curve) const { return counts_[curve]; }
  /// The nodes of a curve, in order.
  [[nodiscard]] std::vector<std::uint32_t> chain(std::uint32_t curve) const;
  [[nodiscard]] SurfaceCurve curve(std::uint32_t curve) const;
  [[nodiscard]] double length(std::uint32_t curve) const;  ///< mesh units
  /// Keeps the nodes of one curve from moving any more.
  void fix(std::uint32_t curve);

  /// The parameters between which a node on an edge may slide, so that it keeps half the distance
  /// to the next nodes there; 0 and 1 where it may go as far as the vertex.
  struct Room {
    double low = 0, high = 1;
  };
  [[nodiscard]] Room room(std::uint32_t node) const;
  [[nodiscard]] bool is_taken(VertexId v) const { return at_vertex_.contains(v.index()); }
  /// The distance from the tail of h (mesh units) of the nearest node on its edge, except for the
  /// two given; the edge's length if there is none.
  [[nodiscard]] double free_along(HalfedgeId h, std::uint32_t a, std::uint32_t b) const;

  void move(std::uint32_t node, const SurfacePoint& to);
  void remove(std::uint32_t node);
  /// Replaces `node` by nodes at these points, in order.
  void replace(std::uint32_t node, std::span<const SurfacePoint> points);

 private:
  void enter(std::uint32_t node);
  void leave(std::uint32_t node);
  void join(std::uint32_t before, std::uint32_t after);

  const SurfaceMesh* mesh_;
  std::vector<StrandNode> nodes_;
  std::vector<char> closed_;          // per curve
  std::vector<std::uint32_t> first_;  // first node of each curve
  std::vector<std::size_t> counts_;   // number of nodes of each curve
  // These maps are only looked up, never iterated, so the order in a hash table has no effect.
  std::unordered_map<std::size_t, std::vector<std::uint32_t>> on_edge_, at_vertex_;
};

}  // namespace talweg::plugins
