#include "talweg/core/ridges/ridge_way.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>

#include "talweg/core/mesh/border_points.hpp"
#include "talweg/core/ridges/ridge_corridor.hpp"
#include "talweg/intrinsic/surface/point_lookup.hpp"

namespace talweg {
namespace {

constexpr std::uint64_t kTheGateItself = std::numeric_limits<std::uint64_t>::max();

/// A node of a corridor at a gate, and the cost of passing the gate at this node.
struct GateNode {
  std::size_t node = 0;
  double cost = 0;
};
/// The nodes at a gate by RidgeCorridor::key(), which is the same in the corridors on both sides of
/// the gate. The map is only looked up or reduced to a minimum, so its order does not matter.
using GateNodes = std::unordered_map<std::uint64_t, GateNode>;

class WayFinder {
 public:
  WayFinder(const SurfaceMesh& mesh, RidgeField& field, const SurfaceCurve& curve,
            const RidgeGates& gates, double strength, ProgressPoller& poller)
      : mesh_(&mesh), curve_(&curve), gates_(&gates), poller_(&poller) {
    const std::size_t n = curve.points.size(), m = gates.gates.size();
    for (std::size_t k = 0; k < gates.widths.size(); ++k) {
      std::vector<SurfacePoint> line;
      const std::size_t from = gates.gates[k].point, to = gates.gates[(k + 1) % m].point;
      for (std::size_t i = from; line.empty() || i != to; i = (i + 1) % n) {
        line.push_back(curve.points[i]);
      }
      line.push_back(curve.points[to]);
      legs_.emplace_back(mesh, field, line, RidgeCorridor::Settings{gates.widths[k], strength},
                         poller);
    }
  }

  std::vector<RidgeStep> find() {
    if (!curve_->closed) {
      search(0, std::nullopt);
      return way_back(0, best_end(0));
    }
    for (std::size_t k = 0; k < gates_->gates.size(); ++k) {
      if (gates_->gates[k].radius > 0) continue;
      search(k, kTheGateItself);
      return way_back(k, kTheGateItself);
    }
    search(0, std::nullopt);
    way_back(0, best_end(0));
    const std::size_t middle = legs_.size() / 2;
    const std::uint64_t through = passed_[middle];
    search(middle, through);
    return way_back(middle, through);
  }

 private:
  [[nodiscard]] std::size_t gate_after(std::size_t leg) const {
    return (leg + 1) % gates_->gates.size();
  }

  /// The nodes of a leg at its first or its last gate.
  [[nodiscard]] GateNodes nodes_at(std::size_t leg, bool last) const {
    const RidgeCorridor& corridor = legs_[leg];
    const RidgeGate& gate = gates_->gates[last ? gate_after(leg) : leg];
    const std::size_t itself = corridor.drawn_node(last ? corridor.drawn_count() - 1 : 0);
    GateNodes nodes{{kTheGateItself, {itself, 0}}};
    if (!(gate.radius > 0)) return nodes;
    std::vector<Point> ridge;
    for (std::size_t node = 0; node < corridor.drawn_node(0); ++node) {
      const double away = (corridor.position(node) - corridor.position(itself)).norm();
      if (away > gate.radius || !corridor.is_inside(node)) continue;
      const Point off = corridor.position(node) - corridor.position(itself);
      const double ahead = std::abs(off.dot(gate.along));
      if (ahead > gate.thickness) continue;
      if (gate.cost > 0 && corridor.pull(node) < RidgeCorridor::kAsDrawn) continue;
      if (gate.is_on_border && !is_on_boundary(mesh_->surface(), corridor.point(node))) continue;
      const double cost = gate.cost * away + ahead + gate.faint * (1 - corridor.pull(node));
      nodes.emplace(corridor.key(node), GateNode{node, cost});
      ridge.push_back(corridor.position(node));
    }
    if (gate.leaves_for > 0 && is_narrow(ridge, corridor.position(itself), gate.radius)) {
      nodes.at(kTheGateItself).cost = gate.leaves_for;
    }
    return nodes;
  }

  /// Whether a ridge passes through the gate: the ridge's nodes at the gate then lie within `width`
  /// of each other. Nodes of a ridge that crosses the drawing lie farther apart.
  [[nodiscard]] static bool is_narrow(const std::vector<Point>& ridge, const Point& middle,
                                      double width) {
    if (ridge.empty()) return false;
    const auto farthest_from = [&](const Point& from) {
      return *std::max_element(ridge.begin(), ridge.end(), [&](const Point& a, const Point& b) {
        return (a - from).squaredNorm() < (b - from).squaredNorm();
      });
    };
    const Point end = farthest_from(middle);
    return (farthest_from(end) - end).norm() <= width;
  }

  /// Searches all legs in order from gate `first`, starting from the node with key `from`, or from
  /// all nodes of the gate.
  void search(std::size_t first, std::optional<std::uint64_t> from) {
    std::vector<RidgeCorridor::Start> starts;
    for (const auto& [key, at] : nodes_at(first, false)) {
      if (!from || *from == key) starts.push_back({at.node, at.cost});
    }
    for (std::size_t k = 0; k < legs_.size(); ++k) {
      const std::size_t leg = (first + k) % legs_.size();
      legs_[leg].run(starts, *poller_);
      if (k + 1 == legs_.size()) return;
      const std::size_t next = (leg + 1) % legs_.size();
      const GateNodes entries = nodes_at(next, false);
      starts.clear();
      for (const auto& [key, at] : nodes_at(leg, true)) {
        const auto entry = entries.find(key);
        if (entry == entries.end()) continue;
        starts.push_back({entry->second.node, legs_[leg].cost(at.node) + at.cost});
      }
    }
  }

  /// The key of the cheapest node at the last gate; of equally cheap nodes, the smallest key.
  [[nodiscard]] std::uint64_t best_end(std::size_t first) const {
    const std::size_t last = (first + legs_.size() - 1) % legs_.size();
    std::pair<double, std::uint64_t> best{std::numeric_limits<double>::infinity(), kTheGateItself};
    for (const auto& [key, at] : nodes_at(last, true)) {
      best = std::min(best, {legs_[last].cost(at.node) + at.cost, key});
    }
    return best.second;
  }

  /// The cheapest way to a node of the last gate. Sets passed_ to the nodes at which the way passes
  /// the gates.
  std::vector<RidgeStep> way_back(std::size_t first, std::uint64_t end) {
    std::vector<std::vector<RidgeStep>> parts(legs_.size());
    passed_.assign(gates_->gates.size(), kTheGateItself);
    for (std::size_t k = legs_.size(); k-- > 0;) {
      const std::size_t leg = (first + k) % legs_.size();
      passed_[gate_after(leg)] = end;
      const std::vector<std::size_t> way = legs_[leg].way_to(nodes_at(leg, true).at(end).node);
      parts[k] = steps_of(leg, way);
      end = kTheGateItself;
      if (way.front() != legs_[leg].drawn_node(0)) end = legs_[leg].key(way.front());
    }
    passed_[first] = end;
    std::vector<RidgeStep> steps;
    for (const std::vector<RidgeStep>& part : parts) {
      for (const RidgeStep& step : part) append(step, steps);
    }
    if (curve_->closed && steps.size() > 1 && steps.front().point == steps.back().point) {
      merge(steps.back(), steps.front());
      steps.pop_back();
    }
    return steps;
  }

  static void merge(const RidgeStep& from, RidgeStep& into) {
    if (!into.drawn) into.drawn = from.drawn;
    if (!into.gate) into.gate = from.gate;
  }

  static void append(const RidgeStep& step, std::vector<RidgeStep>& steps) {
    if (steps.empty() || !(steps.back().point == step.point)) {
      steps.push_back(step);
      return;
    }
    merge(step, steps.back());
    steps.back().ridge_next = step.ridge_next;
  }

  [[nodiscard]] std::vector<RidgeStep> steps_of(std::size_t leg,
                                                const std::vector<std::size_t>& way) const {
    const RidgeCorridor& corridor = legs_[leg];
    const std::size_t n = curve_->points.size(), from = gates_->gates[leg].point;
    PointLookup line;
    for (std::size_t k = 0; k < corridor.drawn_count(); ++k) {
      line.add(corridor.point(corridor.drawn_node(k)));
    }
    std::vector<RidgeStep> steps;
    for (std::size_t k = 0; k < way.size(); ++k) {
      RidgeStep step{corridor.point(way[k]), {}, {}, false};
      if (const auto drawn = line.find(step.point)) step.drawn = (from + *drawn) % n;
      if (corridor.is_drawn(way[k])) {
        step.drawn = (from + way[k] - corridor.drawn_node(0)) % n;
      }
      if (k + 1 < way.size()) step.ridge_next = corridor.is_ridge_between(way[k], way[k + 1]);
      steps.push_back(step);
    }
    steps.front().gate = leg;
    steps.back().gate = gate_after(leg);
    return steps;
  }

  const SurfaceMesh* mesh_;
  const SurfaceCurve* curve_;
  const RidgeGates* gates_;
  ProgressPoller* poller_;
  std::vector<RidgeCorridor> legs_;
  std::vector<std::uint64_t> passed_;  // per gate, the key of a node; set by way_back()
};

}  // namespace

std::vector<RidgeStep> ridge_way(const SurfaceMesh& mesh, RidgeField& field,
                                 const SurfaceCurve& curve, const RidgeGates& gates,
                                 double strength, ProgressPoller& poller) {
  return WayFinder(mesh, field, curve, gates, strength, poller).find();
}

}  // namespace talweg
