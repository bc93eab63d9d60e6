#include "talweg/core/drawing/sheet_matching.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_set>
#include <utility>

namespace talweg {
namespace {

constexpr double kFarthestStep = 16;  // mean edges
constexpr double kBallOfStep = 0.75, kBallOfEdge = 1;
constexpr double kReachOfDistance = 2, kReachOfEdge = 0.5;
constexpr double kJumpOfEdge = 4, kJumpOfStep = 2;
constexpr double kUsual = 0.9;  // quantile of the distances that is the usual distance
constexpr std::size_t kMostSheets = 8;

using Candidate = ClosestPoint::Result;

/// Tells whether a step between successive candidates has a path over the faces that is about as
/// short as the way through space.
class Steps {
 public:
  explicit Steps(const SurfaceMesh& mesh) : mesh_(&mesh), edge_(mesh.mean_edge_length()) {}

  /// Whether a path over the faces joins both points inside a ball about both.
  [[nodiscard]] bool can_walk(const Candidate& from, const Candidate& to) const {
    if (from.face == to.face) return true;
    const Point p = mesh_->position(from.point), q = mesh_->position(to.point);
    const double step = (q - p).norm();
    if (step > kFarthestStep * edge_) return true;
    const double radius = kBallOfStep * step + kBallOfEdge * local_edge(from.face, to.face);
    return is_connected(from.face, to.face, (p + q) / 2, radius);
  }
  [[nodiscard]] double cost(const Candidate& from, const Candidate& to) const {
    if (can_walk(from, to)) return 0;
    const double step = (mesh_->position(to.point) - mesh_->position(from.point)).norm();
    return kJumpOfEdge * edge_ + kJumpOfStep * step;
  }

 private:
  [[nodiscard]] double local_edge(FaceId a, FaceId b) const {
    double longest = 0;
    for (const FaceId face : {a, b}) {
      for (HalfedgeId h = mesh_->surface().halfedge(face), k = h;;) {
        longest = std::max(longest, mesh_->surface().length(edge_of(k)));
        k = mesh_->surface().next(k);
        if (k == h) break;
      }
    }
    return longest;
  }

  [[nodiscard]] bool is_connected(FaceId from, FaceId to, const Point& centre,
                                  double radius) const {
    const Surface& surface = mesh_->surface();
    std::unordered_set<FaceId> seen{from};
    std::vector<FaceId> waiting{from};
    while (!waiting.empty()) {
      const FaceId face = waiting.back();
      waiting.pop_back();
      HalfedgeId h = surface.halfedge(face);
      for (std::size_t k = 0; k < 3; ++k, h = surface.next(h)) {
        if (!surface.has_face(twin(h))) continue;
        const FaceId next = surface.face(twin(h));
        if (next == to) return true;
        if (!seen.insert(next).second) continue;
        if (distance_to_face(*mesh_, next, centre) <= radius) waiting.push_back(next);
      }
    }
    return false;
  }

  const SurfaceMesh* mesh_;
  double edge_;
};

/// The candidates with the least total cost, by dynamic programming over the points (Viterbi 1967).
class Matching {
 public:
  Matching(const SurfaceMesh& mesh, const ClosestPoint& closest, std::span<const Point> positions,
           std::span<const Candidate> nearest)
      : steps_(mesh),
        surface_(&mesh.surface()),
        components_(components_of(mesh.surface()).of_vertex) {
    // A point may lie exactly on the wrong sheet, so the reach also depends on the usual distance
    // of all points.
    std::vector<double> off;
    for (const Candidate& candidate : nearest) off.push_back(candidate.distance);
    const auto usual =
        off.begin() + static_cast<std::ptrdiff_t>(kUsual * static_cast<double>(off.size()));
    std::nth_element(off.begin(), usual, off.end());
    for (std::size_t k = 0; k < positions.size(); ++k) {
      const double reach = kReachOfDistance * std::max(nearest[k].distance, *usual) +
                           kReachOfEdge * mesh.mean_edge_length();
      candidates_.push_back(closest.on_sheets(positions[k], reach, kMostSheets));
      const double step = k > 0 ? (positions[k] - positions[k - 1]).norm() : 0;
      to_component_ += kJumpOfEdge * mesh.mean_edge_length() + kJumpOfStep * step +
                       (1 + 2 * kJumpOfStep) * reach;
    }
  }

  std::vector<Candidate> best() const {
    std::vector<double> cost;
    for (const Candidate& c : candidates_.front()) cost.push_back(c.distance);
    std::vector<std::vector<std::size_t>> came_from(candidates_.size());
    for (std::size_t k = 1; k < candidates_.size(); ++k) {
      std::vector<double> next;
      for (const Candidate& to : candidates_[k]) {
        double least = std::numeric_limits<double>::infinity();
        std::size_t from = 0;
        for (std::size_t i = 0; i < candidates_[k - 1].size(); ++i) {
          const double own = cost[i] + step_cost(candidates_[k - 1][i], to);
          if (own < least) {
            least = own;
            from = i;
          }
        }
        next.push_back(least + to.distance);
        came_from[k].push_back(from);
      }
      cost = std::move(next);
    }
    return traced_back(cost, came_from);
  }

 private:
  [[nodiscard]] std::uint32_t component(const Candidate& candidate) const {
    return components_[surface_->corners(candidate.face)[0].index()];
  }
  [[nodiscard]] double step_cost(const Candidate& from, const Candidate& to) const {
    return component(from) == component(to) ? steps_.cost(from, to) : to_component_;
  }
  [[nodiscard]] std::vector<Candidate> traced_back(
      const std::vector<double>& cost,
      const std::vector<std::vector<std::size_t>>& came_from) const {
    auto at = static_cast<std::size_t>(std::min_element(cost.begin(), cost.end()) - cost.begin());
    std::vector<Candidate> path;
    for (std::size_t k = candidates_.size(); k-- > 0;) {
      path.push_back(candidates_[k][at]);
      if (k > 0) at = came_from[k][at];
    }
    std::reverse(path.begin(), path.end());
    return path;
  }

  Steps steps_;
  const Surface* surface_;
  std::vector<std::uint32_t> components_;  ///< of vertices
  double to_component_ = 0;  ///< more than the cost of any matching within a component
  std::vector<std::vector<Candidate>> candidates_;
};

void count_jumps(const Steps& steps, bool closed, SheetMatching& matching) {
  const std::size_t n = matching.points.size();
  for (std::size_t k = 0; k + (closed ? 0 : 1) < n; ++k) {
    if (steps.can_walk(matching.points[k], matching.points[(k + 1) % n])) continue;
    if (matching.jumps++ == 0) matching.first_jump = k;
  }
}

}  // namespace

SheetMatching matched_to_sheets(const SurfaceMesh& mesh, const ClosestPoint& closest,
                                std::span<const Point> positions, bool closed,
                                std::vector<ClosestPoint::Result> nearest) {
  const Steps steps(mesh);
  SheetMatching matching;
  matching.points = std::move(nearest);
  count_jumps(steps, closed, matching);
  if (matching.jumps == 0) return matching;
  std::vector<Candidate> best = Matching(mesh, closest, positions, matching.points).best();
  for (std::size_t k = 0; k < best.size(); ++k) {
    if (best[k].face == matching.points[k].face || best[k].distance == matching.points[k].distance)
      continue;
    if (matching.moved++ == 0) matching.first_moved = k;
  }
  if (matching.moved == 0) return matching;
  matching.points = std::move(best);
  matching.jumps = 0;
  count_jumps(steps, closed, matching);
  return matching;
}

}  // namespace talweg
