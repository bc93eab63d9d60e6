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

class Welder {
 public:
  explicit Welder(const MeshLists& lists)
      : lists_(lists),
        groups_(lists.points.size()),
        shortest_(lists.points.size(), std::numeric_limits<double>::infinity()),
        used_(lists.points.size(), false) {}

  Welding run() {
    measure();
    join_equal();
    if (tolerance_ > 0) join_close();
    Welding result{std::vector<std::uint32_t>(lists_.points.size()), tolerance_};
    for (std::uint32_t v = 0; v < result.onto.size(); ++v) result.onto[v] = groups_.find(v);
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
    const double unit = lists_.single_precision
                            ? static_cast<double>(std::numeric_limits<float>::epsilon())
                            : std::numeric_limits<double>::epsilon();
    tolerance_ = kUnitsInTheLastPlace * unit * largest;
  }

  /// Joins equal positions; a group's shortest edge is the shortest of all its vertices.
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

  /// Joins different positions. Of nearly all vertices a grid with cells twice as wide as the
  /// tolerance tells that nothing else is near.
  void join_close() {
    grid_.reserve(places_.size());
    for (const std::uint32_t v : places_) grid_.push_back({cell_of(lists_.points[v]), v});
    std::sort(grid_.begin(), grid_.end());
    std::vector<std::uint32_t> crowded;
    for (const Placed& placed : grid_) {
      if (!is_alone(placed.vertex)) crowded.push_back(placed.vertex);
    }
    std::vector<double> reach(std::move(shortest_));
    for (double& r : reach) r = std::min(tolerance_, kPartOfEdge * r);
    ReachTree(lists_.points, reach, std::move(crowded), groups_).join();
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

  const MeshLists& lists_;
  UnionFind groups_;
  std::vector<double> shortest_;  ///< length of the shortest edge of positive length at each vertex
  std::vector<bool> used_;
  std::vector<std::uint32_t> places_;  ///< one vertex per position
  std::vector<Placed> grid_;
  double tolerance_ = 0;
};

}  // namespace

Welding weld_vertices(const MeshLists& lists) { return Welder(lists).run(); }

}  // namespace talweg
