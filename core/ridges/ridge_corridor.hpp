// A ridge corridor is a graph on the surface around a part of a drawing, in which ridges are cheap.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/ridges/ridge_field.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The nodes of the graph are vertices, three points of each edge, and the points of the drawing.
/// Arcs join the nodes of each face. The cost of an arc is its length times a factor: 1 along the
/// drawing, or less where the drawing lies on a ridge; 4 where there is neither; and less on a
/// ridge, the more the surface turns there. At `strength` 1 the factor of a ridge is 1 where the
/// surface turns by 10°, and tends to 1/4 for larger turns. Costs also grow with the distance from
/// the drawing, by half at the rim of the corridor.
class RidgeCorridor {
 public:
  /// The pull at which an arc costs as much as along the drawing.
  static constexpr double kAsDrawn = 0.5;

  struct Settings {
    double width = 0;  ///< mesh units, > 0, along edges: largest distance of nodes from the drawing
    double strength = 0;  ///< (0, 1]
  };
  /// Neighbouring points of `line` must share a face. O(vertices within the width, and those of
  /// RidgeField).
  RidgeCorridor(const SurfaceMesh& mesh, RidgeField& field, std::span<const SurfacePoint> line,
                const Settings& settings, ProgressPoller& poller);

  [[nodiscard]] std::size_t size() const { return places_.size(); }
  [[nodiscard]] const Point& position(std::size_t node) const { return places_[node]; }
  [[nodiscard]] SurfacePoint point(std::size_t node) const;
  /// A number of a vertex, or of a point of an edge; the same in all corridors on one mesh.
  [[nodiscard]] std::uint64_t key(std::size_t node) const;
  /// Whether the node may be used, that is, lies within the width.
  [[nodiscard]] bool is_inside(std::size_t node) const { return inside_[node] != 0; }
  [[nodiscard]] std::size_t drawn_count() const { return line_.size(); }
  [[nodiscard]] std::size_t drawn_node(std::size_t k) const { return first_drawn_ + k; }
  [[nodiscard]] bool is_drawn(std::size_t node) const { return node >= first_drawn_; }
  /// The attraction of a node, in [0, 1). An arc between nodes with the pull kAsDrawn costs as much
  /// as along the drawing. The pull includes the creases on which the node lies.
  [[nodiscard]] double pull(std::size_t node) const;
  /// Whether the arc between two neighbours costs at most as much as along the drawing.
  [[nodiscard]] bool is_ridge_between(std::size_t from, std::size_t to) const;

  struct Start {
    std::size_t node = 0;
    double cost = 0;
  };
  /// Costs of the cheapest paths from the starts to all nodes, infinite where no path exists.
  /// Dijkstra's algorithm. Throws Cancelled.
  void run(std::span<const Start> starts, ProgressPoller& poller);
  [[nodiscard]] double cost(std::size_t node) const { return cost_[node]; }
  /// The nodes of the path that run() has found, from a start to `node`.
  [[nodiscard]] std::vector<std::size_t> way_to(std::size_t node) const;

 private:
  struct Face {
    FaceId id;
    std::array<std::uint32_t, 3> corners{}, sides{};  ///< side k runs from corner k to the next
    std::vector<std::uint32_t> drawn;                 ///< nodes
  };
  void reach(double width, ProgressPoller& poller);
  void add_faces(ProgressPoller& poller);
  std::uint32_t vertex_node(VertexId v);
  std::uint32_t side_number(EdgeId edge);
  void place_nodes(RidgeField& field, const Settings& settings, ProgressPoller& poller);
  void place_drawn(RidgeField& field, double strength);
  [[nodiscard]] double arc_pull(const Face& face, std::size_t from, std::size_t to) const;
  [[nodiscard]] double arc_cost(const Face& face, std::size_t from, std::size_t to) const;
  [[nodiscard]] std::size_t element_number(std::size_t node) const;
  template <class Visit>
  void visit_face(const Face& face, const Visit& visit) const;
  void relax(std::size_t from, std::size_t to, double cost);

  const SurfaceMesh* mesh_;
  std::vector<SurfacePoint> line_;
  std::unordered_map<std::size_t, double> reached_;  // vertices: distance along edges to the line
  std::unordered_map<std::size_t, std::uint32_t> vertex_nodes_, side_numbers_, face_numbers_;
  std::vector<VertexId> vertices_;
  std::vector<EdgeId> edges_;
  std::vector<Face> faces_;
  std::vector<std::vector<std::uint32_t>> faces_at_;  // per vertex, then per edge, then drawn point
  std::size_t first_drawn_ = 0;
  struct Element {
    std::uint32_t vertex, edge;  // of the corridor; 0xFFFFFFFF for none
  };
  std::vector<Element> elements_;  // per node
  std::vector<Point> places_;      // per node
  std::vector<std::uint8_t> inside_;
  std::vector<double> pull_;       // per node: [0, 1)
  std::vector<double> rim_;        // per node: logarithm of the factor for its distance
  std::vector<double> edge_pull_;  // per edge of the corridor
  std::vector<double> cost_;
  std::vector<std::uint32_t> before_;
  std::vector<std::pair<double, std::uint32_t>> heap_;
};

}  // namespace talweg
