// Network nodes are the points where borders end; they may move to where the borders balance.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/labels/label_borders.hpp"
#include "talweg/core/mesh/closest_point.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"

namespace talweg {

/// Junctions, and ends on the mesh's boundary. The sum of the unit tangents of the borders that
/// leave a node is minus the gradient of their lengths by its place; where it is zero, three
/// borders meet at 120 degrees. A node on the boundary moves along it, and only the component of
/// the sum along the boundary counts, so a single border ends at a right angle.
class NetworkNodes {
 public:
  struct Rules {
    bool junctions = true;  ///< whether nodes away from the boundary may move
    bool ends = true;       ///< whether nodes on the boundary may move
  };
  /// `tolerance`: for each border how far from home its nodes may move, mesh units, >= 0. A node
  /// also moves at most a fraction of the distance to the next one. O(faces).
  NetworkNodes(const SurfaceMesh& mesh, std::span<const LabelBorder> drawn,
               std::span<const double> tolerance, const Rules& rules);

  /// Moves each free node one step towards balance. `results` are the borders as last smoothed;
  /// they end at the nodes. Returns the borders (ascending) whose ends moved.
  std::vector<std::size_t> step(std::span<const SurfaceCurve> results);
  /// Moves the nodes of these borders home and keeps them there. Returns all borders that end
  /// there, ascending; none if these nodes were held already.
  std::vector<std::size_t> hold(std::span<const std::size_t> borders);

  /// Whether an end of the border is not where it was drawn.
  [[nodiscard]] bool is_moved(std::size_t border) const;
  /// The number of nodes that are not where they were drawn.
  [[nodiscard]] std::size_t moved_count() const;
  /// The mean length of the sum of unit tangents over the nodes that may move; 0 without any.
  [[nodiscard]] double imbalance(std::span<const SurfaceCurve> results) const;

  /// A drawing whose ends have moved: outside the surroundings of a node it is unchanged; from
  /// there a straight line leads to the node's place.
  struct Redrawing {
    LabelBorder border;
    std::vector<std::size_t> from;  ///< per point, the point of the drawing whose slack applies
  };
  Redrawing redrawn(std::size_t border);

 private:
  struct End {
    std::size_t border;
    bool front;  // at the front or the back; for a loop at the node, its direction
  };
  struct Node {
    SurfacePoint home, at;
    bool on_boundary;
    bool free;
    double reach;
    std::vector<End> ends;
    // The last step and the pull before it.
    std::optional<Point> step, pull;
  };
  /// The sum of unit tangents, in the surface or along the boundary, and the length of the step
  /// that would balance the node if the borders were straight as far as they appear to be.
  struct Pull {
    Point sum = Point::Zero();
    double step = 0;
  };

  void collect();
  void limit_reach();
  [[nodiscard]] Pull pull_at(const Node& node, std::span<const SurfaceCurve> results) const;
  [[nodiscard]] Point along_boundary(const SurfacePoint& at, const Point& pull) const;
  [[nodiscard]] SurfacePoint slid(const SurfacePoint& at, const Point& step) const;
  [[nodiscard]] SurfacePoint moved(const Node& node, Point step) const;
  [[nodiscard]] const Node& node_of(std::size_t border, bool front) const {
    return nodes_[node_of_[border][front ? 0 : 1]];
  }

  const SurfaceMesh* mesh_;
  std::span<const LabelBorder> drawn_;
  std::vector<Node> nodes_;
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::vector<std::array<std::size_t, 2>> node_of_;  // per border, front and back; kNone: a loop
  ClosestPoint closest_;
  StraightLines lines_;
};

}  // namespace talweg
