#include "talweg/core/smoothing/drag_stretch.hpp"

#include <algorithm>

#include <Eigen/Geometry>

#include "talweg/core/measure/measures.hpp"

namespace talweg {
namespace {

using StretchBox = Eigen::AlignedBox3d;

/// Finds the runs of consecutive points of one curve inside the box. A run also has the points just
/// outside the box.
class Runs {
 public:
  Runs(const SurfaceMesh& mesh, const SurfaceCurve& curve, const Corridor::Valley& valley,
       const StretchBox& box)
      : curve_(curve), valley_(valley), points_(positions_of(mesh, curve)) {
    for (const Point& p : points_) inside_.push_back(box.contains(p));
  }

  void add_to(DragStretch& stretch) {
    const std::size_t n = points_.size();
    const auto outside = std::find(inside_.begin(), inside_.end(), false);
    if (outside == inside_.end()) {
      stretch.near.push_back(curve_);
      stretch.valleys.push_back(valley_);
      return;
    }
    const std::size_t start =
        curve_.closed ? static_cast<std::size_t>(outside - inside_.begin()) : 0;
    for (std::size_t k = 0; k < n;) {
      if (!inside_[(start + k) % n]) {
        ++k;
        continue;
      }
      std::size_t end = k;
      while (end < n && inside_[(start + end) % n]) ++end;
      const bool before = curve_.closed || k > 0, after = curve_.closed || end < n;
      add_run(start + k - (before ? 1 : 0), end - k + (before ? 1 : 0) + (after ? 1 : 0), stretch);
      k = end;
    }
  }

 private:
  void add_run(std::size_t begin, std::size_t count, DragStretch& stretch) const {
    const std::size_t n = points_.size();
    SurfaceCurve& run = stretch.near.emplace_back();
    Corridor::Valley& valley = stretch.valleys.emplace_back(valley_);
    valley.slack_at.clear();
    valley.closed = false;
    if (valley_.closed) {
      valley.loop_length = length_of(0, n);
      valley.arc_start = length_of(0, begin);
    }
    for (std::size_t k = begin; k < begin + count; ++k) {
      run.points.push_back(curve_.points[k % n]);
      if (!valley_.slack_at.empty()) valley.slack_at.push_back(valley_.slack_at[k % n]);
    }
  }

  [[nodiscard]] double length_of(std::size_t first_segment, std::size_t count) const {
    const std::size_t n = points_.size();
    double sum = 0;
    for (std::size_t k = first_segment; k < first_segment + count; ++k) {
      sum += (points_[(k + 1) % n] - points_[k % n]).norm();
    }
    return sum;
  }

  const SurfaceCurve& curve_;
  const Corridor::Valley& valley_;
  std::vector<Point> points_;
  std::vector<bool> inside_;
};

}  // namespace

DragStretch stretch_of(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                       const std::vector<Corridor::Valley>& valleys, std::size_t number,
                       std::size_t first, std::size_t last, double reach) {
  DragStretch stretch;
  const auto points = std::span(curves[number].points).subspan(first, last - first);
  stretch.curve.points.assign(points.begin(), points.end());
  stretch.curve.closed = curves[number].closed && points.size() == curves[number].points.size();
  StretchBox box;
  for (const SurfacePoint& point : points) box.extend(mesh.position(point));
  box.min().array() -= reach;
  box.max().array() += reach;
  const auto add = [&](std::size_t c) { Runs(mesh, curves[c], valleys[c], box).add_to(stretch); };
  add(number);
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (c != number) add(c);
  }
  return stretch;
}

}  // namespace talweg
