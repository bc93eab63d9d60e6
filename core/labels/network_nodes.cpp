#include "talweg/core/labels/network_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "talweg/core/mesh/border_points.hpp"

namespace talweg {
namespace {

constexpr double kOfGap = 0.25;     // largest move, times the distance to the nearest node
constexpr double kNear = 0.05;      // times the reach: nearer points give no direction
constexpr double kBent = 0.15;      // sine of the angle where a straight stretch ends
constexpr double kBalanced = 0.01;  // times the number of borders: smaller sums count as balanced
constexpr double kStandsStill = 0.01;  // times the reach: smaller moves are not made
constexpr double kSurroundings = 1.5;  // radius around a node's drawn place, times its move

/// The two halfedges that leave a vertex along the boundary.
std::array<HalfedgeId, 2> along_boundary_from(const Surface& surface, VertexId v) {
  HalfedgeId last = surface.halfedge(v);
  while (surface.has_face(last)) last = surface.turn_ccw(last);
  return {surface.halfedge(v), last};
}

Point normal_at(const SurfaceMesh& mesh, const SurfacePoint& p) {
  Point normal = Point::Zero();
  for (const FaceId f : faces_at(mesh.surface(), p)) {
    const auto c = mesh.surface().corners(f);
    const Point& a = mesh.point(c[0]);
    normal += (mesh.point(c[1]) - a).cross(mesh.point(c[2]) - a);
  }
  return normal.norm() > 0 ? Point(normal.normalized()) : normal;
}

}  // namespace

NetworkNodes::NetworkNodes(const SurfaceMesh& mesh, std::span<const LabelBorder> drawn,
                           std::span<const double> tolerance, const Rules& rules)
    : mesh_(&mesh),
      drawn_(drawn),
      node_of_(drawn.size(), {kNone, kNone}),
      closest_(mesh),
      lines_(mesh.surface()) {
  collect();
  for (Node& node : nodes_) {
    for (const End& end : node.ends) node.reach = std::min(node.reach, tolerance[end.border]);
  }
  limit_reach();
  for (Node& node : nodes_) {
    const bool hung_on = std::any_of(node.ends.begin(), node.ends.end(), [&](const End& end) {
      return drawn_[end.border].curve.closed;
    });
    node.free = node.reach > 0 && !hung_on && (node.on_boundary ? rules.ends : rules.junctions);
  }
}

void NetworkNodes::collect() {
  // Ends lie at vertices, midpoints or centroids, so equal ends are on the same element of the
  // mesh.
  std::map<SurfaceElement, std::size_t> numbers;
  const auto add = [&](std::size_t border, bool front, const SurfacePoint& p) {
    const auto [found, is_new] = numbers.emplace(element_of(p), nodes_.size());
    if (is_new)
      nodes_.push_back({p, p, is_on_boundary(mesh_->surface(), p), false, HUGE_VAL, {}, {}, {}});
    nodes_[found->second].ends.push_back({border, front});
    node_of_[border][front ? 0 : 1] = found->second;
  };
  for (std::size_t c = 0; c < drawn_.size(); ++c) {
    const SurfaceCurve& curve = drawn_[c].curve;
    if (curve.closed && drawn_[c].fixed.empty()) continue;
    add(c, true, curve.points.front());
    add(c, false, curve.closed ? curve.points.front() : curve.points.back());
  }
}

/// Limits the reach of nodes so that two moving nodes cannot meet.
void NetworkNodes::limit_reach() {
  std::vector<Point> at;
  for (const Node& node : nodes_) at.push_back(mesh_->position(node.home));
  std::vector<std::size_t> order(nodes_.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return at[a].x() < at[b].x(); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t k = i + 1; k < order.size(); ++k) {
      Node& a = nodes_[order[i]];
      Node& b = nodes_[order[k]];
      const double ahead = at[order[k]].x() - at[order[i]].x();
      if (kOfGap * ahead > 4 * a.reach) break;
      const double most = kOfGap * (at[order[k]] - at[order[i]]).norm();
      a.reach = std::min(a.reach, most);
      b.reach = std::min(b.reach, most);
    }
  }
}

NetworkNodes::Pull NetworkNodes::pull_at(const Node& node,
                                         std::span<const SurfaceCurve> results) const {
  const Point at = mesh_->position(node.at);
  Pull pull;
  double inverse = 0;
  for (const End& end : node.ends) {
    const SurfaceCurve& curve = results[end.border];
    const std::size_t n = curve.points.size();
    std::size_t start = end.front ? 0 : n - 1;
    if (curve.closed) {
      const auto found = std::find(curve.points.begin(), curve.points.end(), node.at);
      start =
          found == curve.points.end() ? 0 : static_cast<std::size_t>(found - curve.points.begin());
    }
    Point direction = Point::Zero();
    double straight = node.reach / 4;
    for (std::size_t i = 1; i < n; ++i) {
      const std::size_t index = end.front ? (start + i) % n : (start + n - i) % n;
      const Point way = mesh_->position(curve.points[index]) - at;
      const double length = way.norm();
      if (direction.isZero()) {
        if (length < kNear * node.reach && i + 1 < n) continue;
        if (length > 0) direction = way / length;
      } else if (direction.cross(way).norm() > kBent * length || direction.dot(way) < 0) {
        break;
      }
      straight = std::max(straight, length);
    }
    pull.sum += direction;
    inverse += 1 / straight;
  }
  if (node.on_boundary) {
    pull.sum = along_boundary(node.at, pull.sum);
    pull.step = 1 / inverse;
  } else {
    const Point normal = normal_at(*mesh_, node.at);
    pull.sum -= normal * normal.dot(pull.sum);
    pull.step = 2 / inverse;
  }
  return pull;
}

/// The component of a pull along the boundary; at a vertex, along the boundary edge with the larger
/// component.
Point NetworkNodes::along_boundary(const SurfacePoint& at, const Point& pull) const {
  const Surface& surface = mesh_->surface();
  const auto part = [&](HalfedgeId h) -> Point {
    const Point way = (mesh_->point(surface.head(h)) - mesh_->point(surface.tail(h)));
    return way.norm() > 0 ? Point(way * (way.dot(pull) / way.squaredNorm())) : Point::Zero();
  };
  if (const auto* e = std::get_if<OnEdge>(&at.where())) return part(halfedge_of(e->edge));
  Point best = Point::Zero();
  for (const HalfedgeId h : along_boundary_from(surface, std::get<AtVertex>(at.where()).vertex)) {
    const Point along = part(h);
    if (along.dot(mesh_->point(surface.head(h)) - mesh_->point(surface.tail(h))) > 0 &&
        along.norm() > best.norm()) {
      best = along;
    }
  }
  return best;
}

/// The point at the length of the step along the boundary, in the direction of the step.
SurfacePoint NetworkNodes::slid(const SurfacePoint& at, const Point& step) const {
  const Surface& surface = mesh_->surface();
  double left = step.norm();
  const auto towards = [&](HalfedgeId h) {
    return step.dot(mesh_->point(surface.head(h)) - mesh_->point(surface.tail(h)));
  };
  HalfedgeId h;     // the boundary edge to follow
  double done = 0;  // fraction of h passed
  if (const auto* e = std::get_if<OnEdge>(&at.where())) {
    h = halfedge_of(e->edge);
    done = e->t;
    if (towards(h) < 0) {
      h = twin(h);
      done = 1 - done;
    }
  } else {
    const auto ways = along_boundary_from(surface, std::get<AtVertex>(at.where()).vertex);
    h = towards(ways[0]) >= towards(ways[1]) ? ways[0] : ways[1];
  }
  for (int edges = 0; edges < 64; ++edges) {
    const double length = surface.length(edge_of(h));
    const double end = length > 0 ? done + left / length : 1;
    if (end < 1) {
      const double t = halfedge_of(edge_of(h)) == h ? end : 1 - end;
      if (t > 0 && t < 1) return SurfacePoint::on_edge(surface, edge_of(h), t);
      return SurfacePoint::at_vertex(surface, surface.tail(h));
    }
    left -= (1 - done) * length;
    done = 0;
    const auto ways = along_boundary_from(surface, surface.head(h));
    h = edge_of(ways[0]) == edge_of(h) ? ways[1] : ways[0];
  }
  return SurfacePoint::at_vertex(surface, surface.tail(h));
}

SurfacePoint NetworkNodes::moved(const Node& node, Point step) const {
  const Point home = mesh_->position(node.home), at = mesh_->position(node.at);
  const auto is_near = [&](const SurfacePoint& p) {
    return (mesh_->position(p) - home).norm() <= node.reach * (1 + 1e-9);
  };
  if (node.on_boundary) {
    for (int tries = 0; tries < 4; ++tries, step /= 2) {
      const SurfacePoint there = slid(node.at, step);
      if (is_near(there)) return there;
    }
    return node.at;
  }
  Point target = at + step;
  if ((target - home).norm() > 0.99 * node.reach) {
    target = home + (target - home).normalized() * 0.99 * node.reach;
  }
  const SurfacePoint there = closest_.nearest(target).point;
  const bool stays = !is_near(there) || is_on_boundary(mesh_->surface(), there);
  return stays ? node.at : there;
}

std::vector<std::size_t> NetworkNodes::step(std::span<const SurfaceCurve> results) {
  std::vector<std::size_t> changed;
  for (Node& node : nodes_) {
    if (!node.free) continue;
    const Pull pull = pull_at(node, results);
    if (pull.sum.norm() < kBalanced * static_cast<double>(node.ends.size())) continue;
    double factor = pull.step;
    if (node.step) {  // Barzilai and Borwein's step, within a factor of 4 of pull.step
      const double fall = node.step->dot(*node.pull - pull.sum);
      if (fall > 0) factor = std::clamp(node.step->squaredNorm() / fall, factor / 4, factor * 4);
    }
    Point step = factor * pull.sum;
    if (step.norm() > node.reach / 2) step *= node.reach / 2 / step.norm();
    const SurfacePoint there = moved(node, step);
    step = mesh_->position(there) - mesh_->position(node.at);
    if (step.norm() < kStandsStill * node.reach) continue;
    node.step = step;
    node.pull = pull.sum;
    node.at = there;
    for (const End& end : node.ends) changed.push_back(end.border);
  }
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  return changed;
}

std::vector<std::size_t> NetworkNodes::hold(std::span<const std::size_t> borders) {
  std::vector<std::size_t> changed;
  for (const std::size_t c : borders) {
    for (const std::size_t number : node_of_[c]) {
      if (number == kNone) continue;
      Node& node = nodes_[number];
      node.free = false;
      if (node.at == node.home) continue;
      node.at = node.home;
      for (const End& end : node.ends) changed.push_back(end.border);
    }
  }
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  return changed;
}

bool NetworkNodes::is_moved(std::size_t border) const {
  return std::any_of(node_of_[border].begin(), node_of_[border].end(), [&](std::size_t number) {
    return number != kNone && !(nodes_[number].at == nodes_[number].home);
  });
}

std::size_t NetworkNodes::moved_count() const {
  return static_cast<std::size_t>(std::count_if(
      nodes_.begin(), nodes_.end(), [](const Node& node) { return !(node.at == node.home); }));
}

double NetworkNodes::imbalance(std::span<const SurfaceCurve> results) const {
  double sum = 0, count = 0;
  for (const Node& node : nodes_) {
    if (!node.free) continue;
    sum += pull_at(node, results).sum.norm();
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

NetworkNodes::Redrawing NetworkNodes::redrawn(std::size_t border) {
  const LabelBorder& drawn = drawn_[border];
  std::vector<SurfacePoint> points = drawn.curve.points;
  if (drawn.curve.closed) points.push_back(points.front());
  const std::size_t n = points.size();
  // The points [first, last) of the drawing stay.
  std::size_t first = 0, last = n;
  const auto outside = [&](const Node& node, std::size_t i) {
    const Point home = mesh_->position(node.home);
    const double radius = kSurroundings * (mesh_->position(node.at) - home).norm();
    return (mesh_->position(points[i]) - home).norm() > radius;
  };
  const Node& front = node_of(border, true);
  const Node& back = node_of(border, false);
  if (!(front.at == front.home)) {
    for (first = n / 2; first > 1 && outside(front, first - 1);) --first;
  }
  if (!(back.at == back.home)) {
    for (last = std::max(n / 2, first); last + 1 < n && outside(back, last);) ++last;
  }
  Redrawing result{{drawn.labels, {drawn.curve.closed, {}}, {}}, {}};
  std::vector<SurfacePoint>& path = result.border.curve.points;
  const auto add = [&](const SurfacePoint& p, std::size_t as) {
    path.push_back(p);
    result.from.push_back(as % drawn.curve.points.size());
  };
  const auto lead = [&](const SurfacePoint& to, std::size_t as) {
    if (path.back() == to) return;
    const std::array<SurfacePoint, 2> ends = {path.back(), to};
    const SurfaceCurve line = lines_.join(ends, false);
    for (std::size_t i = 1; i < line.points.size(); ++i) add(line.points[i], as);
  };
  if (first > 0) {
    add(front.at, std::min(first, n - 1));
    if (first < last) lead(points[first], first);
  } else {
    add(points.front(), 0);
  }
  for (std::size_t i = first + 1; i < last; ++i) add(points[i], i);
  if (last < n) {
    lead(back.at, last - 1);
  }
  if (drawn.curve.closed) {
    path.pop_back();
    result.from.pop_back();
    result.border.fixed = {front.at};
  }
  return result;
}

}  // namespace talweg
