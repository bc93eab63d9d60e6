#include "talweg/core/ridges/ridge_gates.hpp"

#include <algorithm>
#include <cmath>

#include "talweg/core/drawing/drawn_legs.hpp"
#include "talweg/core/mesh/border_points.hpp"

namespace talweg {
namespace {

constexpr double kCost = 0.1;           // RidgeGate::cost of clicks and ends
constexpr double kFaint = 0.125;        // RidgeGate::faint, as part of the band
constexpr double kLongestStretch = 16;  // in widths of the band
constexpr double kOfStretch = 1.0 / 3;
constexpr std::size_t kFewestOfLoop = 3;

/// The stretch of a curve from one gate to the next.
struct Stretch {
  RidgeGate from;
  double length = 0;
  bool is_leg = false;
};

class GateFinder {
 public:
  GateFinder(const SurfaceMesh& mesh, const SurfaceCurve& curve, const PointLookup& fixed,
             const RidgeBand& band)
      : mesh_(&mesh), curve_(&curve), fixed_(&fixed), band_(band) {
    const std::size_t n = curve.points.size();
    arcs_.assign(1, 0);
    for (std::size_t i = 0; i < n; ++i) {
      const SurfacePoint &p = curve.points[i], &q = curve.points[(i + 1) % n];
      arcs_.push_back(arcs_.back() + (mesh.position(p) - mesh.position(q)).norm());
    }
  }

  RidgeGates find(std::span<const WayPoint> way_points, std::span<const SurfacePoint> painted) {
    std::vector<Stretch> stretches = stretches_between_points(way_points, painted);
    if (stretches.empty()) stretches.push_back({gate_at(0, false), arcs_[curve_->points.size()]});
    RidgeGates found;
    const std::size_t loop = curve_->closed && stretches.size() < kFewestOfLoop ? kFewestOfLoop : 1;
    for (std::size_t k = 0; k < stretches.size(); ++k) {
      const std::size_t next = (k + 1) % stretches.size();
      const bool is_last = k + 1 == stretches.size();
      if (!curve_->closed && is_last) break;
      const std::size_t end = stretches[next].from.point + (is_last ? curve_->points.size() : 0);
      add(stretches[k], end, loop, found);
    }
    if (!curve_->closed) found.gates.push_back(stretches.back().from);
    limit(found);
    return found;
  }

 private:
  [[nodiscard]] double arc(std::size_t point) const {
    const std::size_t n = curve_->points.size();
    return arcs_[point % n] + (point >= n ? arcs_[n] : 0);
  }

  [[nodiscard]] RidgeGate gate_at(std::size_t point, bool is_click) const {
    const SurfacePoint& at = curve_->points[point];
    RidgeGate gate;
    gate.point = point;
    gate.is_click = is_click;
    if (fixed_->contains(at)) return gate;
    gate.radius = band_.width;
    const bool is_end = !curve_->closed && (point == 0 || point + 1 == curve_->points.size());
    gate.is_on_border = is_end && is_on_boundary(mesh_->surface(), at);
    if (is_click || (is_end && !gate.is_on_border)) {
      gate.cost = kCost;
      gate.faint = kFaint * band_.width;
    }
    if (!is_end || gate.is_on_border) return gate;
    gate.along = direction_at_end(point);
    gate.thickness = band_.edge / 2;
    if (!is_click) gate.leaves_for = gate.faint + gate.thickness;
    return gate;
  }

  /// The unit direction from an end to the curve's point two widths of the band away along the
  /// curve.
  [[nodiscard]] Point direction_at_end(std::size_t end) const {
    const std::size_t n = curve_->points.size();
    std::size_t to = end;
    while (std::abs(arcs_[to] - arcs_[end]) < 2 * band_.width && to != (end == 0 ? n - 1 : 0)) {
      to += end == 0 ? 1 : -1;
    }
    return (mesh_->position(curve_->points[to]) - mesh_->position(curve_->points[end]))
        .stableNormalized();
  }

  /// The stretches between successive clicks, fixed points and ends; `length` is not set.
  std::vector<Stretch> stretches_between_points(std::span<const WayPoint> way_points,
                                                std::span<const SurfacePoint> painted) const {
    PointLookup clicks;
    for (const WayPoint& way : way_points) clicks.add(way.point);
    const std::size_t n = curve_->points.size();
    std::vector<Stretch> stretches;
    std::vector<SurfacePoint> pins;
    for (std::size_t i = 0; i < n; ++i) {
      const SurfacePoint& p = curve_->points[i];
      const bool is_end = !curve_->closed && (i == 0 || i + 1 == n), is_click = clicks.contains(p);
      if (fixed_->contains(p)) pins.push_back(p);
      if (is_end || is_click || fixed_->contains(p)) stretches.push_back({gate_at(i, is_click)});
    }
    const DrawnLegs legs = legs_of(*curve_, pins, way_points, painted);
    if (legs.fixed.size() != stretches.size()) return stretches;
    for (std::size_t k = 0; k < legs.is_leg.size(); ++k) stretches[k].is_leg = legs.is_leg[k];
    return stretches;
  }

  /// Adds the gates and widths of a stretch up to point `end`. A stroke is divided by more gates.
  void add(const Stretch& stretch, std::size_t end, std::size_t least_parts,
           RidgeGates& found) const {
    const std::size_t n = curve_->points.size();
    const double begin = arc(stretch.from.point), length = arc(end) - begin;
    found.gates.push_back(stretch.from);
    if (stretch.is_leg) {
      const double most = std::max(band_.leg_width, band_.width);
      found.widths.push_back(std::clamp(band_.leg_part * length, band_.width, most));
      return;
    }
    found.widths.push_back(band_.width);
    const auto needed =
        static_cast<std::size_t>(std::ceil(length / (kLongestStretch * band_.width)));
    const std::size_t parts = std::max(least_parts, needed);
    std::size_t point = stretch.from.point;
    for (std::size_t k = 1; k < parts; ++k) {
      const double at = begin + length * static_cast<double>(k) / static_cast<double>(parts);
      const std::size_t last = point;
      while (point < end && arc(point) < at) ++point;
      if (point == last || point >= end) continue;
      RidgeGate gate = gate_at(point % n, false);
      gate.cost = 0;
      found.gates.push_back(gate);
      found.widths.push_back(band_.width);
    }
  }

  void limit(RidgeGates& found) const {
    const std::size_t m = found.gates.size(), n = curve_->points.size();
    for (std::size_t k = 0; k < found.widths.size(); ++k) {
      RidgeGate &from = found.gates[k], &to = found.gates[(k + 1) % m];
      const double length = arc(to.point + (k + 1 == m ? n : 0)) - arc(from.point);
      from.radius = std::min(from.radius, kOfStretch * length);
      to.radius = std::min(to.radius, kOfStretch * length);
    }
  }

  const SurfaceMesh* mesh_;
  const SurfaceCurve* curve_;
  const PointLookup* fixed_;
  RidgeBand band_;
  std::vector<double> arcs_;  // arc length at each point, then the length of the curve
};

}  // namespace

RidgeGates ridge_gates(const SurfaceMesh& mesh, const SurfaceCurve& curve, const PointLookup& fixed,
                       std::span<const WayPoint> way_points, std::span<const SurfacePoint> painted,
                       const RidgeBand& band) {
  return GateFinder(mesh, curve, fixed, band).find(way_points, painted);
}

}  // namespace talweg
