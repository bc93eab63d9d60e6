// A lifted curve as a chain of points on edges, and Newton's method on it.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "talweg/core/surface_mesh.hpp"
#include "talweg/intrinsic/surface_point.hpp"

namespace talweg {

/// A potential along an edge with its derivatives by t, exact instead of linear in each face.
/// Two components; for an open curve the second is 0.
struct PotentialOnEdge {
  std::array<double, 2> value{};
  std::array<double, 2> first{};
  std::array<double, 2> second{};
};
struct ExactPotential {
  std::function<PotentialOnEdge(EdgeId, double)> on_edge;
  std::function<std::array<double, 2>(const SurfacePoint&)> at;
};

/// A point of the chain: free on an edge, or fixed.
struct ChainNode {
  using Lifted = Eigen::Matrix<double, 5, 1>;  // position and potential

  SurfacePoint point;  ///< where it is fixed
  bool fixed = true;
  EdgeId edge;
  double t = 0;
  Point origin;           ///< the edge's tail
  Lifted y, dy;           ///< place and its derivative by t
  Eigen::Vector2d ddphi;  ///< second derivative of the potential; that of the position is 0
  bool awake = true;      ///< it, or something near, still gains by moving
  int changed = 0;        ///< the last round in which it moved or came
};

/// Minimises the lifted length of chains whose end points stay.
class LiftedChain {
 public:
  using Nodes = std::vector<ChainNode>;

  /// `tolerance`: relative gain in length below which a Newton step counts as none.
  /// `scale`: about the length of a segment; what is 1e-7 of it counts as nothing.
  LiftedChain(const SurfaceMesh& mesh, const ExactPotential& potential, double tolerance,
              double scale)
      : mesh_(mesh), potential_(potential), tolerance_(tolerance), smallest_(1e-6 * scale) {}

  /// What `changed` of nodes that move from now on will be.
  void begin_round(int round) { round_ = round; }
  /// A node at the point; free if it lies on an edge and `keep` is false.
  [[nodiscard]] ChainNode node_at(const SurfacePoint& point, bool keep) const;
  [[nodiscard]] SurfacePoint place(const ChainNode& node) const;
  [[nodiscard]] double length(std::span<const ChainNode> nodes) const;
  /// At most so many damped Newton steps (the matrix is tridiagonal) between any two fixed nodes;
  /// returns the length, which never grows.
  double settle(std::span<ChainNode> nodes, int steps);
  /// The same on short overlapping parts: a crease of the potential at one point would make all
  /// others take its small steps. Nodes of parts that still gain are awake afterwards, the others
  /// are not.
  void settle_by_parts(std::span<ChainNode> nodes);

 private:
  /// A row of the tridiagonal matrix, and the segment that follows the node.
  struct Row {
    ChainNode::Lifted direction;
    double length = 0;
    double speed = 0;  // of the node, by t
    double gradient = 0, diagonal = 0, upper = 0;
    double factor = 0, step = 0;
    bool held = true;

    void clear() { gradient = diagonal = upper = factor = step = 0, held = true; }
  };
  /// Where a free node would be.
  struct Trial {
    double t = 0;
    ChainNode::Lifted y;
    Eigen::Vector2d dphi, ddphi;
  };

  void try_at(const ChainNode& node, double t, Trial& trial) const;
  static void take(const Trial& trial, ChainNode& node);
  [[nodiscard]] double segment(const ChainNode::Lifted& a, const ChainNode::Lifted& b) const;
  double settle_between(std::span<ChainNode> nodes, int steps);
  bool go_along(std::span<ChainNode> nodes, double most, double& total);
  bool newton_step(std::span<ChainNode> nodes, double& total);
  bool assemble(std::span<const ChainNode> nodes);
  bool solve(std::span<const ChainNode> nodes);

  const SurfaceMesh& mesh_;
  const ExactPotential& potential_;
  double tolerance_;
  double smallest_;
  int round_ = 0;
  std::vector<Row> rows_;
  std::vector<Trial> trials_;
};

}  // namespace talweg
