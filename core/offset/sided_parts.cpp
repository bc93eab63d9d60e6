#include "talweg/core/offset/sided_parts.hpp"

#include <algorithm>
#include <cstddef>

namespace talweg {
namespace {

using Kind = WayOrigin::Kind;

class SidedCutter {
 public:
  SidedCutter(const Surface& surface, const LevelCurve& isoline, const WayOrigins& origins,
              CurveSide side, OffsetCaps caps)
      : surface_(surface), line_(isoline), origins_(origins), side_(side), caps_(caps) {
    for (std::size_t i = 0; i < line_.points.size(); ++i) {
      found_.push_back(origins_.of(coordinates_in(surface_, line_.points[i], line_.faces[i])));
    }
    fill();
  }

  std::vector<SidedPart> cut() const;

 private:
  [[nodiscard]] std::size_t size() const { return line_.points.size(); }
  [[nodiscard]] bool is_wanted(Kind kind) const {
    if (side_ == CurveSide::kLeft) return kind == Kind::kLeft || kind == Kind::kUnknown;
    if (side_ == CurveSide::kRight) return kind == Kind::kRight || kind == Kind::kUnknown;
    return caps_ == OffsetCaps::kRound || kind != Kind::kEnd;
  }
  [[nodiscard]] bool is_wanted_at(std::size_t i) const { return is_wanted(found_[i].kind); }
  void fill();
  [[nodiscard]] SurfacePoint change_between(std::size_t first) const;
  [[nodiscard]] SidedPart part(std::size_t first, std::size_t count, bool closed) const;
  [[nodiscard]] CurveSide side_of(std::size_t first, std::size_t count) const;
  static void settle(SidedPart& part, std::vector<WayOrigin>& origins);
  static void begin_at_least_arc(SidedPart& part, std::vector<WayOrigin>& origins);

  const Surface& surface_;
  const LevelCurve& line_;
  const WayOrigins& origins_;
  CurveSide side_;
  OffsetCaps caps_;
  std::vector<WayOrigin> found_;  // per point
};

/// Gives a point of unknown side the side of the last known point before it, or else of the first
/// known point.
void SidedCutter::fill() {
  const std::size_t n = size();
  const auto known = [](const WayOrigin& origin) {
    return origin.kind == Kind::kLeft || origin.kind == Kind::kRight;
  };
  const auto first = std::find_if(found_.begin(), found_.end(), known);
  if (first == found_.end()) return;
  // The last known point of a closed line comes before its first known point.
  const auto before = line_.closed ? *std::find_if(found_.rbegin(), found_.rend(), known) : *first;
  Kind last = before.kind;
  for (std::size_t i = 0; i < n; ++i) {
    if (known(found_[i])) last = found_[i].kind;
    if (found_[i].kind == Kind::kUnknown) found_[i].kind = last;
  }
}

/// The place where the wanted side begins or ends on the segment after point `first`. An unknown
/// side counts as the side of `first`.
SurfacePoint SidedCutter::change_between(std::size_t first) const {
  constexpr int kHalvings = 40;
  const FaceId face = line_.faces[first];
  const auto a = coordinates_in(surface_, line_.points[first], face).barycentric;
  const auto b = coordinates_in(surface_, line_.points[(first + 1) % size()], face).barycentric;
  const bool begins = is_wanted_at(first);
  double low = 0, high = 1;
  FaceCoordinates at{face, {}};
  for (int i = 0; i < kHalvings; ++i) {
    const double t = (low + high) / 2;
    for (std::size_t k = 0; k < 3; ++k) at.barycentric[k] = (1 - t) * a[k] + t * b[k];
    const Kind kind = origins_.of(at).kind;
    const bool same = kind == Kind::kUnknown || is_wanted(kind) == begins;
    (same ? low : high) = t;
  }
  return SurfacePoint::from_barycentric(surface_, face, at.barycentric, 1e-9);
}

CurveSide SidedCutter::side_of(std::size_t first, std::size_t count) const {
  bool left = false, right = false;
  for (std::size_t k = 0; k < count; ++k) {
    const Kind kind = found_[(first + k) % size()].kind;
    left = left || kind == Kind::kLeft || kind == Kind::kEnd;
    right = right || kind == Kind::kRight || kind == Kind::kEnd;
  }
  return left == right ? CurveSide::kBoth : left ? CurveSide::kLeft : CurveSide::kRight;
}

/// Gives a part its direction and, if it is closed, its first point.
void SidedCutter::settle(SidedPart& part, std::vector<WayOrigin>& origins) {
  if (part.side == CurveSide::kLeft) {
    std::reverse(part.curve.points.begin(), part.curve.points.end());
    std::reverse(origins.begin(), origins.end());
  }
  if (part.curve.closed) begin_at_least_arc(part, origins);
  part.along = origins.front().curve;
  part.arc = origins.front().arc;
}

void SidedCutter::begin_at_least_arc(SidedPart& part, std::vector<WayOrigin>& origins) {
  const auto least =
      std::min_element(origins.begin(), origins.end(), [](const WayOrigin& a, const WayOrigin& b) {
        return a.curve != b.curve ? a.curve < b.curve : a.arc < b.arc;
      });
  const auto shift = least - origins.begin();
  std::rotate(part.curve.points.begin(), part.curve.points.begin() + shift,
              part.curve.points.end());
  std::rotate(origins.begin(), least, origins.end());
}

/// The part of `count` points from `first`, extended to the places where the side changes before
/// and after.
SidedPart SidedCutter::part(std::size_t first, std::size_t count, bool closed) const {
  const std::size_t n = size();
  SidedPart part;
  part.curve.closed = closed;
  part.side = side_of(first, count);
  std::vector<WayOrigin> origins;
  const bool has_before = line_.closed || first > 0;
  if (!closed && has_before && count < n) {
    part.curve.points.push_back(change_between((first + n - 1) % n));
    origins.push_back(found_[first]);
  }
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = (first + k) % n;
    if (!part.curve.points.empty() && part.curve.points.back() == line_.points[i]) continue;
    part.curve.points.push_back(line_.points[i]);
    origins.push_back(found_[i]);
  }
  const std::size_t last = (first + count - 1) % n;
  if (!closed && count < n && (line_.closed || last + 1 < n)) {
    const SurfacePoint end = change_between(last);
    if (!(end == part.curve.points.back())) {
      part.curve.points.push_back(end);
      origins.push_back(found_[last]);
    }
  }
  settle(part, origins);
  return part;
}

std::vector<SidedPart> SidedCutter::cut() const {
  const std::size_t n = size();
  std::size_t unwanted = 0;
  while (unwanted < n && is_wanted_at(unwanted)) ++unwanted;
  if (unwanted == n) return {part(0, n, line_.closed)};
  // A closed line is traversed from an unwanted point, so no part spans the first point of the
  // line.
  const std::size_t begin = line_.closed ? unwanted : 0;
  std::vector<SidedPart> parts;
  for (std::size_t k = 0; k < n;) {
    std::size_t count = 0;
    while (k + count < n && is_wanted_at((begin + k + count) % n)) ++count;
    if (count > 0) parts.push_back(part((begin + k) % n, count, false));
    k += std::max<std::size_t>(count, 1);
  }
  std::erase_if(parts, [](const SidedPart& part) { return part.curve.points.size() < 2; });
  return parts;
}

}  // namespace

std::vector<SidedPart> sided_parts(const Surface& surface, const LevelCurve& isoline,
                                   const WayOrigins& origins, CurveSide side, OffsetCaps caps) {
  return SidedCutter(surface, isoline, origins, side, caps).cut();
}

}  // namespace talweg
