#include "talweg/core/drawing/straight_lines.hpp"

#include <algorithm>
#include <numeric>
#include <string>

#include <fmt/format.h>

#include "talweg/core/drawing/cone_detour.hpp"
#include "talweg/core/drawing/edge_dijkstra.hpp"
#include "talweg/core/space/message_numbers.hpp"
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
      "over the surface, the longest over {}.",
      gaps.count, gaps.count == 1 ? "gap" : "gaps", gaps.count == 1 ? "was" : "were",
      mesh_units_text(gaps.longest));
}

namespace {

/// Appends the corners of a face at which edge paths to a point of the face may end.
void append_corners(const Surface& surface, const SurfacePoint& point, FaceId face,
                    std::vector<PathEnd>& ends) {
  const FaceCoordinates at = coordinates_in(surface, point, face);
  for (std::size_t k = 0; k < 3; ++k) {
    FaceCoordinates corner{face, {0, 0, 0}};
    corner.barycentric[k] = 1;
    ends.push_back({surface.corners(face)[k], distance_in_face(surface, at, corner)});
  }
}

/// The vertices at which edge paths to a point may end: the vertex at which the point lies, or the
/// corners of its faces.
std::vector<PathEnd> corners_around(const Surface& surface, const SurfacePoint& point) {
  if (const auto* v = std::get_if<AtVertex>(&point.where())) return {{v->vertex}};
  std::vector<PathEnd> ends;
  if (const auto* on = std::get_if<OnEdge>(&point.where())) {
    const HalfedgeId h = halfedge_of(on->edge);
    for (const HalfedgeId side : {h, twin(h)}) {
      if (surface.has_face(side)) append_corners(surface, point, surface.face(side), ends);
    }
  } else {
    append_corners(surface, point, any_face(surface, point), ends);
  }
  return ends;
}

}  // namespace

struct StraightLines::Workshop {
  struct Line {
    std::vector<SurfacePoint> points;  ///< one if both ends lie at the same vertex
    double length = 0;                 ///< mesh units
  };

  explicit Workshop(const Surface& lines_on)
      : surface(lines_on),
        triangulation(lines_on),
        flip_out(triangulation),
        tracer(triangulation),
        dijkstra(lines_on) {}

  /// A straight line near the edge path `between` two points, led to the other side of vertices
  /// where that is shorter.
  Line shortest_line(const SurfacePoint& from, const SurfacePoint& to,
                     std::span<const VertexId> between, const Progress& progress);
  /// The straight line in the isotopy class of an edge path `between` both points. If `pinned` is
  /// valid, the path is straightened on both sides of this vertex first. Leaves the triangulation
  /// as it was.
  Line straightened(const SurfacePoint& from, const SurfacePoint& to,
                    std::span<const VertexId> between, VertexId pinned, const Progress& progress);
  /// The same, but inserted points and, after an exception, flips stay.
  Line inserted_line(const SurfacePoint& from, const SurfacePoint& to,
                     std::span<const VertexId> between, VertexId pinned, const Progress& progress);
  /// The edge path through the vertices.
  EdgePath connected(PointInsertion& insertion, std::span<const VertexId> vertices);
  FlipOutResult::Path flipped(const EdgePath& path, const FlipOutOptions& options,
                              const Progress& progress);

  const Surface& surface;
  SignpostTriangulation triangulation;
  FlipOut flip_out;
  Tracer tracer;
  EdgeDijkstra dijkstra;
};

EdgePath StraightLines::Workshop::connected(PointInsertion& insertion,
                                            std::span<const VertexId> vertices) {
  std::vector<HalfedgeId> chain;
  std::size_t since = insertion.split_count();
  for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
    chain = insertion.with_splits(chain, since);
    insertion.connect(vertices[i], vertices[i + 1], chain);
    since = insertion.split_count();
  }
  return EdgePath::make(triangulation, std::move(chain), false);
}

FlipOutResult::Path StraightLines::Workshop::flipped(const EdgePath& path,
                                                     const FlipOutOptions& options,
                                                     const Progress& progress) {
  FlipOutResult straight = flip_out.run(std::span(&path, 1), options, progress);
  if (straight.paths.front().termination == Termination::kCancelled) throw Cancelled();
  return std::move(straight.paths.front());
}

StraightLines::Workshop::Line StraightLines::Workshop::inserted_line(
    const SurfacePoint& from, const SurfacePoint& to, std::span<const VertexId> between,
    VertexId pinned, const Progress& progress) {
  PointInsertion insertion(triangulation);
  const VertexId start = insertion.insert(from), end = insertion.insert(to);
  if (start == end) return {{triangulation.location(start)}, 0};
  std::vector<VertexId> vertices(between.begin(), between.end());
  if (vertices.empty() || vertices.front() != start) vertices.insert(vertices.begin(), start);
  if (vertices.back() != end) vertices.push_back(end);
  EdgePath path = connected(insertion, vertices);
  if (pinned.valid()) {
    FlipOutOptions around;
    around.pinned = {pinned};
    path = flipped(path, around, progress).path;
  }
  const FlipOutResult::Path straight = flipped(path, {}, progress);
  TraceResult traced = tracer.trace_and_undo(std::span(&straight.path, 1), progress);
  return {std::move(traced.curves.front().points), straight.length_after};
}

StraightLines::Workshop::Line StraightLines::Workshop::straightened(
    const SurfacePoint& from, const SurfacePoint& to, std::span<const VertexId> between,
    VertexId pinned, const Progress& progress) {
  const auto restore = [this] {
    while (triangulation.flip_count() > 0) triangulation.undo_flip();
    triangulation.remove_inserted();
  };
  try {
    Line line = inserted_line(from, to, between, pinned, progress);
    restore();
    return line;
  } catch (...) {
    restore();
    throw;
  }
}

StraightLines::Workshop::Line StraightLines::Workshop::shortest_line(
    const SurfacePoint& from, const SurfacePoint& to, std::span<const VertexId> between,
    const Progress& progress) {
  constexpr int kMostDetours = 16;
  constexpr double kShorter = 1 - 1e-9;
  Line line = straightened(from, to, between, {}, progress);
  for (int k = 0; k < kMostDetours && line.points.size() > 2; ++k) {
    const auto detour = cone_detour(triangulation, surface, line.points);
    if (!detour) break;
    Line other = straightened(from, to, detour->chain, detour->over, progress);
    if (!(other.length < kShorter * line.length)) break;
    line = std::move(other);
  }
  return line;
}

StraightLines::StraightLines(const Surface& surface) : surface_(&surface) {}
StraightLines::StraightLines(StraightLines&&) noexcept = default;
StraightLines& StraightLines::operator=(StraightLines&&) noexcept = default;
StraightLines::~StraightLines() = default;

void StraightLines::append_leg(const SurfacePoint& from, const SurfacePoint& to,
                               std::vector<SurfacePoint>& points, const Progress& progress) {
  points.push_back(from);
  if (const FaceId face = common_face(*surface_, from, to); face.valid()) {
    legs_.push_back(distance_in_face(*surface_, coordinates_in(*surface_, from, face),
                                     coordinates_in(*surface_, to, face)));
    return;
  }
  if (!workshop_) workshop_ = std::make_unique<Workshop>(*surface_);
  append_line(from, to, points, progress);
}

/// Appends the points of the straight line between two points that share no face.
void StraightLines::append_line(const SurfacePoint& from, const SurfacePoint& to,
                                std::vector<SurfacePoint>& points, const Progress& progress) {
  const std::vector<VertexId> between = workshop_->dijkstra.between(
      corners_around(*surface_, from), corners_around(*surface_, to), progress);
  const Workshop::Line line = workshop_->shortest_line(from, to, between, progress);
  if (line.points.size() < 2) {  // both lie within rounding of one vertex, in different faces
    points.insert(points.end(), line.points.begin(), line.points.end());
    return;
  }
  legs_.push_back(line.length);
  joined_.push_back(line.length);
  // A point within rounding of a vertex or an edge was inserted at this vertex or edge. The line
  // may then continue through a face that does not contain the point.
  const auto meets = [&](const SurfacePoint& p, const SurfacePoint& q) {
    return common_face(*surface_, p, q).valid();
  };
  if (!meets(from, line.points[1])) points.push_back(line.points.front());
  points.insert(points.end(), line.points.begin() + 1, line.points.end() - 1);
  if (!meets(points.back(), to)) points.push_back(line.points.back());
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
