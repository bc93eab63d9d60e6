#include "talweg/core/surface_deviation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "talweg/core/segment_tree.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/polyline_pieces.hpp"

namespace talweg {
namespace {

constexpr double kTolerance = 1e-3;
constexpr int kMaxHalvings = 40;
constexpr int kMeanHalvings = 10;

using Barycentric = std::array<double, 3>;

double distance_of(PlanePoint p, PlanePoint q) { return std::hypot(q.x - p.x, q.y - p.y); }

double to_segment(PlanePoint x, PlanePoint p, PlanePoint q) {
  const double dx = q.x - p.x, dy = q.y - p.y, squared = dx * dx + dy * dy;
  const double t = squared > 0 ? ((x.x - p.x) * dx + (x.y - p.y) * dy) / squared : 0;
  const double clamped = std::clamp(t, 0.0, 1.0);
  return distance_of(x, {p.x + clamped * dx, p.y + clamped * dy});
}

/// A curve's segment in a face that contains it.
struct Stretch {
  FaceId face;
  Barycentric from{}, to{};
  double length = 0;

  [[nodiscard]] Barycentric at(double t) const {
    Barycentric b{};
    for (std::size_t k = 0; k < 3; ++k) b[k] = (1 - t) * from[k] + t * to[k];
    return b;
  }
  [[nodiscard]] SurfacePoint point(const Surface& surface, double t) const {
    return SurfacePoint::from_barycentric(surface, face, at(t));
  }
};

Stretch stretch_between(const Surface& surface, const SurfacePoint& p, const SurfacePoint& q,
                        FaceId face) {
  const FaceCoordinates a = coordinates_in(surface, p, face), b = coordinates_in(surface, q, face);
  return {face, a.barycentric, b.barycentric, distance_in_face(surface, a, b)};
}

/// The segments of all curves, those without length left out.
std::vector<Stretch> stretches_of(const Surface& surface, std::span<const SurfaceCurve> curves) {
  std::vector<Stretch> stretches;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const auto& points = curves[c].points;
    for (std::size_t i = 0; i + (curves[c].closed ? 0 : 1) < points.size(); ++i) {
      const SurfacePoint &p = points[i], &q = points[(i + 1) % points.size()];
      if (p == q) continue;
      const FaceId face = common_face(surface, p, q);
      if (!face.valid()) {
        throw Error(ErrorCode::kBadCurve, "Point " + std::to_string(i) + " of curve " +
                                              std::to_string(c) + " and the next share no face.");
      }
      stretches.push_back(stretch_between(surface, p, q, face));
    }
  }
  return stretches;
}

/// A place on a stretch and the distance there.
struct Sample {
  double t = 0;
  double distance = 0;
};

/// What the distance between two samples is at most, beyond what its slope of 1 says. Every bound
/// is a convex function along the stretch, so its values at the two samples bound it between them.
class FaceBounds {
 public:
  FaceBounds(const Surface& surface, PolylineDistance& to, const PolylinePieces& pieces)
      : surface_(&surface), to_(&to), pieces_(&pieces) {}

  /// By way of the pieces of the other curves in the same face.
  [[nodiscard]] double by_pieces(const Stretch& s, const Sample& a, const Sample& b) const {
    const SideFrame frame = side_frame(*surface_, s.face, 0);
    const PlanePoint p = frame.at(s.at(a.t), 0), q = frame.at(s.at(b.t), 0);
    double best = std::numeric_limits<double>::infinity();
    for (const PolylinePiece& piece : pieces_->segments_in(s.face)) {
      const PlanePoint from = frame.at(piece.from, 0), to = frame.at(piece.to, 0);
      best = std::min(best, std::max(to_segment(p, from, to), to_segment(q, from, to)));
    }
    return best;
  }

  /// By way of a point on a side of the face, one on each side of the stretch, where the shortest
  /// way is likely to come from: it meets the stretch at an angle that the slope tells.
  double by_sides(const Stretch& s, const Sample& a, const Sample& b) {
    double best = by_sides_in(s, a, b);
    for (std::size_t k = 0; k < 3; ++k) {
      if (s.from[k] == 0 && s.to[k] == 0) best = std::min(best, by_other_face(s, k, a, b));
    }
    return best;
  }

 private:
  /// The stretch runs along the side opposite to corner k, which has another face.
  double by_other_face(const Stretch& s, std::size_t k, const Sample& a, const Sample& b) {
    const HalfedgeId side = side_frame(*surface_, s.face, (k + 1) % 3).side;
    if (!surface_->has_face(twin(side))) return std::numeric_limits<double>::infinity();
    const FaceId face = surface_->face(twin(side));
    return by_sides_in(
        stretch_between(*surface_, s.point(*surface_, 0), s.point(*surface_, 1), face), a, b);
  }

  double by_sides_in(const Stretch& s, const Sample& a, const Sample& b) {
    const SideFrame frame = side_frame(*surface_, s.face, 0);
    double best = std::numeric_limits<double>::infinity();
    if (!(frame.length > 0 && frame.apex.y > 0)) return best;
    const PlanePoint p = frame.at(s.at(a.t), 0), q = frame.at(s.at(b.t), 0);
    const double length = distance_of(p, q);
    if (!(length > 0)) return best;
    const double slope = std::clamp((b.distance - a.distance) / length, -1.0, 1.0);
    const double across = std::sqrt(1 - slope * slope);
    const double ex = (q.x - p.x) / length, ey = (q.y - p.y) / length;
    for (const double side : {-across, across}) {
      const PlanePoint back{-slope * ex - side * ey, -slope * ey + side * ex};
      Barycentric c = s.at((a.t + b.t) / 2);
      // A point that is near compared with the interval tells no more than its ends do.
      if (!(walk_to_side(frame, back, c) > length / 4)) continue;
      const PlanePoint corner = frame.at(c, 0);
      const double distance =
          to_->at(SurfacePoint::from_barycentric(*surface_, s.face, c)).distance;
      best = std::min(best, distance + std::max(distance_of(p, corner), distance_of(q, corner)));
    }
    return best;
  }

  /// Moves c in a direction as far as the face goes; returns how far that is.
  static double walk_to_side(const SideFrame& frame, PlanePoint direction, Barycentric& c) {
    const double up = direction.y / frame.apex.y;
    const double along = (direction.x - up * frame.apex.x) / frame.length;
    const Barycentric change{-along - up, along, up};
    double way = std::numeric_limits<double>::infinity();
    std::size_t reached = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(change[k] < 0) || c[k] / -change[k] >= way) continue;
      way = c[k] / -change[k];
      reached = k;
    }
    if (!std::isfinite(way)) return 0;
    for (std::size_t k = 0; k < 3; ++k) c[k] = std::max(0.0, c[k] + way * change[k]);
    c[reached] = 0;
    const double sum = c[0] + c[1] + c[2];
    for (double& x : c) x /= sum;
    return way;
  }

  const Surface* surface_;
  PolylineDistance* to_;
  const PolylinePieces* pieces_;
};

class Measurement {
 public:
  Measurement(const Surface& surface, PolylineDistance& to, const PolylinePieces& pieces,
              double tolerance)
      : surface_(&surface), to_(&to), bounds_(surface, to, pieces), tolerance_(tolerance) {}

  /// What is added comes in parts; between them `to` and `pieces` may be set to others.

  void add(std::span<const Stretch> stretches) {
    struct Sampled {
      Sample a, middle, b;
    };
    std::vector<Sampled> sampled;
    double length = 0, integral = 0;
    for (const Stretch& s : stretches) {
      const Sample a = sample(s, 0), middle = sample(s, 0.5), b = sample(s, 1);
      sampled.push_back({a, middle, b});
      length += s.length;
      integral += s.length * simpson(a, middle, b);
    }
    if (!std::isfinite(max_)) return;
    const double missed = std::max(tolerance_, kTolerance * integral / length);
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      const Sampled& s = sampled[i];
      integral_ += stretches[i].length * mean(stretches[i], s.a, s.middle, s.b, missed);
    }
    length_ += length;
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      search(stretches[i], sampled[i].a, sampled[i].middle);
      search(stretches[i], sampled[i].middle, sampled[i].b);
    }
  }

  [[nodiscard]] OneSidedSurfaceDeviation result() const {
    const bool is_mean = std::isfinite(max_) && length_ > 0;
    return {max_, is_mean ? integral_ / length_ : max_, *at_};
  }
  [[nodiscard]] bool is_finite() const { return std::isfinite(max_); }

  /// The distance at a single point, which counts as a sample.
  double see(const SurfacePoint& point) {
    const double distance = to_->at(point).distance;
    if (!at_ || distance > max_) {
      max_ = distance;
      at_ = point;
    }
    return distance;
  }

 private:
  Sample sample(const Stretch& s, double t) { return {t, see(s.point(*surface_, t))}; }

  static double simpson(const Sample& a, const Sample& middle, const Sample& b) {
    return (a.distance + 4 * middle.distance + b.distance) / 6;
  }

  /// The mean between a and b; compared with the trapezoids, which miss kinks as much.
  double mean(const Stretch& s, const Sample& a, const Sample& middle, const Sample& b,
              double missed, int halvings = 0) {
    const double bend = std::abs(a.distance - 2 * middle.distance + b.distance) / 12;
    if (bend <= missed || halvings >= kMeanHalvings) return simpson(a, middle, b);
    const Sample first = sample(s, (a.t + middle.t) / 2), second = sample(s, (middle.t + b.t) / 2);
    return (mean(s, a, first, middle, missed, halvings + 1) +
            mean(s, middle, second, b, missed, halvings + 1)) /
           2;
  }

  /// Looks between two samples for what is larger than all that was seen.
  void search(const Stretch& s, const Sample& a, const Sample& b, int halvings = 0) {
    const double enough = max_ + std::max(tolerance_, kTolerance * max_);
    const double length = (b.t - a.t) * s.length;
    const double middle_value = (a.distance + b.distance) / 2;
    if (halvings > kMaxHalvings || middle_value + length / 2 <= enough) return;
    if (bounds_.by_pieces(s, a, b) <= enough) return;
    // Costs two distances, so only where halving would go on for long.
    if (middle_value + length / 8 > enough && bounds_.by_sides(s, a, b) <= enough) return;
    const Sample middle = sample(s, (a.t + b.t) / 2);
    search(s, a, middle, halvings + 1);
    search(s, middle, b, halvings + 1);
  }

  const Surface* surface_;
  PolylineDistance* to_;
  FaceBounds bounds_;
  double tolerance_;
  double length_ = 0, integral_ = 0;
  double max_ = 0;
  std::optional<SurfacePoint> at_;
};

void refuse_nothing(std::span<const SurfaceCurve> curves) {
  if (curves.empty()) throw Error(ErrorCode::kBadCurve, "There is no curve to measure.");
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (curves[c].points.empty()) {
      throw Error(ErrorCode::kBadCurve, "Curve " + std::to_string(c) + " has no points.");
    }
  }
}

/// A thousandth of the mean segment of all the curves.
double tolerance_for(std::span<const Stretch> stretches, std::span<const SurfaceCurve> others,
                     const std::vector<double>& other_lengths) {
  double length = 0;
  std::size_t segments = stretches.size();
  for (const Stretch& s : stretches) length += s.length;
  for (std::size_t c = 0; c < others.size(); ++c) {
    length += other_lengths[c];
    segments += others[c].points.size() - (others[c].closed ? 0 : 1);
  }
  return segments > 0 ? kTolerance * length / static_cast<double>(segments) : 0;
}

using SpaceBox = Eigen::AlignedBox3d;

/// Some curves, of which only what lies near in space is wanted. Ways along the surface are not
/// shorter than through space, so the rest cannot be nearest.
class NearParts {
 public:
  NearParts(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves) : curves_(curves) {
    std::vector<Segment> segments;
    for (const SurfaceCurve& curve : curves) {
      const auto own = segments_of(positions_of(mesh, curve), curve.closed);
      counts_.push_back(own.size());
      segments.insert(segments.end(), own.begin(), own.end());
    }
    for (const Segment& s : segments) boxes_.push_back(SpaceBox(s.a).extend(s.b));
    tree_.emplace(std::move(segments));
  }

  [[nodiscard]] double distance(const Point& p) const { return tree_->nearest(p).distance; }

  /// The segments whose boxes meet one of these, as curves.
  [[nodiscard]] std::vector<SurfaceCurve> meeting(std::span<const SpaceBox> boxes) const {
    SpaceBox all;
    for (const SpaceBox& box : boxes) all.extend(box);
    std::vector<SurfaceCurve> parts;
    std::size_t first = 0;
    for (std::size_t c = 0; c < curves_.size(); first += counts_[c++]) {
      const auto& points = curves_[c].points;
      bool joined = false;
      for (std::size_t i = 0; i < counts_[c]; ++i) {
        const SpaceBox& box = boxes_[first + i];
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
  std::vector<std::size_t> counts_;  // of segments
  std::vector<SpaceBox> boxes_;
  std::optional<SegmentTree> tree_;
};

/// Sets a distance to what of the curves can be nearest to some stretches.
class LocalDistance {
 public:
  LocalDistance(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                PolylineDistance& distance)
      : mesh_(&mesh), curves_(curves), parts_(mesh, curves), distance_(&distance) {}

  /// What the distance on a stretch is at most, by those in space: a guess, to be proved.
  [[nodiscard]] double guess(const Stretch& s) const {
    return kMore *
           bound(s, [&](const SurfacePoint& p) { return parts_.distance(mesh_->position(p)); });
  }

  /// `reach` has the guesses. Returns what it is set to.
  std::vector<SurfaceCurve> set_near(std::span<const Stretch> stretches, std::span<double> reach) {
    std::vector<SurfaceCurve> near = set(stretches, reach);
    bool proved = true;
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      const double most =
          bound(stretches[i], [&](const SurfacePoint& p) { return distance_->at(p).distance; });
      proved = proved && most <= reach[i];
      reach[i] = std::max(reach[i], most);
    }
    return proved ? near : set(stretches, reach);
  }

 private:
  static constexpr double kMore = 1.05;

  template <class Distance>
  [[nodiscard]] double bound(const Stretch& s, Distance distance) const {
    const Surface& surface = mesh_->surface();
    return (distance(s.point(surface, 0)) + distance(s.point(surface, 1)) + s.length) / 2;
  }

  std::vector<SurfaceCurve> set(std::span<const Stretch> stretches, std::span<const double> reach) {
    std::vector<SpaceBox> boxes;
    bool everything = false;
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      everything = everything || !std::isfinite(reach[i]);
      const Surface& surface = mesh_->surface();
      SpaceBox box(mesh_->position(stretches[i].point(surface, 0)));
      box.extend(mesh_->position(stretches[i].point(surface, 1)));
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
};

/// Parts are long compared with their distances, so that little is marched twice.
std::size_t end_of_part(std::span<const Stretch> stretches, std::span<const double> reach,
                        std::size_t begin) {
  constexpr double kLong = 4;
  double length = 0, farthest = 0;
  std::size_t end = begin;
  while (end < stretches.size() && (end < begin + 8 || length < kLong * farthest)) {
    length += stretches[end].length;
    farthest = std::max(farthest, reach[end]);
    ++end;
  }
  return end;
}

/// Part by part, each with the distance to what of the others is near it, so that one far corner
/// does not cost a wide band along all of the curves.
OneSidedSurfaceDeviation deviation_by_parts(const SurfaceMesh& mesh,
                                            std::span<const SurfaceCurve> from,
                                            std::span<const SurfaceCurve> others,
                                            PolylineDistance& distance) {
  const Surface& surface = mesh.surface();
  const std::vector<Stretch> stretches = stretches_of(surface, from);
  PolylinePieces pieces = pieces_of(surface, others);
  const bool has_point = std::any_of(
      from.begin(), from.end(), [](const SurfaceCurve& curve) { return curve.points.size() == 1; });
  if (stretches.empty() || has_point) {
    distance.set(others);
    return one_sided_deviation(surface, from, distance, others);
  }
  Measurement measurement(surface, distance, pieces,
                          tolerance_for(stretches, others, pieces.lengths));
  LocalDistance local(mesh, others, distance);
  std::vector<double> reach;
  for (const Stretch& stretch : stretches) reach.push_back(local.guess(stretch));
  for (std::size_t i = 0, end = 0; i < stretches.size() && measurement.is_finite(); i = end) {
    end = end_of_part(stretches, reach, i);
    const auto part = std::span(stretches).subspan(i, end - i);
    pieces = pieces_of(surface, local.set_near(part, std::span(reach).subspan(i, end - i)));
    measurement.add(part);
  }
  return measurement.result();
}

}  // namespace

OneSidedSurfaceDeviation one_sided_deviation(const Surface& surface,
                                             std::span<const SurfaceCurve> from,
                                             PolylineDistance& to,
                                             std::span<const SurfaceCurve> to_curves) {
  refuse_nothing(from);
  refuse_nothing(to_curves);
  const std::vector<Stretch> stretches = stretches_of(surface, from);
  const PolylinePieces pieces = pieces_of(surface, to_curves);
  Measurement measurement(surface, to, pieces, tolerance_for(stretches, to_curves, pieces.lengths));
  for (const SurfaceCurve& curve : from) measurement.see(curve.points.front());
  measurement.add(stretches);
  return measurement.result();
}

SurfaceDeviation DeviationMeter::measure(std::span<const SurfaceCurve> result,
                                         std::span<const SurfaceCurve> drawn) {
  refuse_nothing(result);
  refuse_nothing(drawn);
  if (!distance_) distance_.emplace(mesh_->surface());
  return {deviation_by_parts(*mesh_, result, drawn, *distance_),
          deviation_by_parts(*mesh_, drawn, result, *distance_)};
}

SurfaceDeviation DeviationMeter::measure(std::span<const SurfaceCurve> result,
                                         std::span<const SurfaceCurve> drawn,
                                         PolylineDistance& to_drawn) {
  refuse_nothing(result);
  refuse_nothing(drawn);
  if (!distance_) distance_.emplace(mesh_->surface());
  return {one_sided_deviation(mesh_->surface(), result, to_drawn, drawn),
          deviation_by_parts(*mesh_, drawn, result, *distance_)};
}

}  // namespace talweg
