// A lifted chain is a lifted curve as points on edges, which Newton's method moves.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// A potential along an edge with its derivatives by t: exact, not linear in each face. It has two
/// components; for an open curve the second is 0.
struct PotentialOnEdge {
  std::array<double, 2> value{};
  std::array<double, 2> first{};
  std::array<double, 2> second{};
  double clear = 0;  ///< the potential is 0 within this distance, mesh units
};
/// The same inside a face, parametrised by s and t.
struct PotentialInFace {
  std::array<double, 2> value{};
  std::array<std::array<double, 2>, 2> first{};   ///< by s, by t
  std::array<std::array<double, 2>, 3> second{};  ///< ss, st, tt
};
struct ExactPotential {
  using Barycentric = std::array<double, 3>;
  std::function<PotentialOnEdge(EdgeId, double)> on_edge;
  std::function<std::array<double, 2>(const SurfacePoint&)> at;
  /// At b + s d[0] + t d[1], barycentrics in the order of Surface::corners().
  std::function<PotentialInFace(FaceId, const Barycentric& b, const std::array<Barycentric, 2>& d)>
      in_face;
};

/// The place of a node of the chain, or a trial place.
struct LiftedPlace {
  using Lifted = Eigen::Matrix<double, 5, 1>;  // position and potential

  double t = 0;  ///< on the edge of a free node
  Lifted y = Lifted::Zero();
  Eigen::Vector2d dphi = Eigen::Vector2d::Zero();   ///< derivatives of the potential by t
  Eigen::Vector2d ddphi = Eigen::Vector2d::Zero();  ///< second ones
  double clear = 0;  ///< the potential is 0 within this distance, mesh units
};

/// A point of the chain: free on an edge, or fixed.
struct ChainNode : LiftedPlace {
  explicit ChainNode(const SurfacePoint& p) : point(p) {}

  SurfacePoint point;  ///< where it is fixed
  bool fixed = true;
  EdgeId edge;
  Point origin = Point::Zero();  ///< the edge's tail
  Point along = Point::Zero();   ///< from there to its head: derivative of the position by t
  bool awake = true;             ///< it, or a node near it, still gains by moving
  int changed = 0;               ///< the last round in which it moved or was inserted
};

/// Minimises the lifted length of chains whose end points stay. The potential is also evaluated
/// halfway between two nodes. With the nodes alone, which are as far apart as the mesh has them, a
/// chain could pass through walls without noticing, the more so the coarser the mesh.
class LiftedChain {
 public:
  using Nodes = std::vector<ChainNode>;

  /// `tolerance`: relative gain in length below which a Newton step counts as none. `scale`: about
  /// the length of a segment; lengths below 1e-6 of it count as zero. The asker, if there is one,
  /// may throw Cancelled while nodes are settled.
  LiftedChain(const SurfaceMesh& mesh, const ExactPotential& potential, double tolerance,
              double scale, Asker* asker = nullptr)
      : mesh_(mesh),
        potential_(potential),
        tolerance_(tolerance),
        smallest_(1e-6 * scale),
        asker_(asker) {}

  /// Sets the round that is stored as `changed` in nodes that move from now on.
  void begin_round(int round) { round_ = round; }
  /// A node at the point; free if it lies on an edge and `keep` is false.
  [[nodiscard]] ChainNode node_at(const SurfacePoint& point, bool keep) const;
  [[nodiscard]] SurfacePoint place(const ChainNode& node) const;
  [[nodiscard]] double length(std::span<const ChainNode> nodes) const;
  [[nodiscard]] double length(const ChainNode& a, const ChainNode& b) const {
    return segment(a, halfway(link_between(a, b), a, b), b);
  }
  /// Makes at most `steps` damped Newton steps (the matrix is tridiagonal) between any two fixed
  /// nodes. Returns the length, which never grows.
  double settle(std::span<ChainNode> nodes, int steps);
  /// Settles short overlapping parts instead: otherwise a crease of the potential at one point
  /// would force all other nodes to take its small steps. Afterwards the nodes of parts that still
  /// gain are awake, and the others are not.
  void settle_by_parts(std::span<ChainNode> nodes);

 private:
  /// A row of the tridiagonal matrix.
  struct Row {
    double gradient = 0, diagonal = 0, upper = 0;
    double bend = 0;   // what the diagonal gains where the potential is curved
    double speed = 0;  // of the node, by t
    double factor = 0, step = 0;
    bool held = true;
  };

  [[nodiscard]] LiftedPlace place_at(const ChainNode& node, double t) const;
  [[nodiscard]] FaceId face_between(const ChainNode& a, const ChainNode& b) const;
  /// Describes where the middle of two nodes lies: in the face at base + t_a along[0] + t_b
  /// along[1].
  struct Link {
    FaceId face;
    ExactPotential::Barycentric base{};
    std::array<ExactPotential::Barycentric, 2> along{};
  };
  [[nodiscard]] Link link_between(const ChainNode& a, const ChainNode& b) const;
  [[nodiscard]] PotentialInFace halfway(const Link& link, const LiftedPlace& a,
                                        const LiftedPlace& b) const;
  [[nodiscard]] double segment(const LiftedPlace& a, const PotentialInFace& middle,
                               const LiftedPlace& b) const;
  void add_segment(const ChainNode& a, const PotentialInFace& middle, const ChainNode& b, Row& row,
                   Row& next) const;
  struct Settled {
    double before = 0, after = 0;
  };
  Settled settle_between(std::span<ChainNode> nodes, int steps);
  Settled settle_runs(std::span<ChainNode> nodes, int steps);
  bool go_along(std::span<ChainNode> nodes, double most, double& total);
  bool newton_step(std::span<ChainNode> nodes, double& total);
  bool assemble(std::span<const ChainNode> nodes);
  bool solve(std::span<const ChainNode> nodes);
  void tell_work() const;

  const SurfaceMesh& mesh_;
  const ExactPotential& potential_;
  double tolerance_;
  double smallest_;
  Asker* asker_;
  int round_ = 0;
  std::vector<Row> rows_;
  std::vector<LiftedPlace> trials_;
  std::vector<Link> links_;                               // per segment
  std::vector<PotentialInFace> middles_, tried_middles_;  // per segment
};

}  // namespace talweg
