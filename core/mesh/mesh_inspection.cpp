#include "talweg/core/mesh/mesh_inspection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <tuple>
#include <utility>

#include "talweg/core/mesh/face_dropping.hpp"
#include "talweg/core/mesh/measurable_point.hpp"
#include "talweg/core/mesh/mesh_sides.hpp"
#include "talweg/core/mesh/union_find.hpp"
#include "talweg/core/space/face_shape.hpp"
#include "talweg/core/space/point_distance.hpp"

namespace talweg {
namespace {

/// Per face, whether it has three different vertices that exist; other faces are recorded as
/// defects.
std::vector<bool> proper_faces(const MeshLists& lists, MeshInspection& found) {
  std::vector<bool> proper(lists.triangles.size(), true);
  for (std::size_t f = 0; f < lists.triangles.size(); ++f) {
    const Triangle& t = lists.triangles[f];
    const auto id = static_cast<std::uint32_t>(f);
    const auto outside =
        std::find_if(t.begin(), t.end(), [&](std::uint32_t v) { return v >= lists.points.size(); });
    if (outside != t.end()) {
      found.indices_out_of_range.add({id, *outside});
    } else if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
      found.repeated_vertex_faces.add(id);
    } else {
      continue;
    }
    proper[f] = false;
  }
  return proper;
}

/// Per vertex, whether a face uses it.
std::vector<bool> used_vertices(const MeshLists& lists) {
  std::vector<bool> used(lists.points.size(), false);
  for (const Triangle& t : lists.triangles) {
    for (const std::uint32_t v : t) {
      if (v < used.size()) used[v] = true;
    }
  }
  return used;
}

/// Counts components, boundary loops and non-manifold places by joining elements across edges.
class Topology {
 public:
  Topology(const MeshLists& lists, std::vector<bool> proper, MeshInspection& found)
      : lists_(lists),
        found_(found),
        proper_(std::move(proper)),
        faces_(lists.triangles.size()),
        corners_(3 * lists.triangles.size()),
        boundary_(lists.points.size()),
        turned_(2 * lists.triangles.size()) {}

  void run() {
    for_each_edge(sorted_sides(lists_, proper_),
                  [&](std::span<const FaceSide> edge) { visit(edge); });
    count();
  }

 private:
  void visit(std::span<const FaceSide> edge) {
    ++found_.edges;
    measure(edge[0]);
    if (edge.size() == 1) {
      ++found_.boundary_edges;
      boundary_.join(edge[0].low, edge[0].high);
      on_boundary_.push_back(edge[0].low);
    } else if (edge.size() > 2) {
      found_.non_manifold_edges.add(place_of(edge));
    } else {
      const bool same_way = tail(lists_, edge[0]) == tail(lists_, edge[1]);
      if (same_way) found_.misoriented_edges.add(place_of(edge));
      join_turned(edge[0].face(), edge[1].face(), same_way);
    }
    for (std::size_t i = 1; i < edge.size(); ++i) {
      faces_.join(edge[0].face(), edge[i].face());
      for (const std::uint32_t v : {edge[0].low, edge[0].high}) {
        corners_.join(corner_at(lists_, edge[0], v), corner_at(lists_, edge[i], v));
      }
    }
  }

  void measure(const FaceSide& edge) {
    const Point& p = lists_.points[edge.low];
    const Point& q = lists_.points[edge.high];
    if (!can_be_measured(p) || !can_be_measured(q)) return;
    const double length = point_distance(p, q);
    const bool first = measured_++ == 0;
    found_.edge_length_min = first ? length : std::min(found_.edge_length_min, length);
    found_.edge_length_max = std::max(found_.edge_length_max, length);
    double& least = found_.edge_length_least;
    if (length > 0 && !(least > 0 && least < length)) least = length;
    // A running mean, because a sum could leave the range of doubles.
    found_.edge_length_mean += (length - found_.edge_length_mean) / static_cast<double>(measured_);
  }

  /// Element 2f stands for face f with its orientation, 2f + 1 for face f turned around. Elements
  /// that imply each other are joined. A surface is one-sided if 2f and 2f + 1 are in one set.
  void join_turned(std::uint32_t f, std::uint32_t g, bool same_way) {
    const std::uint32_t turn = same_way ? 1 : 0;
    turned_.join(2 * f, 2 * g + turn);
    turned_.join(2 * f + 1, 2 * g + (1 - turn));
  }

  void count() {
    std::vector<std::uint32_t> fans(lists_.points.size(), 0);
    std::int64_t used_faces = 0;
    for (std::uint32_t f = 0; f < lists_.triangles.size(); ++f) {
      if (!proper_[f]) continue;
      ++used_faces;
      if (faces_.find(f) == f) ++found_.components;
      if (turned_.find(2 * f) == turned_.find(2 * f + 1)) found_.orientable = false;
      for (std::uint32_t k = 0; k < 3; ++k) {
        if (corners_.find(3 * f + k) == 3 * f + k) ++fans[lists_.triangles[f][k]];
      }
    }
    const std::vector<bool> used = used_vertices(lists_);
    std::int64_t in_topology = 0;
    for (std::uint32_t v = 0; v < lists_.points.size(); ++v) {
      if (!used[v]) found_.isolated_vertices.add(v);
      if (fans[v] > 0) ++in_topology;
      if (fans[v] > 1) found_.non_manifold_vertices.add(v);
    }
    // A connected set of boundary edges is counted at its smallest vertex.
    std::sort(on_boundary_.begin(), on_boundary_.end());
    on_boundary_.erase(std::unique(on_boundary_.begin(), on_boundary_.end()), on_boundary_.end());
    for (const std::uint32_t v : on_boundary_) {
      if (boundary_.find(v) == v) ++found_.boundary_loops;
    }
    found_.euler_characteristic =
        in_topology - static_cast<std::int64_t>(found_.edges) + used_faces;
    const auto closed = 2 * static_cast<std::int64_t>(found_.components) -
                        static_cast<std::int64_t>(found_.boundary_loops) -
                        found_.euler_characteristic;
    const bool manifold =
        !found_.non_manifold_edges.found() && !found_.non_manifold_vertices.found();
    if (manifold && found_.orientable && used_faces > 0) found_.genus = closed / 2;
  }

  const MeshLists& lists_;
  MeshInspection& found_;
  std::vector<bool> proper_;
  UnionFind faces_;
  UnionFind corners_;
  UnionFind boundary_;
  UnionFind turned_;
  std::size_t measured_ = 0;
  std::vector<std::uint32_t> on_boundary_;
};

void find_duplicate_positions(const MeshLists& lists, MeshInspection& found) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t v = 0; v < lists.points.size(); ++v) {
    if (can_be_measured(lists.points[v])) order.push_back(v);
  }
  const auto key = [&](std::uint32_t v) {
    const Point& p = lists.points[v];
    return std::tuple{p.x(), p.y(), p.z(), v};
  };
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  std::vector<RepeatPlace> repeats;
  for (std::size_t i = 1, earlier = 0; i < order.size(); ++i) {
    if (lists.points[order[i]] == lists.points[order[earlier]]) {
      repeats.push_back({order[i], order[earlier]});
    } else {
      earlier = i;
    }
  }
  std::sort(repeats.begin(), repeats.end(),
            [](const RepeatPlace& a, const RepeatPlace& b) { return a.element < b.element; });
  for (const RepeatPlace& place : repeats) found.duplicate_positions.add(place);
}

void measure_box(const MeshLists& lists, MeshInspection& found) {
  const std::vector<bool> used = used_vertices(lists);
  Point low = Point::Constant(std::numeric_limits<double>::infinity());
  Point high = -low;
  for (std::uint32_t v = 0; v < lists.points.size(); ++v) {
    const bool measurable = can_be_measured(lists.points[v]);
    if (!measurable && !used[v]) {
      found.stray_vertices.add(v);
      continue;
    }
    for (const double x : lists.points[v]) {
      if (std::abs(x) > found.coordinate_max) found.coordinate_max = std::abs(x);
    }
    if (!measurable) {
      found.non_finite_vertices.add(v);
      continue;
    }
    low = low.cwiseMin(lists.points[v]);
    high = high.cwiseMax(lists.points[v]);
  }
  if (!(low.x() <= high.x())) return;
  for (int k = 0; k < 3; ++k) {
    found.box_min[static_cast<std::size_t>(k)] = low[k];
    found.box_max[static_cast<std::size_t>(k)] = high[k];
  }
  found.size = (high - low).stableNorm();
  found.offset = (low / 2 + high / 2).stableNorm();
}

void measure_faces(const MeshLists& lists, const std::vector<bool>& proper, MeshInspection& found) {
  double smallest = std::numbers::pi;
  bool any = false;
  for (std::uint32_t f = 0; f < lists.triangles.size(); ++f) {
    if (!proper[f]) continue;
    const Triangle& t = lists.triangles[f];
    const std::array<Point, 3> p{lists.points[t[0]], lists.points[t[1]], lists.points[t[2]]};
    if (!can_be_measured(p[0]) || !can_be_measured(p[1]) || !can_be_measured(p[2])) continue;
    const FaceShape shape = shape_of(p);
    if (shape.flat || shape.smallest_angle < std::numbers::pi / 180) found.needle_faces.add(f);
    if (shape.flat) {
      found.zero_area_faces.add(f);
      continue;
    }
    smallest = std::min(smallest, shape.smallest_angle);
    any = true;
  }
  if (any) found.smallest_angle = smallest;
}

}  // namespace

MeshInspection inspect(const MeshLists& lists) {
  MeshInspection found;
  found.vertices = lists.points.size();
  found.faces = lists.triangles.size();
  found.polygons = lists.polygon_count;
  found.polygon_shapes = lists.polygon_shapes;
  found.single_precision = lists.single_precision;
  found.unit = lists.unit;
  found.space = lists.space;
  found.notes = lists.notes;
  const std::vector<bool> proper = proper_faces(lists, found);
  measure_box(lists, found);
  measure_faces(lists, proper, found);
  find_duplicate_positions(lists, found);
  for (const RepeatPlace& place : duplicate_faces(lists, proper)) found.duplicate_faces.add(place);
  Topology(lists, proper, found).run();
  judge(found);
  return found;
}

}  // namespace talweg
