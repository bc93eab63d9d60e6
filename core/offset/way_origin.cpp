#include "talweg/core/offset/way_origin.hpp"

#include <algorithm>
#include <cstddef>
#include <variant>

namespace talweg {
namespace {

bool ends_on_boundary(const Surface& surface, const SurfacePoint& point) {
  if (const auto* v = std::get_if<AtVertex>(&point.where())) return surface.on_boundary(v->vertex);
  if (const auto* e = std::get_if<OnEdge>(&point.where())) return surface.on_boundary(e->edge);
  return false;
}

/// The side of a segment in the same face on which a point lies: 1 left, -1 right; 0 if the point
/// lies on the line or is nearest to an end of the segment.
int side_of_segment(const FacePaths& paths, const PolylinePiece& segment,
                    const std::array<double, 3>& b) {
  const PlanePoint p = paths.frames[0].at(segment.from, 0), q = paths.frames[0].at(segment.to, 0);
  const PlanePoint x = paths.frames[0].at(b, 0);
  const double part = dot(x - p, q - p), side = cross(q - p, x - p);
  if (!(part > 0 && part < dot(q - p, q - p)) || side == 0) return 0;
  return side > 0 ? 1 : -1;
}

int side_of(const FacePaths& paths, const FacePaths::Hit& way, const std::array<double, 3>& b) {
  if (way.window != nullptr) return way.window->window.arc_sign;
  return way.segment != nullptr ? side_of_segment(paths, *way.segment, b) : 0;
}

/// The shortest way, or an equally short way that begins beside a curve: at a vertex, the way along
/// an edge is as short as the way through the face.
FacePaths::Hit sided_hit(const FacePaths& paths, const std::array<double, 3>& b) {
  const FacePaths::Hit hit = paths.hit(b);
  if (side_of(paths, hit, b) != 0) return hit;
  const double most =
      hit.nearest.distance + NearestOnCurve::kSame * std::max(hit.nearest.distance, paths.longest);
  for (std::size_t i = 3; i < paths.count(); ++i) {
    const FacePaths::Hit way = paths.path(i, b);
    if (way.nearest.distance <= most && side_of(paths, way, b) != 0) return way;
  }
  return hit;
}

}  // namespace

WayOrigins::WayOrigins(const Surface& surface, std::span<const SurfaceCurve> curves,
                       PolylineDistance& distance, double limit)
    : distance_(&distance), limit_(limit) {
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const SurfaceCurve& curve = curves[c];
    const bool open = !curve.closed && distance.curve_length(c) > 0;
    ends_.push_back({open && !ends_on_boundary(surface, curve.points.front()),
                     open && !ends_on_boundary(surface, curve.points.back())});
  }
}

WayOrigin WayOrigins::of(const FaceCoordinates& at) const {
  constexpr double kEndPart = 1e-12;  // fraction of the curve
  const FacePaths& paths = distance_->paths_into(at.face, limit_);
  const FacePaths::Hit hit = sided_hit(paths, at.barycentric);
  const int side = side_of(paths, hit, at.barycentric);
  const NearestOnCurve& nearest = hit.nearest;
  WayOrigin origin{WayOrigin::Kind::kUnknown, nearest.curve, nearest.arc_length, nearest.distance};
  const double length = distance_->curve_length(nearest.curve);
  if (side != 0) {
    origin.kind = side > 0 ? WayOrigin::Kind::kLeft : WayOrigin::Kind::kRight;
  } else if ((ends_[nearest.curve].first && nearest.arc_length <= kEndPart * length) ||
             (ends_[nearest.curve].last && nearest.arc_length >= (1 - kEndPart) * length)) {
    origin.kind = WayOrigin::Kind::kEnd;
  }
  return origin;
}

}  // namespace talweg
