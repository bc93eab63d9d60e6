#include "talweg/core/cutting/face_triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <numeric>
#include <queue>

#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

using Place = FaceTriangulation::Place;

/// Up to this number of points, places are found by linear search.
constexpr std::size_t kFew = 32;
constexpr std::uint32_t kNotThere = 0xFFFFFFFFU;
/// Beyond this number of points, the triangulation is made Delaunay around each new point at once,
/// which keeps the flips from growing as n². Fewer points are improved at the end only.
constexpr std::size_t kMany = 1024;

/// Twice a signed area, exact: high · 2^21 + low. Coordinates differ by at most 2^40, so the value
/// has up to 82 bits; products of 21 and 40 bits fit into 64.
struct Area {
  static constexpr int kShift = 21;
  std::int64_t high;
  std::int64_t low;  // in [0, 2^21)

  [[nodiscard]] int sign() const { return high != 0 ? (high > 0 ? 1 : -1) : (low > 0 ? 1 : 0); }
  [[nodiscard]] long double value() const {
    return std::ldexp(static_cast<long double>(high), kShift) + static_cast<long double>(low);
  }
};

Area area(const Place& a, const Place& b, const Place& c) {
  constexpr std::int64_t kLow = (std::int64_t{1} << Area::kShift) - 1;
  const std::int64_t ux = b[1] - a[1], uy = b[2] - a[2], vx = c[1] - a[1], vy = c[2] - a[2];
  const std::int64_t high = (ux >> Area::kShift) * vy - (uy >> Area::kShift) * vx;
  const std::int64_t low = (ux & kLow) * vy - (uy & kLow) * vx;
  return {high + (low >> Area::kShift), low & kLow};
}

[[noreturn]] void fail() {
  throw Error(ErrorCode::kNumerical, "A face could not be cut up along the curves in it.");
}

}  // namespace

FaceTriangulation::FaceTriangulation(const std::array<PlanePoint, 3>& corners)
    : corners_(corners), places_{{kOne, 0, 0}, {0, kOne, 0}, {0, 0, kOne}} {
  add({0, 1, 2});
}

int FaceTriangulation::side(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  return area(places_[a], places_[b], places_[c]).sign();
}

bool FaceTriangulation::has_edge(std::uint32_t a, std::uint32_t b) const {
  return triangle_of_.count(directed(a, b)) > 0 || triangle_of_.count(directed(b, a)) > 0;
}

/// The third corner of the triangle on the left of the edge from a to b.
std::uint32_t FaceTriangulation::opposite(std::uint32_t a, std::uint32_t b) const {
  for (const std::uint32_t c : triangles_[triangle_of_.at(directed(a, b))]) {
    if (c != a && c != b) return c;
  }
  fail();
}

void FaceTriangulation::set(std::uint32_t triangle, const Corners& corners) {
  triangles_[triangle] = corners;
  for (std::size_t k = 0; k < 3; ++k) {
    triangle_of_[directed(corners[k], corners[(k + 1) % 3])] = triangle;
    if (corners[k] >= corner_of_.size()) corner_of_.resize(corners[k] + std::size_t{1});
    corner_of_[corners[k]] = triangle;
  }
}

void FaceTriangulation::add(const Corners& corners) {
  triangles_.emplace_back();
  set(static_cast<std::uint32_t>(triangles_.size() - 1), corners);
}

void FaceTriangulation::split_inside(std::uint32_t triangle, std::uint32_t p) {
  const auto [a, b, c] = triangles_[triangle];
  const auto next = static_cast<std::uint32_t>(triangles_.size());
  if (has_history_) {
    history_.divide(triangle, {{triangle, {a, b, p}}, {next, {b, c, p}}, {next + 1, {c, a, p}}});
  }
  set(triangle, {a, b, p});
  add({b, c, p});
  add({c, a, p});
}

void FaceTriangulation::split_edge(std::uint32_t a, std::uint32_t b, std::uint32_t p) {
  if (const auto fixed = fixed_.find(undirected(a, b)); fixed != fixed_.end()) {
    fixed->second = {true, p};
    fixed_[undirected(a, p)];
    fixed_[undirected(p, b)];
  }
  for (const auto& [u, v] : {std::array{a, b}, std::array{b, a}}) {
    const auto found = triangle_of_.find(directed(u, v));
    if (found == triangle_of_.end()) continue;
    const std::uint32_t triangle = found->second, w = opposite(u, v);
    triangle_of_.erase(found);
    const auto next = static_cast<std::uint32_t>(triangles_.size());
    if (has_history_) history_.divide(triangle, {{triangle, {u, p, w}}, {next, {p, v, w}}});
    set(triangle, {u, p, w});
    add({p, v, w});
  }
}

/// The number of the point at a place, or kNotThere if there is none.
std::uint32_t FaceTriangulation::find(const Place& place) const {
  if (places_.size() > kFew) {
    const auto known = number_of_.find(place);
    return known == number_of_.end() ? kNotThere : known->second;
  }
  const auto known = std::find(places_.begin(), places_.end(), place);
  return known == places_.end() ? kNotThere : static_cast<std::uint32_t>(known - places_.begin());
}

void FaceTriangulation::remember(const Place& place) {
  places_.push_back(place);
  if (places_.size() <= kFew) return;
  for (std::size_t p = number_of_.size(); p < places_.size(); ++p) {
    number_of_.emplace(places_[p], static_cast<std::uint32_t>(p));
  }
}

std::array<int, 3> FaceTriangulation::sides(const Corners& c, std::uint32_t p) const {
  return {side(c[0], c[1], p), side(c[1], c[2], p), side(c[2], c[0], p)};
}

/// The triangle with a point; of two triangles at an edge, the smaller number.
std::uint32_t FaceTriangulation::triangle_at(std::uint32_t p) const {
  const auto holds = [&](const Corners& c) {
    const std::array<int, 3> s = sides(c, p);
    return s[0] >= 0 && s[1] >= 0 && s[2] >= 0;
  };
  if (!has_history_) {
    const auto found = std::find_if(triangles_.begin(), triangles_.end(), holds);
    if (found == triangles_.end()) fail();
    return static_cast<std::uint32_t>(found - triangles_.begin());
  }
  // Consecutive points are often near each other, so the search starts at the previous point.
  std::uint32_t t = corner_of_.back();
  if (!holds(triangles_[t])) t = history_.at(holds);
  const Corners& c = triangles_[t];
  if (!holds(c)) fail();  // outside
  const std::array<int, 3> s = sides(c, p);
  for (std::size_t k = 0; k < 3; ++k) {
    if (s[k] != 0) continue;
    const auto other = triangle_of_.find(directed(c[(k + 1) % 3], c[k]));
    if (other != triangle_of_.end()) t = std::min(t, other->second);
  }
  return t;
}

std::uint32_t FaceTriangulation::insert(const Place& place) {
  if (const std::uint32_t known = find(place); known != kNotThere) return known;
  const auto p = static_cast<std::uint32_t>(places_.size());
  remember(place);
  const std::uint32_t t = triangle_at(p);
  const Corners c = triangles_[t];
  const std::array<int, 3> s = sides(c, p);
  const auto on = static_cast<std::size_t>(std::find(s.begin(), s.end(), 0) - s.begin());
  if (on == 3) {
    split_inside(t, p);
  } else {
    split_edge(c[on], c[(on + 1) % 3], p);
  }
  if (has_history_ && places_.size() > kMany) {
    if (places_.size() == kMany + 1) improve();
    improve_around(p);
  }
  return p;
}

/// Whether the edge can be replaced by the other diagonal of its two triangles.
bool FaceTriangulation::can_flip(std::uint32_t a, std::uint32_t b) const {
  if (is_fixed(a, b) || triangle_of_.count(directed(a, b)) == 0 ||
      triangle_of_.count(directed(b, a)) == 0) {
    return false;
  }
  const std::uint32_t p = opposite(a, b), q = opposite(b, a);
  return side(a, q, p) > 0 && side(q, b, p) > 0;
}

void FaceTriangulation::flip(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t p = opposite(a, b), q = opposite(b, a);
  const std::uint32_t left = triangle_of_.at(directed(a, b));
  const std::uint32_t right = triangle_of_.at(directed(b, a));
  if (has_history_) history_.flip({left, {a, q, p}}, {right, {q, b, p}});
  triangle_of_.erase(directed(a, b));
  triangle_of_.erase(directed(b, a));
  set(left, {a, q, p});
  set(right, {q, b, p});
}

/// Flips edges opposite to a point until all are Delaunay (C. Lawson, "Software for C1 surface
/// interpolation", 1977).
void FaceTriangulation::improve_around(std::uint32_t p) {
  std::vector<std::array<std::uint32_t, 2>> open;
  const std::uint32_t first = corner_of_[p];
  for (const bool ccw : {true, false}) {
    std::uint32_t t = first;
    do {
      const Corners& c = triangles_[t];
      const auto at = static_cast<std::size_t>(std::find(c.begin(), c.end(), p) - c.begin());
      const std::uint32_t right = c[(at + 1) % 3], left = c[(at + 2) % 3];
      open.push_back({right, left});
      const auto next = triangle_of_.find(ccw ? directed(p, left) : directed(right, p));
      if (next == triangle_of_.end()) break;
      t = next->second;
    } while (t != first);
    if (t == first && open.size() > 1) break;  // p is inside
  }
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    if (!can_flip(a, b) || opposite(a, b) != p || !should_flip(a, b)) continue;
    const std::uint32_t q = opposite(b, a);
    flip(a, b);
    open.push_back({a, q});
    open.push_back({q, b});
  }
}

std::size_t FaceTriangulation::connect(std::uint32_t a, std::uint32_t b) {
  if (has_history_) history_.forget();
  has_history_ = false;
  std::vector<std::uint32_t> way{a};
  // A stack of points to reach, the next on top; recursion could be too deep for a segment across
  // thousands of edges.
  std::vector<std::uint32_t> ahead{b};
  while (!ahead.empty()) {
    if (way.back() != ahead.back()) {
      const std::uint32_t next = step(way.back(), ahead.back());
      if (has_edge(way.back(), next)) {
        fixed_.try_emplace(undirected(way.back(), next));
        way.push_back(next);
      } else {
        ahead.push_back(next);
      }
    }
    if (way.back() == ahead.back()) ahead.pop_back();
  }
  segments_.push_back(std::move(way));
  return segments_.size() - 1;
}

/// The edge through which the segment from a to b leaves the triangles at a, its right end first.
/// If the segment passes through a point there, the result is this point twice.
std::array<std::uint32_t, 2> FaceTriangulation::leaving(std::uint32_t a, std::uint32_t b) const {
  const std::uint32_t first = corner_of_[a];
  for (const bool ccw :
       {true, false}) {  // the clockwise turn is needed for a on a side of the face
    std::uint32_t t = first;
    do {
      const Corners& c = triangles_[t];
      const auto at = static_cast<std::size_t>(std::find(c.begin(), c.end(), a) - c.begin());
      const std::uint32_t right = c[(at + 1) % 3], left = c[(at + 2) % 3];
      const int of_right = side(a, b, right), of_left = side(a, b, left);
      if (of_right <= 0 && of_left >= 0 && of_right != of_left) {
        if (of_right == 0) return {right, right};
        if (of_left == 0) return {left, left};
        return {right, left};
      }
      const auto next = triangle_of_.find(ccw ? directed(a, left) : directed(right, a));
      if (next == triangle_of_.end()) break;
      t = next->second;
    } while (t != first);
  }
  fail();
}

/// Goes one step from a towards b. Returns a point of the segment that an edge from a reaches; if
/// the result is not a neighbour of a, it must be reached first.
std::uint32_t FaceTriangulation::step(std::uint32_t a, std::uint32_t b) {
  if (has_edge(a, b)) return b;
  auto [u, v] = leaving(a, b);
  if (u == v) return u;
  Edges crossed;
  for (;;) {
    if (is_fixed(u, v)) return cross(a, b, u, v);
    crossed.push_back({u, v});
    const std::uint32_t w = opposite(v, u);
    const int of_w = w == b ? 0 : side(a, b, w);
    if (of_w == 0) {
      clear_way(a, w, crossed);
      return w;
    }
    (of_w > 0 ? v : u) = w;
  }
}

/// Splits the edge from u to v, which belongs to another segment, at its crossing with the segment
/// from a to b. Returns the new point, or an end of the edge if the lattice has no place between.
std::uint32_t FaceTriangulation::cross(std::uint32_t a, std::uint32_t b, std::uint32_t u,
                                       std::uint32_t v) {
  const long double right = area(places_[a], places_[b], places_[u]).value();
  const long double left = area(places_[a], places_[b], places_[v]).value();
  const long double part = right / (right - left);
  Place at{};
  for (const std::size_t k : {1U, 2U}) {
    const auto way = static_cast<long double>(places_[v][k] - places_[u][k]);
    at[k] = places_[u][k] + std::llroundl(part * way);
  }
  at[0] = kOne - at[1] - at[2];
  const std::uint32_t end = part < 0.5L ? u : v;
  if (find(at) != kNotThere) return end;
  const auto x = static_cast<std::uint32_t>(places_.size());
  remember(at);
  for (const auto& [p, q] : {std::array{u, v}, std::array{v, u}}) {
    const std::uint32_t w = opposite(p, q);
    if (side(p, x, w) > 0 && side(x, q, w) > 0) continue;
    number_of_.erase(at);
    places_.pop_back();
    return end;
  }
  split_edge(u, v, x);
  return x;
}

/// Flips the edges that the segment from a to b crosses until the segment is an edge (S. W. Sloan,
/// "A fast algorithm for generating constrained Delaunay triangulations", 1993). For n crossed
/// edges this may take n² flips, so many edges are handled by refill().
void FaceTriangulation::clear_way(std::uint32_t a, std::uint32_t b, const Edges& edges) {
  constexpr std::size_t kManyEdges = 64;
  if (edges.size() > kManyEdges) {
    refill(a, b, edges);
    return;
  }
  std::deque<std::array<std::uint32_t, 2>> crossed(edges.begin(), edges.end());
  std::size_t left = 64 * (crossed.size() + 4) * (crossed.size() + 4);
  for (; !crossed.empty(); --left) {
    if (left == 0) fail();
    const auto [u, v] = crossed.front();
    crossed.pop_front();
    if (!can_flip(u, v)) {
      crossed.push_back({u, v});
      continue;
    }
    const std::uint32_t p = opposite(u, v), q = opposite(v, u);
    flip(u, v);
    if (side(a, b, p) * side(a, b, q) < 0) crossed.push_back({p, q});
  }
}

/// Removes the triangles that the segment from a to b crosses, and triangulates the hole on both
/// sides of the segment.
void FaceTriangulation::refill(std::uint32_t a, std::uint32_t b, const Edges& edges) {
  std::vector<std::uint32_t> free{triangle_of_.at(directed(edges[0][0], edges[0][1]))};
  std::vector<std::uint32_t> left{a}, right{a};
  for (const auto& [u, v] : edges) {
    free.push_back(triangle_of_.at(directed(v, u)));
    if (right.back() != u) right.push_back(u);
    if (left.back() != v) left.push_back(v);
  }
  left.push_back(b);
  right.push_back(b);
  for (const auto& [u, v] : edges) {
    triangle_of_.erase(directed(u, v));
    triangle_of_.erase(directed(v, u));
  }
  fixed_.try_emplace(undirected(a, b));
  Edges made;
  fill(left, true, free, made);
  fill(right, false, free, made);
  if (!free.empty()) fail();
  improve(std::move(made));
}

/// Triangulates the polygon between a chain and the segment between its ends, by the three coins
/// algorithm for weakly edge-visible polygons (G. Toussaint and D. Avis, "On a convex hull
/// algorithm for polygons and its application to triangulation problems", 1982). Takes triangle
/// numbers from `free`, appends new edges to `made`.
void FaceTriangulation::fill(const std::vector<std::uint32_t>& chain, bool on_left,
                             std::vector<std::uint32_t>& free, Edges& made) {
  std::vector<std::uint32_t> open;
  for (const std::uint32_t w : chain) {
    while (open.size() > 1) {
      const std::uint32_t p = open[open.size() - 2], q = open.back();
      const int turn = side(p, q, w);
      if (on_left ? turn >= 0 : turn <= 0) break;
      if (free.empty()) fail();
      set(free.back(), on_left ? Corners{w, q, p} : Corners{p, q, w});
      free.pop_back();
      open.pop_back();
      made.push_back({p, w});
    }
    open.push_back(w);
  }
  if (open.size() != 2) fail();
}

/// Flips the given edges, and edges around flipped ones, until all are Delaunay.
void FaceTriangulation::improve(Edges open) {
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    if (!can_flip(a, b) || !should_flip(a, b)) continue;
    const std::uint32_t p = opposite(a, b), q = opposite(b, a);
    flip(a, b);
    for (const std::uint32_t end : {a, b}) {
      open.push_back({end, p});
      open.push_back({end, q});
    }
  }
}

PlanePoint FaceTriangulation::plane(std::uint32_t p) const {
  PlanePoint at{0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const double part = static_cast<double>(places_[p][k]) / static_cast<double>(kOne);
    at.x += part * corners_[k].x;
    at.y += part * corners_[k].y;
  }
  return at;
}

/// The neighbours of a triangle; the triangle itself at a side of the face.
FaceTriangulation::Corners FaceTriangulation::neighbours(std::uint32_t triangle) const {
  const Corners& c = triangles_[triangle];
  Corners beside = {triangle, triangle, triangle};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto other = triangle_of_.find(directed(c[(k + 1) % 3], c[k]));
    if (other != triangle_of_.end()) beside[k] = other->second;
  }
  return beside;
}

/// Whether the edge is not Delaunay: the angles opposite to it sum to more than pi.
bool FaceTriangulation::should_flip(std::uint32_t a, std::uint32_t b) const {
  const auto angle = [&](std::uint32_t at) {
    const PlanePoint o = plane(at), p = plane(a), q = plane(b);
    const double ux = p.x - o.x, uy = p.y - o.y, vx = q.x - o.x, vy = q.y - o.y;
    return std::abs(std::atan2(ux * vy - uy * vx, ux * vx + uy * vy));
  };
  constexpr double kHalfTurn = 3.14159265358979323846, kRounding = 1e-9;
  return angle(opposite(a, b)) + angle(opposite(b, a)) > kHalfTurn + kRounding;
}

/// Visits the triangles by number in rounds. A round visits only triangles where something has
/// changed since the last visit.
void FaceTriangulation::improve() {
  using Waiting = std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, std::greater<>>;
  std::vector<std::uint32_t> all(triangles_.size());
  std::iota(all.begin(), all.end(), 0U);
  Waiting now(std::greater<>(), std::move(all)), later;
  std::vector<bool> is_in_now(triangles_.size(), true), is_in_later(triangles_.size(), false);
  const auto has_changed = [&](std::uint32_t t, std::uint32_t looked_at) {
    std::vector<bool>& is_in = t > looked_at ? is_in_now : is_in_later;
    if (is_in[t]) return;
    is_in[t] = true;
    (t > looked_at ? now : later).push(t);
  };
  for (std::size_t round = 0; !now.empty() && round < triangles_.size() + 8; ++round) {
    while (!now.empty()) {
      const std::uint32_t t = now.top();
      now.pop();
      is_in_now[t] = false;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = triangles_[t][k], b = triangles_[t][(k + 1) % 3];
        if (!can_flip(a, b) || !should_flip(a, b)) continue;
        const std::array<std::uint32_t, 2> pair = {triangle_of_.at(directed(a, b)),
                                                   triangle_of_.at(directed(b, a))};
        flip(a, b);
        for (const std::uint32_t changed : pair) {
          has_changed(changed, t);
          for (const std::uint32_t beside : neighbours(changed)) has_changed(beside, t);
        }
      }
    }
    std::swap(now, later);
    std::swap(is_in_now, is_in_later);
  }
}

std::vector<std::uint32_t> FaceTriangulation::chain(std::size_t segment) const {
  std::vector<std::uint32_t> chain{segments_[segment].front()};
  std::vector<std::array<std::uint32_t, 2>> open;  // a stack: the first part is on top
  const std::vector<std::uint32_t>& way = segments_[segment];
  for (std::size_t i = way.size() - 1; i > 0; --i) open.push_back({way[i - 1], way[i]});
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    const Fixed& edge = fixed_.at(undirected(a, b));
    if (edge.is_split) {
      open.push_back({edge.at, b});
      open.push_back({a, edge.at});
    } else {
      chain.push_back(b);
    }
  }
  return chain;
}

}  // namespace talweg
