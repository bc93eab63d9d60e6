#include "talweg/core/repair/vertex_welding.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>

#include "talweg/core/mesh/union_find.hpp"
#include "talweg/core/repair/reach_tree.hpp"
#include "talweg/core/space/point_distance.hpp"

namespace talweg {
namespace {

constexpr double kUnitsInTheLastPlace = 2;
constexpr double kPartOfEdge = 0.25;
constexpr double kPartOfEdgeWhereAsked = 0.5;  // for a given tolerance
constexpr double kNear = 1e-4;                 // times the mean edge length

double unit_of(const MeshLists& lists) {
  return lists.single_precision ? static_cast<double>(std::numeric_limits<float>::epsilon())
                                : std::numeric_limits<double>::epsilon();
}

/// A length rounded up to two significant digits, after subtracting its rounding error; 0 for a
/// length of 0.
double with_two_digits(double length, double rounding) {
  if (!(length > 0)) return 0;
  const double unit = std::pow(10, std::floor(std::log10(length)) - 1);
  return std::ceil((length - std::min(rounding, 1e-3 * length)) / unit) * unit;
}

class Welder {
 public:
  Welder(const MeshLists& lists, double tolerance)
      : lists_(lists),
        asked_(tolerance),
        groups_(lists.points.size()),
        shortest_(lists.points.size(), std::numeric_limits<double>::infinity()),
        used_(lists.points.size(), false) {}

  Welding run() {
    measure();
    join_equal();
    Welding result{std::vector<std::uint32_t>(lists_.points.size()), tolerance_, 0};
    if (!(tolerance_ > 0)) {
      name(result, groups_);
      return result;
    }
    UnionFind equal = groups_;
    const std::vector<std::uint32_t> crowded = crowded_places();
    std::vector<double> reach = shortest_;
    const double part = asked_ > 0 ? kPartOfEdgeWhereAsked : kPartOfEdge;
    for (double& r : reach) r = std::min(tolerance_, part * r);
    ReachTree(lists_.points, reach, crowded, groups_).join();
    name(result, groups_);
    if (asked_ > 0) {
      keep_edges(result, equal);
      result.held_apart = held_apart(result, crowded, std::move(equal));
    }
    return result;
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  struct Placed {
    Cell cell;
    std::uint32_t vertex;
    friend bool operator<(const Placed& a, const Placed& b) {
      return std::tie(a.cell, a.vertex) < std::tie(b.cell, b.vertex);
    }
  };

  void measure() {
    double largest = 0;
    for (const Triangle& t : lists_.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = t[k];
        const std::uint32_t b = t[(k + 1) % 3];
        used_[a] = true;
        largest = std::max(largest, lists_.points[a].cwiseAbs().maxCoeff());
        const double length = point_distance(lists_.points[a], lists_.points[b]);
        if (!(length > 0)) continue;
        shortest_[a] = std::min(shortest_[a], length);
        shortest_[b] = std::min(shortest_[b], length);
      }
    }
    tolerance_ = kUnitsInTheLastPlace * unit_of(lists_) * largest + asked_;
  }

  /// Joins vertices at equal positions. The shortest edge of a group is the shortest at all its
  /// vertices.
  void join_equal() {
    for (std::uint32_t v = 0; v < used_.size(); ++v) {
      if (used_[v]) places_.push_back(v);
    }
    const auto key = [&](std::uint32_t v) {
      const Point& p = lists_.points[v];
      return std::tuple{p.x(), p.y(), p.z(), v};
    };
    std::sort(places_.begin(), places_.end(),
              [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    std::size_t last = 0;
    for (std::size_t i = 1; i < places_.size(); ++i) {
      const std::uint32_t first = places_[last];
      if (lists_.points[places_[i]] == lists_.points[first]) {
        groups_.join(first, places_[i]);
        shortest_[first] = std::min(shortest_[first], shortest_[places_[i]]);
      } else {
        places_[++last] = places_[i];
      }
    }
    if (!places_.empty()) places_.resize(last + 1);
  }

  [[nodiscard]] Cell cell_of(const Point& p) const {
    Cell cell;
    for (int k = 0; k < 3; ++k) {
      cell[static_cast<std::size_t>(k)] =
          static_cast<std::int64_t>(std::floor(p[k] / (2 * tolerance_)));
    }
    return cell;
  }

  static void name(Welding& result, UnionFind& groups) {
    for (std::uint32_t v = 0; v < result.onto.size(); ++v) result.onto[v] = groups.find(v);
  }

  /// Separates groups that contain both ends of an edge.
  void keep_edges(Welding& result, UnionFind& equal) const {
    std::vector<bool> has_edge(result.onto.size(), false);
    for (const Triangle& t : lists_.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = t[k], b = t[(k + 1) % 3];
        if (result.onto[a] == result.onto[b] && equal.find(a) != equal.find(b)) {
          has_edge[result.onto[a]] = true;
        }
      }
    }
    for (std::uint32_t v = 0; v < result.onto.size(); ++v) {
      if (has_edge[result.onto[v]]) result.onto[v] = equal.find(v);
    }
  }

  /// The number of vertices that a tolerance without the bound by edges would have joined to
  /// others.
  [[nodiscard]] std::size_t held_apart(const Welding& result,
                                       const std::vector<std::uint32_t>& crowded,
                                       UnionFind all) const {
    const std::vector<double> reach(lists_.points.size(), tolerance_);
    ReachTree(lists_.points, reach, crowded, all).join();
    std::vector<std::uint32_t> one(
        result.onto.size(), kNone);  // per wider group, the welded vertex of its first member
    std::vector<bool> mixed(result.onto.size(), false);
    for (const std::uint32_t v : crowded) {
      std::uint32_t& first = one[all.find(v)];
      if (first == kNone) first = result.onto[v];
      if (first != result.onto[v]) mixed[all.find(v)] = true;
    }
    std::size_t count = 0;
    for (const std::uint32_t v : crowded) count += mixed[all.find(v)] ? 1 : 0;
    return count;
  }

  /// One vertex per position that may have others within the tolerance. A grid with cells twice as
  /// wide as the tolerance excludes nearly all vertices.
  std::vector<std::uint32_t> crowded_places() {
    grid_.reserve(places_.size());
    for (const std::uint32_t v : places_) grid_.push_back({cell_of(lists_.points[v]), v});
    std::sort(grid_.begin(), grid_.end());
    std::vector<std::uint32_t> crowded;
    for (const Placed& placed : grid_) {
      if (!is_alone(placed.vertex)) crowded.push_back(placed.vertex);
    }
    return crowded;
  }

  [[nodiscard]] bool is_alone(std::uint32_t v) const {
    const Point reach = Point::Constant(tolerance_);
    const Cell low = cell_of(lists_.points[v] - reach);
    const Cell high = cell_of(lists_.points[v] + reach);
    for (std::int64_t x = low[0]; x <= high[0]; ++x) {
      for (std::int64_t y = low[1]; y <= high[1]; ++y) {
        for (std::int64_t z = low[2]; z <= high[2]; ++z) {
          if (has_another({x, y, z}, v)) return false;
        }
      }
    }
    return true;
  }

  [[nodiscard]] bool has_another(const Cell& cell, std::uint32_t v) const {
    auto at = std::lower_bound(grid_.begin(), grid_.end(), Placed{cell, 0});
    if (at != grid_.end() && at->vertex == v) ++at;
    return at != grid_.end() && at->cell == cell;
  }

  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  const MeshLists& lists_;
  double asked_;
  UnionFind groups_;
  std::vector<double> shortest_;  ///< per vertex, the shortest positive edge length
  std::vector<bool> used_;
  std::vector<std::uint32_t> places_;  ///< one vertex per position
  std::vector<Placed> grid_;
  double tolerance_ = 0;
};

}  // namespace

Welding weld_vertices(const MeshLists& lists, double tolerance) {
  return Welder(lists, tolerance).run();
}

NearVertices near_vertices(const MeshLists& lists, const MeshInspection& inspection) {
  NearVertices near;
  if (inspection.indices_out_of_range.found() || inspection.non_finite_vertices.found())
    return near;
  const double rounding = kUnitsInTheLastPlace * unit_of(lists) * inspection.coordinate_max;
  near.within = std::max(kNear * inspection.edge_length_mean, 2 * rounding);
  if (!(near.within > 0)) return near;
  const Welding welding = weld_vertices(lists, near.within);
  std::vector<bool> has_gap(lists.points.size(), false);
  for (std::uint32_t v = 0; v < welding.onto.size(); ++v) {
    const std::uint32_t onto = welding.onto[v];
    const double gap = point_distance(lists.points[v], lists.points[onto]);
    if (!(gap > 0)) continue;
    near.largest_gap = std::max(near.largest_gap, gap);
    has_gap[onto] = true;
  }
  for (const std::uint32_t onto : welding.onto) near.count += has_gap[onto] ? 1 : 0;
  near.tolerance = with_two_digits(near.largest_gap, rounding);
  return near;
}

}  // namespace talweg
