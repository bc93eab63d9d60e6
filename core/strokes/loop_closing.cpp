#include "talweg/core/strokes/loop_closing.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "talweg/core/measure/edge_length_near.hpp"
#include "talweg/core/strokes/stroke_slack.hpp"
#include "talweg/core/strokes/turning_points.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

constexpr double kGapOfSlack = 2, kGapOfEdge = 1, kGapOfSamples = 1.5;
constexpr double kGapOfLength = 1.0 / 12, kEndOfLength = 1.0 / 6;
constexpr double kSameWay = 0.25;     // cosine of the largest turn at the join
constexpr double kGapCounts = 4;      // cost of a gap, per cost of the same length cut off
constexpr std::size_t kPlaces = 200;  // about the most places to try near either end

/// The unit direction of the stretch before or after a place, up to a point `reach` away.
Point direction(std::span<const Point> at, std::size_t place, bool before, double reach) {
  std::size_t other = place;
  while (before ? other > 0 : other + 1 < at.size()) {
    other = before ? other - 1 : other + 1;
    if ((at[other] - at[place]).norm() >= reach) break;
  }
  const Point way = before ? Point(at[place] - at[other]) : Point(at[other] - at[place]);
  return way.normalized();
}

/// Whether a loop that is joined from place `end` to place `start` keeps about its direction.
bool goes_on(std::span<const Point> at, std::size_t start, std::size_t end, double reach) {
  const Point in = direction(at, end, true, reach), out = direction(at, start, false, reach);
  if (in.dot(out) < kSameWay) return false;
  return (at[start] - at[end]).dot(in) > -kSameWay * reach;
}

/// The ends of a stroke, and the places near them at which they can be joined.
class Ends {
 public:
  Ends(const SurfaceMesh& mesh, const SurfaceCurve& stroke)
      : at_(positions_of(mesh, stroke)), arcs_{0} {
    for (std::size_t i = 0; i + 1 < at_.size(); ++i) {
      arcs_.push_back(arcs_.back() + (at_[i + 1] - at_[i]).norm());
    }
    const double edge = edge_length_near(mesh.surface(), stroke);
    const double slack = stroke_slack(mesh, std::span(&stroke, 1), edge).slack;
    const auto samples = static_cast<double>(turning_points(mesh.surface(), stroke).size() + 1);
    most_ = std::min(
        std::max({kGapOfSlack * slack, kGapOfEdge * edge, kGapOfSamples * length() / samples}),
        kGapOfLength * length());
  }

  [[nodiscard]] double length() const { return arcs_.back(); }
  [[nodiscard]] double gap(std::size_t a, std::size_t b) const { return (at_[b] - at_[a]).norm(); }
  [[nodiscard]] double cut(std::size_t a, std::size_t b) const {
    return arcs_[a] + length() - arcs_[b];
  }

  struct Pair {
    std::size_t start = 0, end = 0;
  };
  /// The places near the ends to be joined; none if the hand meant no loop.
  [[nodiscard]] std::optional<Pair> meeting() const {
    std::optional<Pair> best;
    double least = HUGE_VAL;
    const std::vector<std::size_t> ends = places_near_end();
    for (const std::size_t a : places_near_start()) {
      for (const std::size_t b : ends) {
        if (a >= b || gap(a, b) > most_ || !goes_on(at_, a, b, most_)) continue;
        const double cost = cut(a, b) + kGapCounts * gap(a, b);
        if (cost >= least) continue;
        least = cost;
        best = Pair{a, b};
      }
    }
    return best;
  }

 private:
  [[nodiscard]] std::vector<std::size_t> thinned(std::size_t first, std::size_t last) const {
    std::vector<std::size_t> places;
    const std::size_t stride = std::max<std::size_t>(1, (last - first) / kPlaces);
    for (std::size_t i = first; i < last; i += stride) places.push_back(i);
    return places;
  }
  [[nodiscard]] std::vector<std::size_t> places_near_start() const {
    const auto last = std::upper_bound(arcs_.begin(), arcs_.end(), kEndOfLength * length());
    return thinned(0, static_cast<std::size_t>(last - arcs_.begin()));
  }
  [[nodiscard]] std::vector<std::size_t> places_near_end() const {
    const auto first = std::lower_bound(arcs_.begin(), arcs_.end(), (1 - kEndOfLength) * length());
    std::vector<std::size_t> places =
        thinned(static_cast<std::size_t>(first - arcs_.begin()), arcs_.size());
    if (places.back() + 1 != arcs_.size()) places.push_back(arcs_.size() - 1);
    return places;
  }

  std::vector<Point> at_;
  std::vector<double> arcs_;
  double most_ = 0;  // the largest gap
};

}  // namespace

CurveEnds curve_ends(std::string_view name) {
  if (name == "auto") return CurveEnds::kAsDrawn;
  if (name == "closed") return CurveEnds::kClosed;
  if (name == "open") return CurveEnds::kOpen;
  throw Error(
      ErrorCode::kBadUsage,
      fmt::format("The option for ends of curves must be auto, closed or open, not \"{}\".", name));
}

std::optional<double> gap_of_near_loop(const SurfaceMesh& mesh, const SurfaceCurve& stroke) {
  if (stroke.closed || stroke.points.size() < 3) return std::nullopt;
  const std::vector<Point> at = positions_of(mesh, stroke);
  double length = 0;
  for (std::size_t i = 0; i + 1 < at.size(); ++i) length += (at[i + 1] - at[i]).norm();
  const double gap = (at.front() - at.back()).norm();
  if (gap > kGapOfLength * length || !goes_on(at, 0, at.size() - 1, gap)) return std::nullopt;
  return gap;
}

std::optional<ClosedLoop> closed_loop(const SurfaceMesh& mesh, const SurfaceCurve& stroke,
                                      StraightLines& lines, bool always) {
  if (stroke.closed || stroke.points.size() < 3) return std::nullopt;
  const Ends ends(mesh, stroke);
  std::optional<Ends::Pair> meeting = ends.meeting();
  if (!meeting && !always) return std::nullopt;
  if (!meeting) meeting = Ends::Pair{0, stroke.points.size() - 1};
  const std::vector<SurfacePoint> points(
      stroke.points.begin() + static_cast<std::ptrdiff_t>(meeting->start),
      stroke.points.begin() + static_cast<std::ptrdiff_t>(meeting->end) + 1);
  return ClosedLoop{lines.join(points, true), ends.gap(meeting->start, meeting->end),
                    ends.cut(meeting->start, meeting->end)};
}

}  // namespace talweg
