#include "talweg/core/cutting/plane_filling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "talweg/core/cutting/face_triangulation.hpp"
#include "talweg/core/cutting/mixed_order.hpp"
#include "talweg/core/space/box_tree.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

struct Plane {
  Point origin = Point::Zero();
  Point normal = Point::Zero();  // a unit vector, or zero
  double area = 0, extent = 0;
  Point u = Point::Zero(), v = Point::Zero();

  [[nodiscard]] PlanePoint operator()(const Point& p) const {
    return {(p - origin).dot(u), (p - origin).dot(v)};
  }
  [[nodiscard]] double distance(const std::vector<Point>& points, const Loop& loop) const {
    double largest = 0;
    for (const std::uint32_t i : loop) {
      largest = std::max(largest, std::abs((points[i] - origin).dot(normal)));
    }
    return largest;
  }
};

Plane plane_of(const std::vector<Point>& points, const Loop& loop) {
  Plane plane;
  for (const std::uint32_t v : loop) plane.origin += points[v] / static_cast<double>(loop.size());
  Point sum = Point::Zero(), low = points[loop[0]], high = low;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point &p = points[loop[i]], &q = points[loop[(i + 1) % loop.size()]];
    sum += (p - plane.origin).cross(q - plane.origin);
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  plane.extent = (high - low).norm();
  plane.area = sum.norm() / 2;
  plane.normal = sum.stableNormalized();
  plane.u = plane.normal.unitOrthogonal();
  plane.v = plane.normal.cross(plane.u);
  return plane;
}

/// Whether a point in the plane lies inside a loop, by counting crossings of a ray.
bool contains(const std::vector<Point>& points, const Plane& plane, const Loop& loop,
              const Point& point) {
  const PlanePoint at = plane(point);
  bool inside = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const PlanePoint p = plane(points[loop[i]]), q = plane(points[loop[(i + 1) % loop.size()]]);
    if ((p.y > at.y) == (q.y > at.y)) continue;
    if (p.x + (at.y - p.y) / (q.y - p.y) * (q.x - p.x) > at.x) inside = !inside;
  }
  return inside;
}

bool meet(const std::vector<Point>& points, const Loop& a, const Loop& b) {
  std::set<std::array<double, 3>> places;
  for (const std::uint32_t v : a) places.insert({points[v].x(), points[v].y(), points[v].z()});
  return std::any_of(b.begin(), b.end(), [&](std::uint32_t v) {
    return places.count({points[v].x(), points[v].y(), points[v].z()}) > 0;
  });
}

/// Triangulates a large triangle around the loops, with the loops as constrained edges.
class PlaneFiller {
 public:
  PlaneFiller(const std::vector<Point>& points, std::span<const Loop> loops)
      : points_(points),
        loops_(loops),
        plane_(plane_of(points, loops[0])),
        triangulation_({PlanePoint{0, 0}, PlanePoint{1, 0}, PlanePoint{0, 1}}) {}

  std::optional<std::vector<Triangle>> run() {
    if (!(plane_.area > 0) || !insert() || !connect()) return std::nullopt;
    triangulation_.improve();
    std::vector<Triangle> triangles = inside();
    std::size_t corners = 0;
    for (const Loop& loop : loops_) corners += loop.size();
    if (triangles.size() != corners + 2 * (loops_.size() - 1) - 2) return std::nullopt;
    return triangles;
  }

 private:
  /// Inserts the points in a mixed order, which avoids thin triangles. False if two points share a
  /// place.
  bool insert() {
    std::vector<std::uint32_t> all;
    for (const Loop& loop : loops_) all.insert(all.end(), loop.begin(), loop.end());
    const MixedOrder mixed(all.size());
    number_ = {0, 0, 0};  // the corners of the large triangle
    for (std::size_t k = 0; k < all.size(); ++k) {
      const std::uint32_t v = all[mixed[k]];
      if (triangulation_.insert(place(points_[v])) != number_.size()) return false;
      local_[v] = static_cast<std::uint32_t>(number_.size());
      number_.push_back(v);
    }
    triangulation_.improve();
    return local_.size() == all.size();
  }

  /// The lattice place of a point. The loops cover at most two fifths of the large triangle's
  /// sides.
  [[nodiscard]] FaceTriangulation::Place place(const Point& point) const {
    const PlanePoint at = plane_(point);
    const auto on_lattice = [&](double x) {
      return std::llround((0.3 + 0.2 * x / plane_.extent) *
                          static_cast<double>(FaceTriangulation::kOne));
    };
    FaceTriangulation::Place place{0, on_lattice(at.x), on_lattice(at.y)};
    place[0] = FaceTriangulation::kOne - place[1] - place[2];
    return place;
  }

  bool connect() {
    for (const Loop& loop : loops_) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const std::uint32_t a = local_[loop[i]], b = local_[loop[(i + 1) % loop.size()]];
        const std::size_t segment = triangulation_.connect(a, b);
        if (triangulation_.places().size() != number_.size()) return false;  // the loops cross
        if (triangulation_.chain(segment).size() != 2)
          return false;  // the segment passes through another point
        if (!rims_.insert(std::minmax(a, b)).second) return false;
      }
    }
    return true;
  }

  /// The triangles that are reached from the left of the first loop without crossing a loop.
  std::vector<Triangle> inside() {
    const auto& all = triangulation_.triangles();
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> left_of;
    for (std::size_t t = 0; t < all.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) left_of[{all[t][k], all[t][(k + 1) % 3]}] = t;
    }
    std::vector<bool> reached(all.size(), false);
    std::vector<std::size_t> open{left_of.at({local_[loops_[0][0]], local_[loops_[0][1]]})};
    reached[open[0]] = true;
    while (!open.empty()) {
      const auto corners = all[open.back()];
      open.pop_back();
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = corners[k], b = corners[(k + 1) % 3];
        const auto next = left_of.find({b, a});
        if (next == left_of.end() || rims_.count(std::minmax(a, b)) > 0) continue;
        if (reached[next->second]) continue;
        reached[next->second] = true;
        open.push_back(next->second);
      }
    }
    std::vector<Triangle> triangles;
    for (std::size_t t = 0; t < all.size(); ++t) {
      if (!reached[t]) continue;
      const auto& [a, b, c] = all[t];
      triangles.push_back({number_[a], number_[b], number_[c]});
    }
    return triangles;
  }

  const std::vector<Point>& points_;
  std::span<const Loop> loops_;
  Plane plane_;
  FaceTriangulation triangulation_;
  std::vector<std::uint32_t> number_;  // by point of the triangulation, the point of a loop
  std::map<std::uint32_t, std::uint32_t> local_;  // the reverse of number_
  std::set<std::pair<std::uint32_t, std::uint32_t>> rims_;
};

/// A loop's bounding box, enlarged by more than the distance that kPlaneTolerance allows between
/// its plane and its holes.
SpaceBox box_around(const std::vector<Point>& points, const Loop& loop, double extent) {
  const double wider = 8 * kPlaneTolerance * extent;
  SpaceBox box{points[loop[0]], points[loop[0]]};
  for (const std::uint32_t i : loop) box = box.with({points[i], points[i]});
  box.low.array() -= wider;
  box.high.array() += wider;
  return box;
}

/// Groups of an outer loop and its holes.
std::vector<std::vector<std::size_t>> grouped(std::vector<std::size_t> plane_loops,
                                              const std::vector<std::size_t>& hole_of) {
  std::sort(plane_loops.begin(), plane_loops.end());
  std::vector<std::vector<std::size_t>> groups;
  std::vector<std::size_t> group_of(hole_of.size());
  const auto is_hole = [&](std::size_t i) { return hole_of[i] < hole_of.size(); };
  for (const std::size_t i : plane_loops) {
    if (is_hole(i)) continue;
    group_of[i] = groups.size();
    groups.push_back({i});
  }
  for (const std::size_t i : plane_loops) {
    if (is_hole(i)) groups[group_of[hole_of[i]]].push_back(i);
  }
  return groups;
}

}  // namespace

double distance_from_plane(const std::vector<Point>& points, const Loop& loop) {
  const Plane plane = plane_of(points, loop);
  if (!(plane.area > 0)) return std::numeric_limits<double>::infinity();
  return plane.distance(points, loop) / plane.extent;
}

std::vector<std::vector<std::size_t>> plane_groups(const std::vector<Point>& points,
                                                   std::span<const Loop> loops) {
  std::vector<Plane> planes;
  std::vector<std::size_t> by_area;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    planes.push_back(plane_of(points, loops[i]));
    if (distance_from_plane(points, loops[i]) <= kPlaneTolerance) by_area.push_back(i);
  }
  std::stable_sort(by_area.begin(), by_area.end(),
                   [&](std::size_t i, std::size_t j) { return planes[i].area > planes[j].area; });
  const auto is_around = [&](std::size_t outer, std::size_t inner) {
    const Plane &plane = planes[outer], &other = planes[inner];
    return plane.area > other.area && plane.normal.dot(other.normal) < 0 &&
           plane.distance(points, loops[inner]) <= kPlaneTolerance * plane.extent &&
           contains(points, plane, loops[outer], points[loops[inner][0]]) &&
           !meet(points, loops[outer], loops[inner]);
  };
  constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> around(by_area.size(),
                                  kNone);  // the smallest loop around each, by place in by_area
  const auto box_of = [&](std::uint32_t k) {
    return box_around(points, loops[by_area[k]], planes[by_area[k]].extent);
  };
  BoxTree(by_area.size(), box_of).visit_pairs(box_of, [&](std::size_t j, std::size_t k) {
    if (around[k] != kNone && around[k] > j) return;
    if (is_around(by_area[j], by_area[k])) around[k] = j;
  });
  std::vector<std::size_t> hole_of(loops.size(), kNone);
  for (std::size_t k = 0; k < by_area.size(); ++k) {
    if (around[k] == kNone) continue;
    // A loop inside a hole gets a lid of its own.
    const std::size_t outer = by_area[around[k]];
    if (hole_of[outer] == kNone) hole_of[by_area[k]] = outer;
  }
  return grouped(std::move(by_area), hole_of);
}

std::optional<std::vector<Triangle>> fill_plane(const std::vector<Point>& points,
                                                std::span<const Loop> loops) {
  if (loops.empty() || loops[0].size() < 3) return std::nullopt;
  try {
    return PlaneFiller(points, loops).run();
  } catch (const Error& error) {
    if (error.code() != ErrorCode::kNumerical) throw;
    return std::nullopt;  // the loops cannot be filled
  }
}

}  // namespace talweg
