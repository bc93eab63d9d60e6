#include "talweg/core/mesh/polygon_triangulation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "talweg/core/mesh/ear_clipping.hpp"
#include "talweg/core/mesh/measurable_point.hpp"

namespace talweg {
namespace {

constexpr double kPlane = 1e-5;  // fraction of the size; equal to the limit for rims of lids

/// A polygon, projected to the plane perpendicular to Newell's normal and scaled to size 1.
class LaidPolygon {
 public:
  /// Projects the polygon. False if it has no area, or a corner that cannot be measured.
  bool lay(const MeshLists& lists, std::span<const std::uint32_t> corners);

  [[nodiscard]] bool concave() const { return concave_; }
  [[nodiscard]] double distance() const { return distance_; }
  /// Whether the fan from the first corner triangulates the polygon: no triangle is turned over and
  /// the fan does not overlap itself.
  [[nodiscard]] bool is_fan() const;
  [[nodiscard]] std::vector<PolygonTriangle> ears() const { return clip_ears(plane_, rounding_); }

 private:
  void project(const Point& normal);
  void look_at_turns();
  [[nodiscard]] TurnInPlane turn(std::size_t a, std::size_t b, std::size_t c) const {
    return {plane_[a], plane_[b], plane_[c], rounding_};
  }

  std::vector<Point> points_;  // relative to the first corner, divided by the size
  std::vector<PlanePoint> plane_;
  double rounding_ = 0;  // rounding error of the coordinates in the plane
  double distance_ = 0;
  bool concave_ = false;
  bool convex_ = false;
};

bool LaidPolygon::lay(const MeshLists& lists, std::span<const std::uint32_t> corners) {
  points_.clear();
  plane_.clear();
  concave_ = convex_ = false;
  distance_ = 0;
  const Point origin = lists.points[corners[0]];
  Point low = origin, high = origin;
  for (const std::uint32_t v : corners) {
    if (!can_be_measured(lists.points[v])) return false;
    low = low.cwiseMin(lists.points[v]);
    high = high.cwiseMax(lists.points[v]);
  }
  const double size = (high - low).maxCoeff();
  if (!(size > 0)) return false;
  for (const std::uint32_t v : corners) points_.push_back((lists.points[v] - origin) / size);
  Point normal = Point::Zero();
  for (std::size_t k = 2; k < points_.size(); ++k) normal += points_[k - 1].cross(points_[k]);
  const double unit = lists.single_precision
                          ? static_cast<double>(std::numeric_limits<float>::epsilon())
                          : std::numeric_limits<double>::epsilon();
  const double largest = std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
  rounding_ = unit * (largest / size) + 8 * std::numeric_limits<double>::epsilon();
  if (!(normal.norm() > rounding_)) return false;
  project(normal.normalized());
  look_at_turns();
  return true;
}

void LaidPolygon::project(const Point& normal) {
  Point mean = Point::Zero();
  for (const Point& p : points_) mean += p / static_cast<double>(points_.size());
  const Point x = normal.unitOrthogonal();
  const Point y = normal.cross(x);
  for (const Point& p : points_) {
    distance_ = std::max(distance_, std::abs((p - mean).dot(normal)));
    plane_.push_back({p.dot(x), p.dot(y)});
  }
}

/// A polygon whose corners all turn left may still wind around more than once, like a pentagram.
/// Such a polygon changes its direction along x more than twice, a convex polygon twice.
void LaidPolygon::look_at_turns() {
  const std::size_t n = plane_.size();
  std::size_t changes = 0;
  double last = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t next = (k + 1) % n;
    concave_ |= turn((k + n - 1) % n, k, next).right();
    const double along = plane_[next].x - plane_[k].x;
    if (std::abs(along) <= rounding_) continue;
    if (along * last < 0) ++changes;
    last = along;
  }
  convex_ = !concave_ && changes <= 2;
}

bool LaidPolygon::is_fan() const {
  if (convex_) return true;
  double around = 0;
  for (std::size_t k = 2; k < plane_.size(); ++k) {
    if (turn(0, k - 1, k).right()) return false;
    const PlanePoint a = plane_[k - 1] - plane_[0], b = plane_[k] - plane_[0];
    around += std::atan2(std::abs(cross(a, b)), dot(a, b));
  }
  return around < 2 * std::numbers::pi;
}

/// Triangulates the polygons of the lists, and moves the corners of attributes with them.
class Triangulation {
 public:
  Triangulation(MeshLists& lists, MeshAttributes* attributes) : lists_(lists) {
    if (attributes == nullptr) return;
    for (CornerAttribute* of : {&attributes->texture, &attributes->normals}) {
      if (of->corners.size() == lists.triangles.size()) corners_.push_back(&of->corners);
    }
  }

  void run() {
    std::size_t more = 0;  // excess of triangles over faces of the file, so far
    for (const Polygon& polygon : lists_.polygons) {
      triangulate(polygon, static_cast<std::uint32_t>(polygon.first - more));
      more += polygon.corners - 3;
    }
  }

 private:
  void triangulate(const Polygon& polygon, std::uint32_t face) {
    const std::vector<std::uint32_t>& corners = corners_of(lists_.triangles, polygon);
    PolygonShapes& shapes = lists_.polygon_shapes;
    const bool laid = laid_.lay(lists_, corners);
    if (laid) measure(face);
    if (laid && laid_.is_fan()) return;
    const std::vector<PolygonTriangle> ears = laid ? laid_.ears() : std::vector<PolygonTriangle>();
    if (ears.empty()) {
      if (shapes.crossing++ == 0) shapes.crossing_face = face;
      return;
    }
    put(lists_.triangles, polygon, ears);
    for (auto* of : corners_) {
      corners_of(*of, polygon);
      put(*of, polygon, ears);
    }
  }

  void measure(std::uint32_t face) {
    PolygonShapes& shapes = lists_.polygon_shapes;
    if (laid_.concave()) ++shapes.concave;
    if (laid_.distance() > kPlane) ++shapes.not_plane;
    if (laid_.distance() > shapes.largest_distance) {
      shapes.largest_distance = laid_.distance();
      shapes.largest_face = face;
    }
  }

  /// The corners of a fan.
  template <class Corners>
  const std::vector<std::uint32_t>& corners_of(const Corners& fans, const Polygon& polygon) {
    around_.assign({fans[polygon.first][0], fans[polygon.first][1]});
    for (std::uint32_t k = 0; k + 2 < polygon.corners; ++k) {
      around_.push_back(fans[polygon.first + k][2]);
    }
    return around_;
  }

  template <class Corners>
  void put(Corners& to, const Polygon& polygon, const std::vector<PolygonTriangle>& ears) {
    for (std::size_t k = 0; k < ears.size(); ++k) {
      for (std::size_t c = 0; c < 3; ++c) to[polygon.first + k][c] = around_[ears[k][c]];
    }
  }

  MeshLists& lists_;
  std::vector<std::vector<std::array<std::uint32_t, 3>>*> corners_;  // of attributes
  LaidPolygon laid_;
  std::vector<std::uint32_t> around_;
};

}  // namespace

void triangulate_polygons(MeshLists& lists, MeshAttributes* attributes) {
  lists.polygon_shapes = {};
  Triangulation(lists, attributes).run();
}

void triangulate_polygons(MeshLists& lists) { triangulate_polygons(lists, nullptr); }

std::vector<PolygonCorner> outline(const std::vector<Triangle>& all,
                                   std::span<const std::uint32_t> triangles) {
  struct Side {
    std::uint32_t from, to;
    PolygonCorner at;
  };
  std::vector<Side> sides;
  for (const std::uint32_t f : triangles) {
    for (std::uint32_t k = 0; k < 3; ++k) sides.push_back({all[f][k], all[f][(k + 1) % 3], {f, k}});
  }
  const auto by_ends = [](const Side& a, const Side& b) {
    return std::pair{a.from, a.to} < std::pair{b.from, b.to};
  };
  std::sort(sides.begin(), sides.end(), by_ends);
  std::vector<Side> around;  // sides without an opposite side
  for (const Side& s : sides) {
    if (!std::binary_search(sides.begin(), sides.end(), Side{s.to, s.from, {}}, by_ends)) {
      around.push_back(s);
    }
  }
  if (triangles.empty() || around.size() != triangles.size() + 2) return {};
  const auto from = [&](std::uint32_t v) {
    const auto at = std::lower_bound(around.begin(), around.end(), Side{v, 0, {}}, by_ends);
    const bool once =
        at != around.end() && at->from == v && (at + 1 == around.end() || (at + 1)->from != v);
    return once ? at : around.end();
  };
  std::vector<PolygonCorner> corners;
  const std::uint32_t start = all[triangles[0]][0];
  for (std::uint32_t v = start; corners.size() <= around.size();) {
    const auto side = from(v);
    if (side == around.end()) return {};
    corners.push_back(side->at);
    v = side->to;
    if (v == start) break;
  }
  return corners.size() == around.size() ? corners : std::vector<PolygonCorner>();
}

}  // namespace talweg
