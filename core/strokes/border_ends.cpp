#include "talweg/core/strokes/border_ends.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <unordered_set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "talweg/core/measure/edge_length_near.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/core/mesh/border_points.hpp"
#include "talweg/core/space/message_numbers.hpp"
#include "talweg/core/space/nearest_segment.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

constexpr double kReachOfEdge = 2, kReachOfStep = 1.5, kStepOfLength = 1.0 / 12,
                 kReachOfLength = 0.5;
constexpr double kWayOfReach = 2;  // the longest way over the surface, as part of the reach

/// A search over the faces around a point that lie within reach through space.
class BorderSearch {
 public:
  BorderSearch(const SurfaceMesh& mesh, const SurfacePoint& from, double reach)
      : mesh_(&mesh), at_(mesh.position(from)), least_(reach) {
    for (const FaceId face : faces_at(mesh.surface(), from)) meet(face);
  }

  /// The nearest point of the border within reach, if any.
  [[nodiscard]] std::optional<SurfacePoint> nearest() {
    const Surface& surface = mesh_->surface();
    const double reach = least_;
    for (std::size_t next = 0; next < waiting_.size(); ++next) {
      HalfedgeId side = surface.halfedge(waiting_[next]);
      for (int k = 0; k < 3; ++k, side = surface.next(side)) {
        const double away = distance_to(segment(edge_of(side)), at_);
        if (away > reach) continue;
        if (surface.has_face(twin(side))) {
          meet(surface.face(twin(side)));
        } else if (away <= least_) {
          least_ = away;
          border_ = edge_of(side);
        }
      }
    }
    if (!border_) return std::nullopt;
    return settled(surface, point_on(*border_));
  }

 private:
  void meet(FaceId face) {
    if (met_.insert(face.index()).second) waiting_.push_back(face);
  }
  [[nodiscard]] Segment segment(EdgeId edge) const {
    const HalfedgeId h = halfedge_of(edge);
    return {mesh_->point(mesh_->surface().tail(h)), mesh_->point(mesh_->surface().head(h))};
  }
  [[nodiscard]] SurfacePoint point_on(EdgeId edge) const {
    const Surface& surface = mesh_->surface();
    const Segment s = segment(edge);
    const Point way = s.b - s.a;
    const double t = way.squaredNorm() > 0 ? (at_ - s.a).dot(way) / way.squaredNorm() : 0;
    if (t <= 0) return SurfacePoint::at_vertex(surface, surface.tail(halfedge_of(edge)));
    if (t >= 1) return SurfacePoint::at_vertex(surface, surface.head(halfedge_of(edge)));
    return SurfacePoint::on_edge(surface, edge, t);
  }

  const SurfaceMesh* mesh_;
  Point at_;
  double least_;
  std::vector<FaceId> waiting_;
  std::unordered_set<std::size_t> met_;  // only looked up
  std::optional<EdgeId> border_;
};

/// The first or the last point of a curve of a drawing.
struct CurveEnd {
  std::size_t curve = 0;
  bool last = false;

  [[nodiscard]] const SurfacePoint& of(const SnappedDrawing& drawing) const {
    const std::vector<SurfacePoint>& points = drawing.curves[curve].points;
    return last ? points.back() : points.front();
  }
};

double reach_of(const SurfaceMesh& mesh, const SnappedDrawing& drawing, const CurveEnd& end) {
  const SurfaceCurve &curve = drawing.curves[end.curve], alone{false, {end.of(drawing)}};
  const double length = curve_length(mesh.surface(), curve);
  double reach = kReachOfEdge * edge_length_near(mesh.surface(), alone);
  if (end.curve < drawing.hand_steps.size()) {
    const double step = drawing.hand_steps[end.curve][end.last ? 1 : 0];
    reach = std::max(reach, std::min(kReachOfStep * step, kStepOfLength * length));
  }
  return std::min(reach, kReachOfLength * length);
}

bool is_on_another(const SnappedDrawing& drawing, const CurveEnd& end) {
  const SurfacePoint& point = end.of(drawing);
  for (std::size_t c = 0; c < drawing.curves.size(); ++c) {
    const std::vector<SurfacePoint>& points = drawing.curves[c].points;
    const auto passes = std::count(points.begin(), points.end(), point);
    if (passes > (c == end.curve ? 1 : 0)) return true;
  }
  return false;
}

/// The straight way from an end to the border near it, without the end itself.
std::optional<std::vector<SurfacePoint>> way_to_border(const SurfaceMesh& mesh,
                                                       const SnappedDrawing& drawing,
                                                       const CurveEnd& end, StraightLines& lines) {
  const Surface& surface = mesh.surface();
  const SurfacePoint& from = end.of(drawing);
  if (is_on_boundary(surface, from)) return std::nullopt;
  const double reach = reach_of(mesh, drawing, end);
  const std::optional<SurfacePoint> to = BorderSearch(mesh, from, reach).nearest();
  if (!to || is_on_another(drawing, end)) return std::nullopt;
  std::vector<SurfacePoint> way{from};
  if (const SurfacePoint begin = settled(surface, from); !(begin == from)) way.push_back(begin);
  if (!(way.back() == *to)) {
    const std::vector<SurfacePoint> ends{way.back(), *to};
    way.pop_back();
    const SurfaceCurve line = lines.join(ends, false);
    way.insert(way.end(), line.points.begin(), line.points.end());
  }
  if (curve_length(surface, {false, way}) > kWayOfReach * reach) return std::nullopt;
  way.erase(way.begin());
  return way;
}

void extend_end(const SurfaceMesh& mesh, const CurveEnd& end, std::vector<SurfacePoint> way,
                SnappedDrawing& drawing) {
  std::vector<SurfacePoint>& points = drawing.curves[end.curve].points;
  SurfaceCurve extended{false, {end.of(drawing)}};
  extended.points.insert(extended.points.end(), way.begin(), way.end());
  drawing.notes.push_back(
      fmt::format("The {} of curve {} lies {} from the border of the mesh; the "
                  "curve was extended straight to the border.",
                  end.last ? "end" : "start", end.curve,
                  mesh_units_text(curve_length(mesh.surface(), extended))));
  drawing.all_exact.push_back({way.back(), 0});
  if (end.last) {
    points.insert(points.end(), way.begin(), way.end());
  } else {
    points.insert(points.begin(), way.rbegin(), way.rend());
  }
}

bool is_extended(const SnappedDrawing& drawing, std::size_t curve, ExtendedCurves which) {
  if (drawing.curves[curve].closed) return false;
  if (which == ExtendedCurves::kAll) return true;
  return curve < drawing.hand_steps.size() && drawing.hand_steps[curve][0] > 0;
}

}  // namespace

BorderEnds border_ends(std::string_view name) {
  if (name == "snap") return BorderEnds::kSnap;
  if (name == "leave") return BorderEnds::kLeave;
  throw Error(
      ErrorCode::kBadUsage,
      fmt::format("The option for ends near the border must be snap or leave, not \"{}\".", name));
}

SnappedDrawing with_ends_at_border(const SurfaceMesh& mesh, SnappedDrawing drawing,
                                   StraightLines& lines, ExtendedCurves which) {
  for (std::size_t c = 0; c < drawing.curves.size(); ++c) {
    if (!is_extended(drawing, c, which)) continue;
    // Both ways are found before an end is extended: the reach of an end depends on the length of
    // the drawn curve, without the extension of its other end.
    const CurveEnd start{c, false}, last{c, true};
    auto to_start = way_to_border(mesh, drawing, start, lines);
    auto to_last = way_to_border(mesh, drawing, last, lines);
    if (to_start) extend_end(mesh, start, *std::move(to_start), drawing);
    if (to_last) extend_end(mesh, last, *std::move(to_last), drawing);
  }
  return drawing;
}

}  // namespace talweg
