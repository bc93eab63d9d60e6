#include "arc_length.hpp"

#include <algorithm>
#include <array>

#include "talweg/core/measure/measures.hpp"

namespace talweg::plugins {

ArcLength::ArcLength(const Surface& surface, const SurfaceCurve& curve)
    : surface_(&surface), curve_(&curve), arcs_{0} {
  const std::size_t segments = curve.points.size() - (curve.closed ? 0 : 1);
  for (std::size_t k = 0; k < segments; ++k) {
    arcs_.push_back(arcs_.back() + curve_length(surface, {false, {point(k), point(k + 1)}}));
  }
}

SurfacePoint ArcLength::at(double arc) const {
  const auto above = std::upper_bound(arcs_.begin() + 1, arcs_.end() - 1, arc);
  const auto k = static_cast<std::size_t>(above - arcs_.begin()) - 1;
  const SurfacePoint &from = point(k), &to = point(k + 1);
  const double segment = arcs_[k + 1] - arcs_[k];
  const double part = segment > 0 ? std::clamp((arc - arcs_[k]) / segment, 0.0, 1.0) : 0;
  if (part == 0 || from == to) return from;
  if (part == 1) return to;
  const FaceId face = common_face(*surface_, from, to);
  const FaceCoordinates a = coordinates_in(*surface_, from, face);
  const FaceCoordinates b = coordinates_in(*surface_, to, face);
  std::array<double, 3> mixed{};
  for (std::size_t i = 0; i < 3; ++i) {
    mixed[i] = (1 - part) * a.barycentric[i] + part * b.barycentric[i];
  }
  return SurfacePoint::from_barycentric(*surface_, face, mixed);
}

}  // namespace talweg::plugins
