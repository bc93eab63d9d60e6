// A local distance is computed from the nearby parts of curves only.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "talweg/core/measure/curve_segments.hpp"
#include "talweg/core/measure/segments_in_space.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"

namespace talweg {

/// Selects the parts of curves that are near in space. Ways along the surface are never shorter
/// than through space, so other parts cannot be nearest along the surface. Building is O(n log n)
/// for n segments.
class NearParts {
 public:
  NearParts(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves)
      : segments_(mesh, curves) {}

  /// The distance of a position to the curves through space, mesh units.
  [[nodiscard]] double distance(const Point& p) const { return segments_.tree().to(p).distance; }

  /// The segments whose boxes overlap one of the given boxes, as curves. O(log n + overlaps) for a
  /// box.
  [[nodiscard]] std::vector<SurfaceCurve> meeting(
      std::span<const Eigen::AlignedBox3d> boxes) const {
    std::vector<std::uint32_t> near;
    for (const Eigen::AlignedBox3d& box : boxes) {
      segments_.tree().visit_near({box.min(), box.max()},
                                  [&](std::uint32_t i) { near.push_back(i); });
    }
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    return segments_.as_curves(near);
  }

 private:
  SegmentsInSpace segments_;
};

/// Sets a PolylineDistance to the parts of curves that can be nearest to given segments.
class LocalDistance {
 public:
  /// Distances of `limit` (mesh units) or more may be wrong.
  LocalDistance(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                PolylineDistance& distance, double limit = HUGE_VAL)
      : mesh_(&mesh), curves_(curves), parts_(mesh, curves), distance_(&distance), limit_(limit) {}

  /// An estimate of the largest distance on a segment, from distances through space; may be too
  /// small.
  [[nodiscard]] double guess(const CurveSegment& s) const {
    return kMore *
           bound(s, [&](const SurfacePoint& p) { return parts_.distance(mesh_->position(p)); });
  }

  /// Sets the distance to the parts within `reach` of the segments; `reach` has the guess() of each
  /// segment, and is enlarged if the exact distances at the ends show that a guess was too small.
  /// Then the parts are selected a second time. Returns the parts.
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
