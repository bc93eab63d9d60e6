#include "talweg/core/drawing/snapping.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/drawing/better_fit.hpp"
#include "talweg/core/drawing/border_runs.hpp"
#include "talweg/core/drawing/control_points.hpp"
#include "talweg/core/drawing/corner_coordinates.hpp"
#include "talweg/core/drawing/sheet_matching.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/drawing/stroke_spikes.hpp"
#include "talweg/core/mesh/closest_point.hpp"
#include "talweg/core/space/message_numbers.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

/// In units of a face's longest side.
constexpr double kOnElement = 1e-9;
constexpr double kMostRounding = 1e-4;
/// Relative rounding of 32-bit floats, as a bound for all three coordinates together.
constexpr double kSinglePrecision = 1.2e-7;

/// A position farther away than both bounds belongs to another mesh. The bounds are a part of the
/// diagonal of the mesh's bounding box, and a number of mean edges (for meshes of a few faces).
constexpr double kFarthestOfSize = 0.125;
constexpr double kFarthestInEdges = 10;
/// In mean edges. A mesh that was smoothed or made coarser after the drawing stays nearer to it.
constexpr double kMovedFarInEdges = 3;
/// In mean edges. A better fit is sought only for drawings that snapping moved farther.
constexpr double kLookedAtInEdges = 0.25;
/// In mean edges. The distance by which few digits in a file may move positions.
constexpr double kRoundingInEdges = 1e-4;

double size_of(const SurfaceMesh& mesh) {
  Point low = mesh.points().front(), high = low;
  for (const Point& p : mesh.points()) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).norm();
}

[[noreturn]] void bad_curve(const std::string& what) {
  throw Error(ErrorCode::kBadCurve, what + ".");
}

std::string at_position(std::size_t k) { return "position " + std::to_string(k) + " of the curve"; }

void check_neighbours(const Surface& surface, const std::vector<VertexId>& ids, bool closed) {
  const std::size_t n = ids.size();
  for (std::size_t k = 0; k < n; ++k) {
    if (k + 1 == n && !closed) break;
    const VertexId a = ids[k];
    const VertexId b = ids[(k + 1) % n];
    if (a == b || surface.find_halfedge(a, b).valid() || surface.find_halfedge(b, a).valid())
      continue;
    bad_curve(
        fmt::format("Vertices {} and {}, at positions {} and {} of the curve, share no edge "
                    "of the mesh",
                    a.index(), b.index(), k, (k + 1) % n));
  }
}

void check_length(std::size_t n, bool closed) {
  if (closed && n < 3) {
    bad_curve("A closed curve needs at least three different points, and this one has " +
              std::to_string(n));
  }
  if (n < 2) {
    bad_curve("A curve needs at least two different points, and this one has " + std::to_string(n));
  }
}

std::vector<SurfacePoint> snap_vertices(const Surface& surface, const std::vector<VertexId>& ids,
                                        bool closed, const SnapOptions& options) {
  std::vector<SurfacePoint> points;
  for (std::size_t k = 0; k < ids.size(); ++k) {
    if (ids[k].index() >= surface.vertex_count()) {
      bad_curve("There is no vertex " + std::to_string(ids[k].index()) + " (" + at_position(k) +
                "); the mesh has " + std::to_string(surface.vertex_count()) + ", counted from 0");
    }
    points.push_back(SurfacePoint::at_vertex(surface, ids[k]));
  }
  check_length(ids.size(), closed);
  if (!options.connect) check_neighbours(surface, ids, closed);
  return points;
}

/// The point with these coordinates. On an edge, the fraction is one of the coordinates, unchanged,
/// so no bit is lost.
SurfacePoint exact_point(const Surface& surface, const FaceCoordinates& at) {
  const auto& b = at.barycentric;
  if (at.face.index() < surface.face_count() && std::count(b.begin(), b.end(), 0.0) == 1) {
    const auto zero = static_cast<std::size_t>(std::find(b.begin(), b.end(), 0.0) - b.begin());
    HalfedgeId h = surface.halfedge(at.face);
    for (std::size_t k = 0; k != (zero + 1) % 3; ++k) h = surface.next(h);
    const double tail = b[(zero + 1) % 3];
    const double head = b[(zero + 2) % 3];
    const double t = h == halfedge_of(edge_of(h)) ? head : tail;
    const double sum = tail + head;
    if (sum == 1 && t > 0 && t < 1) return SurfacePoint::on_edge(surface, edge_of(h), t);
  }
  const bool inside = std::all_of(b.begin(), b.end(), [](double x) { return x > 0 && x < 1; });
  if (inside) return SurfacePoint::in_face(surface, at.face, b);
  return SurfacePoint::from_barycentric(surface, at.face, b);
}

std::vector<SurfacePoint> snap_coordinates(const Surface& surface,
                                           const std::vector<FaceCoordinates>& coordinates) {
  std::vector<SurfacePoint> points;
  for (std::size_t k = 0; k < coordinates.size(); ++k) {
    try {
      points.push_back(exact_point(surface, coordinates[k]));
    } catch (const Error& error) {
      throw Error(error.code(), "At " + at_position(k) + ": " + error.what());
    }
  }
  return points;
}

/// Settles the ends of straight lines: clicked points, pins, and points that share no face with the
/// next or previous point.
void settle_ends_of_lines(const Surface& surface, const CurveInput& curve,
                          std::vector<SurfacePoint>& points) {
  const std::size_t n = points.size();
  std::vector<bool> ends(n, curve.control_points);
  const auto mark = [&](std::size_t k) {
    if (k < n) ends[k] = true;  // keep_marks() refuses larger indices
  };
  for (const std::size_t pin : curve.pins) mark(pin);
  for (const InputWayPoint& way : curve.way_points) mark(way.point);
  for (std::size_t k = 0; k + (curve.closed ? 0 : 1) < n; ++k) {
    const std::size_t next = (k + 1) % n;
    if (!common_face(surface, points[k], points[next]).valid()) ends[k] = ends[next] = true;
  }
  for (std::size_t k = 0; k < n; ++k) {
    if (ends[k]) points[k] = settled(surface, points[k]);
  }
}

/// The nearest point, moved to a vertex of its face within `near`, or else to an edge within
/// `near`.
SurfacePoint settled(const SurfaceMesh& mesh, const ClosestPoint::Result& found,
                     const Point& position) {
  const Surface& surface = mesh.surface();
  const auto corners = surface.corners(found.face);
  std::array<Point, 3> corner;
  for (std::size_t k = 0; k < 3; ++k) corner[k] = mesh.point(corners[k]);
  const Point at = found.barycentric[0] * corner[0] + found.barycentric[1] * corner[1] +
                   found.barycentric[2] * corner[2];
  double size = 0;
  for (std::size_t k = 0; k < 3; ++k)
    size = std::max(size, (corner[(k + 1) % 3] - corner[k]).norm());
  const double rounding =
      std::min(kSinglePrecision * position.cwiseAbs().maxCoeff(), kMostRounding * size);
  const double near = std::max(kOnElement * size, rounding);

  std::size_t vertex = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if ((at - corner[k]).norm() < (at - corner[vertex]).norm()) vertex = k;
  }
  if ((at - corner[vertex]).norm() <= near)
    return SurfacePoint::at_vertex(surface, corners[vertex]);

  double nearest = near;
  std::optional<std::array<double, 3>> on_side;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const Point side = corner[next] - corner[k];
    if (!(side.squaredNorm() > 0)) continue;
    const double t = std::clamp((at - corner[k]).dot(side) / side.squaredNorm(), 0.0, 1.0);
    const double distance = (at - corner[k] - t * side).norm();
    if (!(distance <= nearest) || (on_side && distance == nearest)) continue;
    nearest = distance;
    on_side = {0, 0, 0};
    (*on_side)[k] = 1 - t;
    (*on_side)[next] = t;
  }
  if (!on_side) return found.point;
  return SurfacePoint::from_barycentric(surface, found.face, *on_side);
}

/// The part of an error's sentence about another space, unit or place in which the positions would
/// fit; empty if there is none.
std::string which_fits(const SurfaceMesh& mesh, const ClosestPoint& closest,
                       const std::vector<Point>& positions) {
  const std::string words = better_fit(mesh, closest, positions);
  return words.empty() ? words : fmt::format("; it {}", words);
}

/// The largest distance of a position from its mesh.
double farthest_taken(const SurfaceMesh& mesh, double size) {
  return std::max(kFarthestOfSize * size, kFarthestInEdges * mesh.mean_edge_length());
}

/// The nearest point of the mesh to each position. `first` is the index in the curve of the first
/// position, for messages.
std::vector<ClosestPoint::Result> nearest_to(const SurfaceMesh& mesh, const ClosestPoint& closest,
                                             const std::vector<Point>& positions, std::size_t first,
                                             ProgressPoller& poller) {
  constexpr std::size_t kOfPoint = 64;  // units of work
  std::vector<ClosestPoint::Result> nearest;
  const double size = size_of(mesh), farthest = farthest_taken(mesh, size);
  for (std::size_t k = 0; k < positions.size(); ++k) {
    poller.add_work(kOfPoint);
    try {
      nearest.push_back(closest.nearest(positions[k]));
      if (nearest.back().distance > farthest) {
        bad_curve(fmt::format(
            "the mesh, which is {:.3g} large, lies {:.3g} away; curves may lie {:.3g} from it at "
            "most: this curve seems to be in another unit or place{}",
            size, nearest.back().distance, farthest, which_fits(mesh, closest, positions)));
      }
    } catch (const Error& error) {
      throw Error(error.code(), "At " + at_position(first + k) + ": " + error.what());
    }
  }
  return nearest;
}

void tell_matching(const SheetMatching& matching, const std::vector<Point>& positions, double edge,
                   SnappedCurve& curve) {
  if (matching.moved > 0) {
    curve.notes.push_back(fmt::format(
        "{} of {} points of a curve {} nearer to the other side of a thin wall than the rest of "
        "the curve, and {} put on the side of the rest, the first at {}.",
        matching.moved, positions.size(), matching.moved == 1 ? "is" : "are",
        matching.moved == 1 ? "was" : "were",
        position_text(positions[matching.first_moved], edge)));
  }
  if (matching.jumps > 0) {
    curve.notes.push_back(
        fmt::format("A curve jumps through space in {} {} where every way over the surface is much "
                    "longer, the first at {}.",
                    matching.jumps, matching.jumps == 1 ? "place" : "places",
                    position_text(positions[matching.first_jump], edge)));
  }
}

std::vector<SurfacePoint> snap_positions(const SurfaceMesh& mesh, const ClosestPoint& closest,
                                         const std::vector<Point>& positions, SnappedCurve& curve,
                                         ProgressPoller& poller) {
  const std::size_t before = curve.beyond_border[0].points;
  const std::size_t first = before > 0 ? before - 1 : 0;
  SheetMatching matching = matched_to_sheets(mesh, closest, positions, curve.closed,
                                             nearest_to(mesh, closest, positions, first, poller));
  tell_matching(matching, positions, mesh.mean_edge_length(), curve);
  std::vector<SurfacePoint> points;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    points.push_back(settled(mesh, matching.points[k], positions[k]));
    curve.largest_snap_distance =
        std::max(curve.largest_snap_distance, (mesh.position(points.back()) - positions[k]).norm());
  }
  if (curve.largest_snap_distance > kLookedAtInEdges * mesh.mean_edge_length()) {
    curve.better_fit = better_fit(mesh, closest, positions);
  }
  return points;
}

/// Drops points equal to the point before, and the last point of a closed curve if it equals the
/// first. Returns, for each given point, the index of the point that it became.
std::vector<std::size_t> merge_equal(const std::vector<SurfacePoint>& points, SnappedCurve& curve) {
  std::vector<std::size_t> kept(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (curve.points.empty() || !(curve.points.back() == points[k])) {
      curve.points.push_back(points[k]);
    }
    kept[k] = curve.points.size() - 1;
  }
  if (curve.closed && curve.points.size() > 1 && curve.points.back() == curve.points.front()) {
    const std::size_t last = curve.points.size() - 1;
    curve.points.pop_back();
    std::replace(kept.begin(), kept.end(), last, std::size_t{0});
  }
  curve.merged = points.size() - curve.points.size();
  return kept;
}

std::size_t kept_point(const std::vector<std::size_t>& kept, std::size_t point, const char* what) {
  if (point < kept.size()) return kept[point];
  bad_curve(fmt::format("There is no point {} that could {}; the curve has {}, counted from 0",
                        point, what, kept.size()));
}

void sort_and_merge(std::vector<std::size_t>& indices) {
  std::sort(indices.begin(), indices.end());
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
}

std::vector<InputWayPoint> kept_way_points(const std::vector<std::size_t>& kept,
                                           const std::vector<InputWayPoint>& given) {
  std::vector<InputWayPoint> all;
  for (const InputWayPoint& way : given) {
    if (!(way.tolerance >= 0 && std::isfinite(way.tolerance))) {
      bad_curve(fmt::format("The tolerance of way-point {} must be 0 or more, not {:g}", way.point,
                            way.tolerance));
    }
    all.push_back({kept_point(kept, way.point, "be a way-point"), way.tolerance});
  }
  std::sort(all.begin(), all.end(), [](const InputWayPoint& a, const InputWayPoint& b) {
    return std::pair(a.point, a.tolerance) < std::pair(b.point, b.tolerance);
  });
  const auto same = [](const InputWayPoint& a, const InputWayPoint& b) {
    return a.point == b.point;
  };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  return all;
}

/// Transfers the marks of the given points, pins too, to the points that merge_equal() kept.
void keep_marks(const CurveInput& input, const std::vector<std::size_t>& kept,
                SnappedCurve& curve) {
  for (const std::size_t pin : input.pins) curve.pins.push_back(kept_point(kept, pin, "be pinned"));
  sort_and_merge(curve.pins);
  curve.way_points = kept_way_points(kept, input.way_points);
  for (const std::size_t k : input.painted) {
    curve.painted.push_back(kept_point(kept, k, "be painted"));
  }
  sort_and_merge(curve.painted);
  std::erase_if(curve.painted, [&](std::size_t k) {
    return std::any_of(curve.way_points.begin(), curve.way_points.end(),
                       [&](const InputWayPoint& way) { return way.point == k; });
  });
}

/// Makes all control points way-points, unless they are too many or too dense to be clicks.
void take_control_points(const SurfaceMesh& mesh, SnappedCurve& curve) {
  curve.why_stroke = why_no_clicks(mesh, curve.points, curve.closed);
  if (!curve.why_stroke.empty()) return;
  for (std::size_t k = 0; k < curve.points.size(); ++k) curve.way_points.push_back({k, 0});
}

bool has_positions(const CurveInput& curve) {
  return std::holds_alternative<std::vector<Point>>(curve.points);
}

/// The curve without spikes if it is a stroke of positions with spikes; adds a sentence on them.
/// `edge` is the mean edge length of the mesh.
std::optional<CurveInput> without_spikes(const CurveInput& curve, double edge,
                                         std::vector<std::string>& notes) {
  const auto* samples = std::get_if<std::vector<Point>>(&curve.points);
  const bool is_stroke = samples != nullptr && !curve.control_points && curve.pins.empty() &&
                         curve.way_points.empty() && curve.painted.empty();
  if (!is_stroke) return std::nullopt;
  const std::vector<std::size_t> spikes = spikes_of(*samples, curve.closed);
  if (spikes.empty()) return std::nullopt;
  std::vector<Point> kept;
  for (std::size_t k = 0; k < samples->size(); ++k) {
    if (!std::binary_search(spikes.begin(), spikes.end(), k)) kept.push_back((*samples)[k]);
  }
  notes.push_back(fmt::format(
      "{} of {} points of a curve {} far from the points before and after, as when a tracker is "
      "disturbed, and {} left out, the first at {}.",
      spikes.size(), samples->size(), spikes.size() == 1 ? "lies" : "lie",
      spikes.size() == 1 ? "was" : "were", position_text((*samples)[spikes.front()], edge)));
  CurveInput rest = curve;
  rest.points = std::move(kept);
  return rest;
}

/// Whether a stroke is cut where it runs over the border. A stroke that lies mostly beyond the
/// border is cut only if it is near: otherwise it belongs to another place.
bool runs_over(const SurfaceMesh& mesh, const std::array<BorderRun, 2>& runs, std::size_t samples) {
  const auto& [start, end] = runs;
  if (start.samples + end.samples == 0) return false;
  if (2 * (start.samples + end.samples) <= samples) return true;
  return std::max(start.farthest, end.farthest) <= farthest_taken(mesh, size_of(mesh));
}

/// The part of a stroke of positions on the mesh; none if the whole stroke is on the mesh, or
/// almost nothing of it. The place where the stroke crosses the border replaces all samples beyond
/// it.
std::optional<CurveInput> within_border(const SurfaceMesh& mesh, const ClosestPoint& closest,
                                        const CurveInput& curve, SnappedCurve& result) {
  const auto* samples = std::get_if<std::vector<Point>>(&curve.points);
  const bool is_stroke = samples != nullptr && !curve.closed && !curve.control_points &&
                         curve.pins.empty() && curve.way_points.empty();
  if (!is_stroke) return std::nullopt;
  const std::size_t n = samples->size();
  std::array<BorderRun, 2> runs;
  try {
    runs = border_runs(mesh, closest, *samples);
  } catch (const Error&) {
    return std::nullopt;  // nearest_to() will throw an error that names the position
  }
  if (!runs_over(mesh, runs, n)) return std::nullopt;
  const auto& [start, end] = runs;
  const std::size_t first = start.samples > 0 ? start.samples - 1 : 0;
  const std::size_t last = end.samples > 0 ? n - end.samples : n - 1;
  std::vector<Point> left(samples->begin() + static_cast<std::ptrdiff_t>(first),
                          samples->begin() + static_cast<std::ptrdiff_t>(last) + 1);
  if (start.samples > 0) left.front() = start.leaves;
  if (end.samples > 0) left.back() = end.leaves;
  const bool has_length = std::any_of(left.begin(), left.end(), [&](const Point& p) {
    return (p - left.front()).norm() > kRoundingInEdges * mesh.mean_edge_length();
  });
  if (!has_length) return std::nullopt;
  for (std::size_t k = 0; k < 2; ++k) result.beyond_border[k] = {runs[k].samples, runs[k].farthest};
  CurveInput rest = curve;
  rest.points = std::move(left);
  std::erase_if(rest.painted, [&](std::size_t k) { return k < first || (k > last && k < n); });
  for (std::size_t& k : rest.painted) k -= k < n ? first : 0;
  return rest;
}

SnappedCurve snap_one(const SurfaceMesh& mesh, const ClosestPoint* closest, const CurveInput& given,
                      const SnapOptions& options, ProgressPoller& poller) {
  SnappedCurve result;
  result.notes = given.notes;
  const std::optional<CurveInput> rest =
      without_spikes(given, mesh.mean_edge_length(), result.notes);
  std::optional<CurveInput> within;
  if (closest != nullptr) within = within_border(mesh, *closest, rest ? *rest : given, result);
  const CurveInput& curve = within ? *within : rest ? *rest : given;
  result.closed = curve.closed;
  std::vector<SurfacePoint> points;
  if (const auto* ids = std::get_if<std::vector<VertexId>>(&curve.points)) {
    points = snap_vertices(mesh.surface(), *ids, curve.closed, options);
  } else if (const auto* at = std::get_if<std::vector<FaceCoordinates>>(&curve.points)) {
    points = snap_coordinates(mesh.surface(), *at);
    settle_ends_of_lines(mesh.surface(), curve, points);
  } else if (const auto* between = std::get_if<std::vector<CornerCoordinates>>(&curve.points)) {
    points = snap_coordinates(mesh.surface(), in_faces(mesh.surface(), *between));
    settle_ends_of_lines(mesh.surface(), curve, points);
  } else {
    points =
        snap_positions(mesh, *closest, std::get<std::vector<Point>>(curve.points), result, poller);
  }
  const std::vector<std::size_t> kept = merge_equal(points, result);
  check_length(result.points.size(), result.closed);
  keep_marks(curve, kept, result);
  if (curve.control_points && curve.way_points.empty()) take_control_points(mesh, result);
  const bool is_of_hand = has_positions(curve) || !curve.painted.empty();
  result.of_hand =
      is_of_hand && !curve.closed && !curve.control_points && result.way_points.empty();
  result.may_be_loop = result.of_hand && !within;
  return result;
}

}  // namespace

SnappedCurve snap(const SurfaceMesh& mesh, const CurveInput& curve, const SnapOptions& options,
                  const Progress& progress) {
  ProgressPoller poller(progress, "snap");
  std::optional<ClosestPoint> closest;
  if (has_positions(curve)) closest.emplace(mesh);
  return snap_one(mesh, closest ? &*closest : nullptr, curve, options, poller);
}

std::vector<SnappedCurve> snap(const SurfaceMesh& mesh, std::span<const CurveInput> curves,
                               const SnapOptions& options, const Progress& progress) {
  std::optional<ClosestPoint> closest;
  return snap(mesh, curves, closest, options, progress);
}

std::vector<SnappedCurve> snap(const SurfaceMesh& mesh, std::span<const CurveInput> curves,
                               std::optional<ClosestPoint>& closest, const SnapOptions& options,
                               const Progress& progress) {
  ProgressPoller poller(progress, "snap");
  if (!closest && std::any_of(curves.begin(), curves.end(), has_positions)) closest.emplace(mesh);
  std::vector<SnappedCurve> result;
  for (const CurveInput& curve : curves) {
    poller.set_fraction(static_cast<double>(result.size()) / static_cast<double>(curves.size()));
    try {
      result.push_back(snap_one(mesh, closest ? &*closest : nullptr, curve, options, poller));
    } catch (const Error& error) {
      if (curves.size() == 1) throw;
      throw Error(error.code(), "Curve " + std::to_string(result.size()) + ": " + error.what());
    }
  }
  return result;
}

bool moved_far(double largest_snap_distance, const SurfaceMesh& mesh) {
  return largest_snap_distance > kMovedFarInEdges * mesh.mean_edge_length();
}

std::string snap_warning(double largest_snap_distance, const SurfaceMesh& mesh) {
  if (!(largest_snap_distance > kRoundingInEdges * mesh.mean_edge_length())) return "";
  if (!moved_far(largest_snap_distance, mesh)) {
    return "The curve was moved onto the mesh, by up to " + mesh_units_text(largest_snap_distance) +
           ".";
  }
  return fmt::format(
      "{}: it was moved onto the mesh, by up to {}, {:.1f} mean edges. Does the "
      "curve belong to this mesh, and is it in the mesh's unit?",
      kFarFromMesh, mesh_units_text(largest_snap_distance),
      largest_snap_distance / mesh.mean_edge_length());
}

}  // namespace talweg
