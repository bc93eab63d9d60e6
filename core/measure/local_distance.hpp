// A local distance is measured from those parts of curves that can be nearest to a piece of
// another.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "talweg/core/measure/curve_segments.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/space/nearest_segment.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"

namespace talweg {

/// Selects the parts of some curves that lie near in space. Ways along the surface are never
/// shorter than through space, so the other parts cannot be nearest.
class NearParts {
 public:
  NearParts(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves) : curves_(curves) {
    std::vector<Segment> segments;
    for (const SurfaceCurve& curve : curves) {
      const auto own = segments_of(positions_of(mesh, curve), curve.closed);
      counts_.push_back(own.size());
      segments.insert(segments.end(), own.begin(), own.end());
    }
    for (const Segment& s : segments) boxes_.push_back(Eigen::AlignedBox3d(s.a).extend(s.b));
    tree_.emplace(std::move(segments));
  }

  /// Distance through space.
  [[nodiscard]] double distance(const Point& p) const { return tree_->to(p).distance; }

  /// The segments whose boxes meet one of these boxes, as curves.
  [[nodiscard]] std::vector<SurfaceCurve> meeting(
      std::span<const Eigen::AlignedBox3d> boxes) const {
    Eigen::AlignedBox3d all;
    for (const Eigen::AlignedBox3d& box : boxes) all.extend(box);
    std::vector<SurfaceCurve> parts;
    std::size_t first = 0;
    for (std::size_t c = 0; c < curves_.size(); first += counts_[c++]) {
      const auto& points = curves_[c].points;
      bool joined = false;
      for (std::size_t i = 0; i < counts_[c]; ++i) {
        const Eigen::AlignedBox3d& box = boxes_[first + i];
        const bool near =
            all.intersects(box) && std::any_of(boxes.begin(), boxes.end(),
                                               [&](const auto& b) { return b.intersects(box); });
        if (near && !joined) parts.push_back({false, {points[i]}});
        if (near && points.size() > 1) {
          parts.back().points.push_back(points[(i + 1) % points.size()]);
        }
        joined = near;
      }
    }
    return parts;
  }

 private:
  std::span<const SurfaceCurve> curves_;
  std::vector<std::size_t> counts_;  // number of segments of each curve
  std::vector<Eigen::AlignedBox3d> boxes_;
  std::optional<NearestSegment> tree_;
};

/// Sets a distance to the parts of the curves that can be nearest to some segments.
class LocalDistance {
 public:
  /// Distances of `limit` or more will not be needed.
  LocalDistance(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                PolylineDistance& distance, double limit = HUGE_VAL)
      : mesh_(&mesh), curves_(curves), parts_(mesh, curves), distance_(&distance), limit_(limit) {}

  /// A guess, from distances in space, of the largest distance on a segment; it may turn out too
  /// small.
  [[nodiscard]] double guess(const CurveSegment& s) const {
    return kMore *
           bound(s, [&](const SurfacePoint& p) { return parts_.distance(mesh_->position(p)); });
  }

  /// `reach` holds the guesses. Returns the curves that the distance is set to.
  std::vector<SurfaceCurve> set_near(std::span<const CurveSegment> segments,
                                     std::span<double> reach) {
    std::vector<SurfaceCurve> near = set(segments, reach);
    bool proved = true;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const double most = bound(segments[i], [&](const SurfacePoint& p) {
        return std::isfinite(limit_) ? distance_->below(limit_, p) : distance_->at(p).distance;
      });
      proved = proved && most <= reach[i];
      reach[i] = std::max(reach[i], most);
    }
    return proved ? near : set(segments, reach);
  }

 private:
  static constexpr double kMore = 1.05;

  template <class Distance>
  [[nodiscard]] double bound(const CurveSegment& s, Distance distance) const {
    const Surface& surface = mesh_->surface();
    return (distance(s.point(surface, 0)) + distance(s.point(surface, 1)) + s.length) / 2;
  }

  std::vector<SurfaceCurve> set(std::span<const CurveSegment> segments,
                                std::span<const double> reach) {
    std::vector<Eigen::AlignedBox3d> boxes;
    bool everything = false;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      everything = everything || !std::isfinite(reach[i]);
      const Surface& surface = mesh_->surface();
      Eigen::AlignedBox3d box(mesh_->position(segments[i].point(surface, 0)));
      box.extend(mesh_->position(segments[i].point(surface, 1)));
      const Point margin = Point::Constant(reach[i]);
      boxes.emplace_back(box.min() - margin, box.max() + margin);
    }
    std::vector<SurfaceCurve> near =
        everything ? std::vector(curves_.begin(), curves_.end()) : parts_.meeting(boxes);
    distance_->set(near);
    return near;
  }

  const SurfaceMesh* mesh_;
  std::span<const SurfaceCurve> curves_;
  NearParts parts_;
  PolylineDistance* distance_;
  double limit_;
};

}  // namespace talweg
