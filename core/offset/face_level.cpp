#include "talweg/core/offset/face_level.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "talweg/core/offset/level_crossings.hpp"

namespace talweg {
namespace {

using Barycentric = std::array<double, 3>;

Barycentric mixed(const Barycentric& a, const Barycentric& b, double t) {
  Barycentric result{};
  for (std::size_t k = 0; k < 3; ++k) result[k] = (1 - t) * a[k] + t * b[k];
  return result;
}

/// A triangular part of the face.
struct LevelPart {
  struct Corner {
    Barycentric at{};
    bool near = false;
  };
  struct Crossing {
    double t = 0;  ///< fraction of the side
    std::uint32_t node = 0;
  };
  using Side = std::vector<Crossing>;
  std::array<Corner, 3> corners;
  std::array<Side, 3> sides;
};

/// A crossing on the rim of a part. The rim runs counterclockwise.
struct RimNode {
  std::uint32_t node = 0;
  bool exit = false;  ///< from near to far
};

class LevelFinder {
 public:
  LevelFinder(const FacePaths& paths, const LevelChoice& choice)
      : paths_(paths), level_(choice.level), tolerance_(choice.tolerance) {
    for (std::size_t i = 0; i < paths_.count(); ++i) {
      if (i >= 3 || !is_passed(i)) ways_that_matter_.push_back(i);
    }
  }

  FaceLevel find(const FaceRim& rim);

 private:
  static constexpr std::size_t kMostParts = 20'000;

  [[nodiscard]] PlanePoint plane(const Barycentric& b) const { return paths_.frames[0].at(b, 0); }
  [[nodiscard]] double between(const Barycentric& a, const Barycentric& b) const {
    return norm(plane(a) - plane(b));
  }
  [[nodiscard]] double distance(const Barycentric& b) const {
    return paths_.hit(b).nearest.distance;
  }

  [[nodiscard]] bool is_passed(std::size_t corner) const;
  LevelPart whole(const FaceRim& rim);
  [[nodiscard]] std::size_t longest_side(const LevelPart& part) const;
  [[nodiscard]] bool is_simple(const LevelPart& part);
  void set_rim(const LevelPart& part);
  void set_chords();
  [[nodiscard]] bool has_hidden_source(const LevelPart& part) const;
  [[nodiscard]] bool are_chords_exact() const;
  [[nodiscard]] bool is_one_way_near(const LevelPart& part) const;
  [[nodiscard]] bool rises_throughout(const LevelPart& part) const;
  [[nodiscard]] std::vector<std::vector<Barycentric>> near_parts(const LevelPart& part) const;
  void split(const LevelPart& part, std::size_t side);
  LevelPart::Side crossings_between(const LevelPart::Corner& from, const LevelPart::Corner& to);

  const FacePaths& paths_;
  double level_, tolerance_;
  std::vector<std::size_t> ways_that_matter_;
  FaceLevel found_;
  std::vector<LevelPart> open_;
  // State of the part under examination.
  Barycentric center_{};
  double reach_ = 0;  // from the center to the farthest corner
  bool center_near_ = false;
  std::vector<RimNode> rim_;
  std::vector<FaceLevel::Chord> chords_;
};

/// Whether another way is as short at the corner as the corner's distance. The way through the
/// corner is then nowhere shorter than the other way.
bool LevelFinder::is_passed(std::size_t corner) const {
  constexpr double kSame = 1e-12;
  Barycentric at{};
  at[corner] = 1;
  const double most = paths_.corners[corner].distance + kSame * paths_.longest;
  for (std::size_t i = 3; i < paths_.count(); ++i) {
    if (paths_.path(i, at).nearest.distance <= most) return true;
  }
  return false;
}

LevelPart LevelFinder::whole(const FaceRim& rim) {
  LevelPart part;
  for (std::size_t k = 0; k < 3; ++k) {
    part.corners[k].at[k] = 1;
    part.corners[k].near = rim.near[k];
  }
  for (std::size_t k = 0; k < 3; ++k) {
    for (const double t : rim.crossings[k]) {
      part.sides[k].push_back({t, static_cast<std::uint32_t>(found_.nodes.size())});
      found_.nodes.push_back(mixed(part.corners[k].at, part.corners[(k + 1) % 3].at, t));
    }
  }
  return part;
}

FaceLevel LevelFinder::find(const FaceRim& rim) {
  open_.push_back(whole(rim));
  for (std::size_t parts = 1; !open_.empty(); ++parts) {
    const LevelPart part = std::move(open_.back());
    open_.pop_back();
    set_rim(part);
    const std::size_t side = longest_side(part);
    const double length = between(part.corners[side].at, part.corners[(side + 1) % 3].at);
    const bool is_small = !(length > tolerance_ / 2) || parts > kMostParts;
    if (is_small || is_simple(part)) {
      found_.chords.insert(found_.chords.end(), chords_.begin(), chords_.end());
    } else {
      split(part, side);
    }
  }
  return std::move(found_);
}

std::size_t LevelFinder::longest_side(const LevelPart& part) const {
  std::array<double, 3> length{};
  for (std::size_t k = 0; k < 3; ++k) {
    length[k] = between(part.corners[k].at, part.corners[(k + 1) % 3].at);
  }
  return static_cast<std::size_t>(std::max_element(length.begin(), length.end()) - length.begin());
}

/// Collects the crossings on the rim of a part and joins them by chords.
void LevelFinder::set_rim(const LevelPart& part) {
  center_ = {};
  for (const auto& corner : part.corners) {
    for (std::size_t i = 0; i < 3; ++i) center_[i] += corner.at[i] / 3;
  }
  reach_ = 0;
  for (const auto& corner : part.corners) reach_ = std::max(reach_, between(center_, corner.at));
  center_near_ = distance(center_) <= level_;
  rim_.clear();
  bool near = part.corners[0].near;
  for (const LevelPart::Side& side : part.sides) {
    for (const LevelPart::Crossing& crossing : side) {
      rim_.push_back({crossing.node, near});
      near = !near;
    }
  }
  set_chords();
}

/// A chord cuts off a far stretch of the rim if the center is near, otherwise a near stretch.
void LevelFinder::set_chords() {
  chords_.clear();
  const std::size_t n = rim_.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (!rim_[i].exit) continue;
    const std::size_t entry = center_near_ ? (i + 1) % n : (i + n - 1) % n;
    chords_.push_back({rim_[i].node, rim_[entry].node});
  }
}

bool LevelFinder::is_simple(const LevelPart& part) {
  if (has_hidden_source(part) || !are_chords_exact()) return false;
  const bool far = rim_.empty() && !part.corners[0].near;
  return far || distance(center_) + reach_ < level_ || is_one_way_near(part) ||
         rises_throughout(part);
}

/// Whether an end of a segment of the curves lies beyond the chords of the part. The distance has
/// minima only on curves, so the chords then miss a component of the level set around the end.
bool LevelFinder::has_hidden_source(const LevelPart& part) const {
  if (paths_.segments.empty()) return false;
  const auto inside = [&](PlanePoint p, std::span<const PlanePoint> polygon) {
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const PlanePoint side = polygon[(k + 1) % polygon.size()] - polygon[k];
      if (cross(side, p - polygon[k]) < 0) return false;
    }
    return true;
  };
  const std::vector<std::vector<Barycentric>> near = near_parts(part);
  const auto is_in = [&](const Barycentric& b, std::span<const Barycentric> polygon) {
    std::vector<PlanePoint> corners;
    for (const Barycentric& corner : polygon) corners.push_back(plane(corner));
    return inside(plane(b), corners);
  };
  const std::array triangle = {part.corners[0].at, part.corners[1].at, part.corners[2].at};
  for (const PolylinePiece& piece : paths_.segments) {
    for (const Barycentric& end : {piece.from, piece.to}) {
      const auto has_it = [&](const auto& polygon) { return is_in(end, polygon); };
      if (is_in(end, triangle) && std::none_of(near.begin(), near.end(), has_it)) return true;
    }
  }
  return false;
}

bool LevelFinder::are_chords_exact() const {
  for (const FaceLevel::Chord& chord : chords_) {
    const Barycentric &a = found_.nodes[chord.from], &b = found_.nodes[chord.to];
    if (between(a, b) <= tolerance_) continue;
    for (const double t : {0.5, 0.25, 0.75}) {
      if (!(std::abs(distance(mixed(a, b, t)) - level_) <= tolerance_)) return false;
    }
  }
  return true;
}

/// The polygons on the near side of the chords.
std::vector<std::vector<Barycentric>> LevelFinder::near_parts(const LevelPart& part) const {
  std::vector<std::vector<Barycentric>> polygons(1);
  bool near = part.corners[0].near;
  for (std::size_t k = 0; k < 3; ++k) {
    if (near) polygons.back().push_back(part.corners[k].at);
    for (const LevelPart::Crossing& crossing : part.sides[k]) {
      if (!near && !center_near_ && !polygons.back().empty()) polygons.emplace_back();
      polygons.back().push_back(found_.nodes[crossing.node]);
      near = !near;
    }
  }
  // The polygon that begins at the first corner continues the polygon that ends there.
  if (near && polygons.size() > 1) {
    polygons.front().insert(polygons.front().begin(), polygons.back().begin(),
                            polygons.back().end());
    polygons.pop_back();
  }
  if (polygons.back().empty()) polygons.pop_back();
  return polygons;
}

/// Whether for each near polygon a single way is within the level at all its corners. The length of
/// a way is convex, so no point of the polygon is then far.
bool LevelFinder::is_one_way_near(const LevelPart& part) const {
  constexpr double kSame = 1e-9;
  const double most = level_ + kSame * std::max(level_, paths_.longest);
  for (const std::vector<Barycentric>& polygon : near_parts(part)) {
    bool found = false;
    for (std::size_t i = 0; i < paths_.count() && !found; ++i) {
      found = std::all_of(polygon.begin(), polygon.end(), [&](const Barycentric& b) {
        return paths_.path(i, b).nearest.distance <= most;
      });
    }
    if (!found) return false;
  }
  return true;
}

/// Whether all ways that can be shortest in the part get longer along one common direction. The
/// distance then has no local maximum inside the part.
bool LevelFinder::rises_throughout(const LevelPart& part) const {
  constexpr double kLeast = 0.05;  // slope
  const double most = distance(center_) + 2 * reach_;
  std::vector<PlanePoint> slopes;
  PlanePoint sum;
  for (const std::size_t i : ways_that_matter_) {
    if (!(paths_.path(i, center_).nearest.distance <= most)) continue;
    for (const auto& corner : part.corners) {
      const FacePaths::Hit way = paths_.path(i, corner.at);
      slopes.push_back({paths_.slopes(way, corner.at, {1, 0}).distance,
                        paths_.slopes(way, corner.at, {0, 1}).distance});
      sum = sum + slopes.back();
    }
  }
  const double length = norm(sum);
  return std::all_of(slopes.begin(), slopes.end(),
                     [&](PlanePoint s) { return dot(s, sum) > kLeast * length; });
}

LevelPart::Side LevelFinder::crossings_between(const LevelPart::Corner& from,
                                               const LevelPart::Corner& to) {
  constexpr double kGap = 1e-11;  // fraction of the line
  const double length = between(from.at, to.at);
  std::vector<Stretch> stretches;
  for (std::size_t i = 0; i < paths_.count() && length > 0; ++i) {
    const auto way = [&](double x) {
      return paths_.path(i, mixed(from.at, to.at, x / length)).nearest.distance;
    };
    if (const auto stretch = stretch_below(way, length, level_)) stretches.push_back(*stretch);
  }
  stretches = joined_stretches(std::move(stretches), kGap * length);
  LevelPart::Side side;
  for (const double x : level_crossings(stretches, length, from.near, to.near)) {
    const double t = length > 0 ? x / length : 0;
    side.push_back({t, static_cast<std::uint32_t>(found_.nodes.size())});
    found_.nodes.push_back(mixed(from.at, to.at, t));
  }
  return side;
}

/// Halves a part along the line from the middle of a side to the opposite corner.
void LevelFinder::split(const LevelPart& part, std::size_t side) {
  const std::size_t next = (side + 1) % 3, across = (side + 2) % 3;
  const auto &a = part.corners[side], &b = part.corners[next], &c = part.corners[across];
  LevelPart::Side first, second;
  for (const LevelPart::Crossing& crossing : part.sides[side]) {
    if (crossing.t <= 0.5) {
      first.push_back({2 * crossing.t, crossing.node});
    } else {
      second.push_back({2 * crossing.t - 1, crossing.node});
    }
  }
  const LevelPart::Corner middle{mixed(a.at, b.at, 0.5), a.near != (first.size() % 2 == 1)};
  const LevelPart::Side there = crossings_between(middle, c);
  LevelPart::Side back;
  for (auto crossing = there.rbegin(); crossing != there.rend(); ++crossing) {
    back.push_back({1 - crossing->t, crossing->node});
  }
  open_.push_back({{a, middle, c}, {std::move(first), there, part.sides[across]}});
  open_.push_back({{middle, b, c}, {std::move(second), part.sides[next], std::move(back)}});
}

}  // namespace

FaceLevel level_in_face(const FacePaths& paths, const FaceRim& rim, const LevelChoice& choice) {
  return LevelFinder(paths, choice).find(rim);
}

}  // namespace talweg
