#include "talweg/core/fairing/joined_curves.hpp"

#include <algorithm>
#include <array>
#include <compare>
#include <optional>
#include <tuple>
#include <utility>
#include <variant>

#include "talweg/core/mesh/border_points.hpp"

namespace talweg {
namespace {

/// A key to sort points; equal keys are equal points.
auto key_of(const SurfacePoint& point) {
  using Key = std::tuple<std::size_t, std::size_t, double, double, double>;
  const auto& where = point.where();
  if (const auto* v = std::get_if<AtVertex>(&where)) return Key{0, v->vertex.index(), 0, 0, 0};
  if (const auto* e = std::get_if<OnEdge>(&where)) return Key{1, e->edge.index(), e->t, 0, 0};
  const auto& f = std::get<InFace>(where);
  return Key{2, f.face.index(), f.barycentric[0], f.barycentric[1], f.barycentric[2]};
}
using Key = decltype(key_of(std::declval<const SurfacePoint&>()));

/// An end of an open curve: side 0 is its first point, side 1 its last point.
struct End {
  std::size_t curve = 0, side = 0;
};

struct Meeting {
  Key at;
  End end;
};

const SurfacePoint& point_of(std::span<const SurfaceCurve> curves, const End& end) {
  const auto& points = curves[end.curve].points;
  return end.side == 0 ? points.front() : points.back();
}

std::vector<Meeting> sorted_ends(std::span<const SurfaceCurve> curves) {
  std::vector<Meeting> ends;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (curves[c].closed) continue;
    for (const std::size_t side : {0U, 1U}) {
      ends.push_back({key_of(point_of(curves, {c, side})), {c, side}});
    }
  }
  std::stable_sort(ends.begin(), ends.end(),
                   [](const Meeting& a, const Meeting& b) { return a.at < b.at; });
  return ends;
}

/// The end that each end meets, if any.
class Links {
 public:
  explicit Links(std::size_t curves) : links_(curves) {}

  void add(const End& a, const End& b) {
    links_[a.curve][a.side] = b;
    links_[b.curve][b.side] = a;
  }
  [[nodiscard]] const std::optional<End>& from(const End& end) const {
    return links_[end.curve][end.side];
  }

 private:
  std::vector<std::array<std::optional<End>, 2>> links_;
};

Links links_between(const Surface& surface, std::span<const SurfaceCurve> curves,
                    std::span<const SurfacePoint> corners,
                    const std::function<bool(std::size_t, std::size_t)>& may_join) {
  Links links(curves.size());
  const std::vector<Meeting> ends = sorted_ends(curves);
  std::vector<std::size_t> pairs;  // the index of their first end in `ends`
  for (std::size_t i = 0; i < ends.size();) {
    std::size_t j = i + 1;
    while (j < ends.size() && ends[j].at == ends[i].at) ++j;
    const SurfacePoint& point = point_of(curves, ends[i].end);
    if (j == i + 2 && may_join(ends[i].end.curve, ends[i + 1].end.curve) &&
        !is_on_boundary(surface, point) &&
        std::find(corners.begin(), corners.end(), point) == corners.end()) {
      pairs.push_back(i);
    }
    i = j;
  }
  if (pairs.empty()) return links;
  std::vector<bool> passed(pairs.size(), false);
  for (const SurfaceCurve& curve : curves) {
    const std::size_t skip = curve.closed ? 0 : 1;
    for (std::size_t k = skip; k + skip < curve.points.size(); ++k) {
      const Key key = key_of(curve.points[k]);
      const auto at = std::lower_bound(pairs.begin(), pairs.end(), key,
                                       [&](std::size_t i, const Key& b) { return ends[i].at < b; });
      if (at == pairs.end() || ends[*at].at != key) continue;
      passed[static_cast<std::size_t>(at - pairs.begin())] = true;
    }
  }
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (!passed[k]) links.add(ends[pairs[k]].end, ends[pairs[k] + 1].end);
  }
  return links;
}

}  // namespace

std::vector<JoinedCurves> joined_curves(
    const Surface& surface, std::span<const SurfaceCurve> curves,
    std::span<const SurfacePoint> corners,
    const std::function<bool(std::size_t, std::size_t)>& may_join) {
  const Links links = links_between(surface, curves, corners, may_join);
  std::vector<JoinedCurves> groups;
  std::vector<bool> taken(curves.size(), false);
  const auto follow = [&](End start) {
    JoinedCurves& group = groups.emplace_back();
    for (std::optional<End> next = start; next && !taken[next->curve];) {
      taken[next->curve] = true;
      group.parts.push_back({next->curve, next->side == 1});
      next = links.from({next->curve, 1 - next->side});
      group.is_ring = next.has_value();
    }
  };
  for (std::size_t c = 0; c < curves.size(); ++c) {
    for (const std::size_t side : {0U, 1U}) {
      if (!taken[c] && !links.from({c, side})) follow({c, side});
    }
  }
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (!taken[c]) follow({c, 0});
  }
  return groups;
}

SurfaceCurve joined_parts(const JoinedCurves& joined, std::vector<SurfaceCurve> parts) {
  if (!joined.is_joined()) return std::move(parts.front());
  SurfaceCurve result;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    std::vector<SurfacePoint>& points = parts[k].points;
    if (joined.parts[k].reversed) std::reverse(points.begin(), points.end());
    if (!result.points.empty()) result.points.pop_back();
    result.points.insert(result.points.end(), points.begin(), points.end());
  }
  result.closed = joined.is_ring;
  if (joined.is_ring) result.points.pop_back();
  return result;
}

SurfaceCurve joined(const JoinedCurves& joined, std::span<const SurfaceCurve> curves) {
  std::vector<SurfaceCurve> parts;
  parts.reserve(joined.parts.size());
  for (const JoinedCurves::Part& part : joined.parts) parts.push_back(curves[part.curve]);
  return joined_parts(joined, std::move(parts));
}

std::vector<SurfacePoint> junctions(const JoinedCurves& joined,
                                    std::span<const SurfaceCurve> curves) {
  std::vector<SurfacePoint> result;
  for (std::size_t k = joined.is_ring ? 0 : 1; k < joined.parts.size(); ++k) {
    const JoinedCurves::Part& part = joined.parts[k];
    result.push_back(point_of(curves, {part.curve, part.reversed ? 1U : 0U}));
  }
  return result;
}

std::vector<SurfaceCurve> split_at_junctions(const JoinedCurves& joined,
                                             std::span<const SurfacePoint> junctions,
                                             SurfaceCurve curve) {
  std::vector<SurfaceCurve> result;
  if (!joined.is_joined()) {
    result.push_back(std::move(curve));
    return result;
  }
  std::vector<SurfacePoint>& points = curve.points;
  if (joined.is_ring) {
    std::rotate(points.begin(), std::find(points.begin(), points.end(), junctions[0]),
                points.end());
    points.push_back(junctions[0]);
    junctions = junctions.subspan(1);
  }
  auto from = points.begin();
  for (std::size_t k = 0; k < joined.parts.size(); ++k) {
    const auto last =
        k < junctions.size() ? std::find(from, points.end() - 1, junctions[k]) : points.end() - 1;
    SurfaceCurve& part = result.emplace_back();
    part.points.assign(from, last + 1);
    if (joined.parts[k].reversed) std::reverse(part.points.begin(), part.points.end());
    from = last;
  }
  return result;
}

}  // namespace talweg
