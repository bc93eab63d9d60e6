#include "talweg/core/drawing/straight_lines.hpp"

#include <algorithm>
#include <numeric>
#include <string>

#include <fmt/format.h>

#include "talweg/core/drawing/edge_dijkstra.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/flips/flip_out.hpp"
#include "talweg/intrinsic/flips/point_insertion.hpp"
#include "talweg/intrinsic/flips/signpost_triangulation.hpp"
#include "talweg/intrinsic/flips/trace.hpp"

namespace talweg {

std::string gap_warning(const JoinedGaps& gaps) {
  if (gaps.count == 0) return "";
  return fmt::format(
      "{} {} of the drawing, over four times as long as its usual segment, {} joined straight "
      "over the surface, the longest over {:.3g} mesh units.",
      gaps.count, gaps.count == 1 ? "gap" : "gaps", gaps.count == 1 ? "was" : "were", gaps.longest);
}

struct StraightLines::Workshop {
  explicit Workshop(const Surface& surface)
      : triangulation(surface), flip_out(triangulation), tracer(triangulation), dijkstra(surface) {}

  SignpostTriangulation triangulation;
  FlipOut flip_out;
  Tracer tracer;
  EdgeDijkstra dijkstra;
};

StraightLines::StraightLines(const Surface& surface) : surface_(&surface) {}
StraightLines::StraightLines(StraightLines&&) noexcept = default;
StraightLines& StraightLines::operator=(StraightLines&&) noexcept = default;
StraightLines::~StraightLines() = default;

VertexId StraightLines::nearest_corner(const SurfacePoint& point) const {
  if (const auto* v = std::get_if<AtVertex>(&point.where())) return v->vertex;
  const FaceCoordinates at = coordinates_in(*surface_, point, any_face(*surface_, point));
  std::size_t best = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (at.barycentric[k] > at.barycentric[best]) best = k;
  }
  return surface_->corners(at.face)[best];
}

void StraightLines::append_leg(const SurfacePoint& from, const SurfacePoint& to,
                               std::vector<SurfacePoint>& points, const Progress& progress) {
  points.push_back(from);
  if (const FaceId face = common_face(*surface_, from, to); face.valid()) {
    legs_.push_back(distance_in_face(*surface_, coordinates_in(*surface_, from, face),
                                     coordinates_in(*surface_, to, face)));
    return;
  }
  if (!workshop_) workshop_ = std::make_unique<Workshop>(*surface_);
  SignpostTriangulation& triangulation = workshop_->triangulation;
  try {
    append_line(from, to, points, progress);
  } catch (...) {
    while (triangulation.flip_count() > 0) triangulation.undo_flip();
    triangulation.remove_inserted();
    throw;
  }
  triangulation.remove_inserted();
}

/// Appends the points of the straight line between two points that share no face. The points that
/// this function inserts into the triangulation stay there.
void StraightLines::append_line(const SurfacePoint& from, const SurfacePoint& to,
                                std::vector<SurfacePoint>& points, const Progress& progress) {
  SignpostTriangulation& triangulation = workshop_->triangulation;
  const VertexId a = nearest_corner(from), b = nearest_corner(to);
  std::vector<VertexId> vertices = {a};
  if (a != b) {
    const std::array<VertexId, 2> ends = {a, b};
    vertices = workshop_->dijkstra.draw(ends, false, progress);
  }
  PointInsertion insertion(triangulation);
  const VertexId start = insertion.insert(from), end = insertion.insert(to);
  if (start == end) {  // both lie within rounding of one vertex, in different faces
    points.push_back(triangulation.location(start));
    return;
  }
  if (vertices.front() != start) vertices.insert(vertices.begin(), start);
  if (vertices.back() != end) vertices.push_back(end);
  std::vector<HalfedgeId> chain;
  std::size_t since = insertion.split_count();
  for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
    chain = insertion.with_splits(chain, since);
    insertion.connect(vertices[i], vertices[i + 1], chain);
    since = insertion.split_count();
  }
  const std::array<EdgePath, 1> path = {EdgePath::make(triangulation, std::move(chain), false)};
  const FlipOutResult straight = workshop_->flip_out.run(path, {}, progress);
  if (straight.paths.front().termination == Termination::kCancelled) throw Cancelled();
  legs_.push_back(straight.paths.front().length_after);
  joined_.push_back(legs_.back());
  const std::array<EdgePath, 1> result = {straight.paths.front().path};
  const TraceResult traced = workshop_->tracer.trace_and_undo(result, progress);
  const std::vector<SurfacePoint>& line = traced.curves.front().points;
  // A point within rounding of a vertex or an edge was inserted at this vertex or edge. The line
  // may then continue through a face that does not contain the point.
  const auto meets = [&](const SurfacePoint& p, const SurfacePoint& q) {
    return common_face(*surface_, p, q).valid();
  };
  if (!meets(from, line[1])) points.push_back(line.front());
  points.insert(points.end(), line.begin() + 1, line.end() - 1);
  if (!meets(points.back(), to)) points.push_back(line.back());
}

void StraightLines::find_gaps() {
  gaps_ = {};
  if (joined_.empty()) return;
  constexpr double kUnusual = 4, kOfLength = 0.25;
  std::sort(legs_.begin(), legs_.end());
  const double whole = std::accumulate(legs_.begin(), legs_.end(), 0.0);
  double usual = 0, before = 0;
  for (const double length : legs_) {
    usual = length;
    before += length;
    if (before >= kOfLength * whole) break;
  }
  for (const double length : joined_) {
    if (length > kUnusual * usual) gaps_.add({1, length});
  }
}

SurfaceCurve StraightLines::join(std::span<const SurfacePoint> points, bool closed,
                                 const Progress& progress) {
  constexpr std::size_t kOfLeg = 8;  // units of work, inside a face
  ProgressPoller poller(progress, "draw");
  legs_.clear();
  joined_.clear();
  std::vector<SurfacePoint> distinct;
  for (const SurfacePoint& p : points) {
    if (distinct.empty() || !(distinct.back() == p)) distinct.push_back(p);
  }
  if (closed && distinct.size() > 1 && distinct.front() == distinct.back()) distinct.pop_back();
  const std::size_t least = closed ? 3 : 2;
  if (distinct.size() < least) {
    throw Error(ErrorCode::kBadCurve, std::string(closed ? "A closed" : "An open") +
                                          " curve needs at least " + std::to_string(least) +
                                          " different points, but there are " +
                                          std::to_string(distinct.size()) + ".");
  }
  SurfaceCurve curve{closed, {}};
  for (std::size_t i = 0; i + 1 < distinct.size(); ++i) {
    poller.add_work(kOfLeg);
    append_leg(distinct[i], distinct[i + 1], curve.points, progress);
  }
  if (closed) {
    append_leg(distinct.back(), distinct.front(), curve.points, progress);
  } else {
    curve.points.push_back(distinct.back());
  }
  find_gaps();
  return curve;
}

SurfacePoint settled(const Surface& surface, const SurfacePoint& point) {
  constexpr double kBeside = 1e-9;
  if (const auto* on = std::get_if<OnEdge>(&point.where())) {
    const HalfedgeId h = halfedge_of(on->edge);
    if (on->t <= kBeside) return SurfacePoint::at_vertex(surface, surface.tail(h));
    if (on->t >= 1 - kBeside) return SurfacePoint::at_vertex(surface, surface.head(h));
  } else if (const auto* in = std::get_if<InFace>(&point.where())) {
    const auto& [a, b, c] = in->barycentric;
    if (a > kBeside && b > kBeside && c > kBeside) return point;
    return SurfacePoint::from_barycentric(surface, in->face, in->barycentric, kBeside);
  }
  return point;
}

}  // namespace talweg
