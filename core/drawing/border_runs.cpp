#include "talweg/core/drawing/border_runs.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "talweg/core/mesh/border_points.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

constexpr double kBeyondInEdges = 1e-4;
constexpr double kAlongOfAway = 4;
constexpr int kLeavingHalvings = 50;  // the precision of a double

/// Walks along a stroke from one of its ends to its first sample on the mesh.
class WalkIn {
 public:
  WalkIn(const SurfaceMesh& mesh, const ClosestPoint& closest, std::span<const Point> samples,
         bool from_end)
      : mesh_(&mesh), closest_(&closest), samples_(samples), from_end_(from_end) {}

  [[nodiscard]] BorderRun run() const {
    BorderRun run;
    std::vector<Point> feet;
    for (; run.samples < samples_.size(); ++run.samples) {
      const ClosestPoint::Result nearest = closest_->nearest(at(run.samples));
      if (!is_beyond(nearest)) break;
      run.farthest = std::max(run.farthest, nearest.distance);
      feet.push_back(mesh_->position(nearest.point));
    }
    if (run.samples == 0 || run.samples == samples_.size()) return {};
    run.leaves = leaves(at(run.samples), at(run.samples - 1));
    const bool goes_along = std::any_of(feet.begin(), feet.end(), [&](const Point& foot) {
      return (foot - run.leaves).norm() > kAlongOfAway * run.farthest;
    });
    return goes_along ? BorderRun{} : run;
  }

 private:
  [[nodiscard]] const Point& at(std::size_t k) const {
    return samples_[from_end_ ? samples_.size() - 1 - k : k];
  }
  [[nodiscard]] bool is_at_border(const ClosestPoint::Result& nearest) const {
    return is_on_boundary(mesh_->surface(), nearest.point);
  }
  [[nodiscard]] bool is_beyond(const ClosestPoint::Result& nearest) const {
    return is_at_border(nearest) && nearest.distance > kBeyondInEdges * mesh_->mean_edge_length();
  }
  /// The place between two samples at which the stroke crosses the border, by bisection: `outside`
  /// is beyond the border, `inside` is not. If `inside` lies on the border, the place is `inside`.
  [[nodiscard]] Point leaves(Point inside, Point outside) const {
    if (is_at_border(closest_->nearest(inside))) return inside;
    for (int k = 0; k < kLeavingHalvings; ++k) {
      const Point middle = (inside + outside) / 2;
      (is_at_border(closest_->nearest(middle)) ? outside : inside) = middle;
    }
    return outside;
  }

  const SurfaceMesh* mesh_;
  const ClosestPoint* closest_;
  std::span<const Point> samples_;
  bool from_end_;
};

}  // namespace

std::array<BorderRun, 2> border_runs(const SurfaceMesh& mesh, const ClosestPoint& closest,
                                     std::span<const Point> samples) {
  return {WalkIn(mesh, closest, samples, false).run(), WalkIn(mesh, closest, samples, true).run()};
}

}  // namespace talweg
