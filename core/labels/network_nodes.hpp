// Network nodes are the points where borders end. Free nodes move until the tangents of their
// borders balance.
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

/// The nodes are junctions, and ends on the boundary of the mesh. The sum of the unit tangents of
/// the borders that leave a node is minus the gradient of their total length by the node's
/// position; where the sum is zero, three borders meet at 120 degrees. A node on the boundary moves
/// along the boundary, and only the component of the sum along it counts, so a single border ends
/// at a right angle.
class NetworkNodes {
 public:
  struct Rules {
    bool junctions = true;  ///< whether nodes away from the boundary may move
    bool ends = true;       ///< whether nodes on the boundary may move
  };
  /// `tolerance`: per border, the largest distance of its nodes from their drawn places, mesh
  /// units, >= 0. A node also moves by at most a quarter of the distance to the nearest node.
  /// O(faces).
  NetworkNodes(const SurfaceMesh& mesh, std::span<const LabelBorder> drawn,
               std::span<const double> tolerance, const Rules& rules);

  /// Moves each free node one step towards balance. `results` are the last smoothed borders, which
  /// end at the nodes. Returns the borders (ascending) whose ends moved.
  std::vector<std::size_t> step(std::span<const SurfaceCurve> results);
  /// Moves the nodes of these borders back to their drawn places and fixes them. Returns all
  /// borders (ascending) at nodes that moved back.
  std::vector<std::size_t> hold(std::span<const std::size_t> borders);

  /// Whether an end of the border is away from its drawn place.
  [[nodiscard]] bool is_moved(std::size_t border) const;
  /// The number of nodes away from their drawn places.
  [[nodiscard]] std::size_t moved_count() const;
  /// The mean, over the free nodes, of the length of the sum of unit tangents; 0 without free
  /// nodes.
  [[nodiscard]] double imbalance(std::span<const SurfaceCurve> results) const;

  /// A drawing whose ends have moved. Outside the surroundings of a node's drawn place the drawing
  /// is unchanged; from there a straight line leads to the node.
  struct Redrawing {
    LabelBorder border;
    std::vector<std::size_t> from;  ///< per point, the point of the drawing whose slack applies
  };
  Redrawing redrawn(std::size_t border);

 private:
  struct End {
    std::size_t border;
    bool front;  // the front or the back of the border; for a loop at the node, the direction
  };
  struct Node {
    SurfacePoint home, at;
    bool on_boundary;
    bool free;
    double reach;
    std::vector<End> ends;
    // The last step, and the pull before this step.
    std::optional<Point> step, pull;
  };
  /// The sum of unit tangents, projected to the surface or the boundary. `step` (mesh units) times
  /// the sum is the step that would balance the node if the borders stayed straight over their
  /// straight first stretches.
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
  std::vector<std::array<std::size_t, 2>> node_of_;  // per border, front and back; or kNone
  ClosestPoint closest_;
  StraightLines lines_;
};

}  // namespace talweg
