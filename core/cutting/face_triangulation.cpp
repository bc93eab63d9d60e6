#include "talweg/core/cutting/face_triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

using Place = FaceTriangulation::Place;

/// Twice a signed area, exactly: high times 2^21, plus low. Coordinates differ by at most 2^40, so
/// it has up to 82 bits; products of 21 and 40 bits fit into 64.
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

/// The third corner of the triangle on the left of the edge.
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
  }
}

void FaceTriangulation::add(const Corners& corners) {
  triangles_.emplace_back();
  set(static_cast<std::uint32_t>(triangles_.size() - 1), corners);
}

void FaceTriangulation::split_inside(std::uint32_t triangle, std::uint32_t p) {
  const auto [a, b, c] = triangles_[triangle];
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
    set(triangle, {u, p, w});
    add({p, v, w});
  }
}

std::uint32_t FaceTriangulation::insert(const Place& place) {
  const auto known = std::find(places_.begin(), places_.end(), place);
  if (known != places_.end()) return static_cast<std::uint32_t>(known - places_.begin());
  const auto p = static_cast<std::uint32_t>(places_.size());
  places_.push_back(place);
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    const Corners c = triangles_[t];
    const std::array<int, 3> sides = {side(c[0], c[1], p), side(c[1], c[2], p),
                                      side(c[2], c[0], p)};
    if (std::any_of(sides.begin(), sides.end(), [](int s) { return s < 0; })) continue;
    const auto on = std::find(sides.begin(), sides.end(), 0) - sides.begin();
    if (on == 3) {
      split_inside(t, p);
    } else {
      split_edge(c[static_cast<std::size_t>(on)], c[static_cast<std::size_t>(on + 1) % 3], p);
    }
    return p;
  }
  fail();  // outside
}

/// Whether the edge may be replaced by the other diagonal.
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
  triangle_of_.erase(directed(a, b));
  triangle_of_.erase(directed(b, a));
  set(left, {a, q, p});
  set(right, {q, b, p});
}

std::size_t FaceTriangulation::connect(std::uint32_t a, std::uint32_t b) {
  std::vector<std::uint32_t> way{a};
  connect_part(a, b, way);
  segments_.push_back(std::move(way));
  return segments_.size() - 1;
}

/// Appends the points after a, up to and including b.
void FaceTriangulation::connect_part(std::uint32_t a, std::uint32_t b,
                                     std::vector<std::uint32_t>& way) {
  if (a == b) return;
  if (has_edge(a, b)) {
    fixed_.try_emplace(undirected(a, b));
    way.push_back(b);
    return;
  }
  const auto over = [&](std::uint32_t c) {
    connect_part(a, c, way);
    connect_part(c, b, way);
  };
  // The segment leaves a through the triangle with u on its right and v on its left.
  std::uint32_t u = a, v = a;
  for (const Corners& c : triangles_) {
    const auto at = std::find(c.begin(), c.end(), a) - c.begin();
    if (at == 3) continue;
    const std::uint32_t right = c[static_cast<std::size_t>(at + 1) % 3];
    const std::uint32_t left = c[static_cast<std::size_t>(at + 2) % 3];
    const int of_right = side(a, b, right), of_left = side(a, b, left);
    if (of_right > 0 || of_left < 0 || (of_right == 0 && of_left == 0)) continue;
    if (of_right == 0) return over(right);
    if (of_left == 0) return over(left);
    u = right;
    v = left;
  }
  if (u == v) fail();
  std::vector<std::array<std::uint32_t, 2>> crossed;
  for (;;) {
    if (is_fixed(u, v)) return over(cross(a, b, u, v));
    crossed.push_back({u, v});
    const std::uint32_t w = opposite(v, u);
    const int of_w = w == b ? 0 : side(a, b, w);
    if (of_w == 0) {
      clear_way(a, w, std::move(crossed));
      fixed_.try_emplace(undirected(a, w));
      way.push_back(w);
      return connect_part(w, b, way);
    }
    (of_w > 0 ? v : u) = w;
  }
}

/// Splits an edge of another segment where the segment from a to b crosses it, and returns the new
/// point; returns one of the edge's ends if the lattice has no other place.
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
  if (std::find(places_.begin(), places_.end(), at) != places_.end()) return end;
  const auto x = static_cast<std::uint32_t>(places_.size());
  places_.push_back(at);
  for (const auto& [p, q] : {std::array{u, v}, std::array{v, u}}) {
    const std::uint32_t w = opposite(p, q);
    if (side(p, x, w) > 0 && side(x, q, w) > 0) continue;
    places_.pop_back();
    return end;
  }
  split_edge(u, v, x);
  return x;
}

/// Flips the edges that the segment from a to b crosses until it is an edge (S. W. Sloan, "A fast
/// algorithm for generating constrained Delaunay triangulations", 1993).
void FaceTriangulation::clear_way(std::uint32_t a, std::uint32_t b,
                                  std::vector<std::array<std::uint32_t, 2>> edges) {
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

PlanePoint FaceTriangulation::plane(std::uint32_t p) const {
  PlanePoint at{0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const double part = static_cast<double>(places_[p][k]) / static_cast<double>(kOne);
    at.x += part * corners_[k].x;
    at.y += part * corners_[k].y;
  }
  return at;
}

/// Whether the angles opposite the edge sum to more than half a turn.
bool FaceTriangulation::should_flip(std::uint32_t a, std::uint32_t b) const {
  const auto angle = [&](std::uint32_t at) {
    const PlanePoint o = plane(at), p = plane(a), q = plane(b);
    const double ux = p.x - o.x, uy = p.y - o.y, vx = q.x - o.x, vy = q.y - o.y;
    return std::abs(std::atan2(ux * vy - uy * vx, ux * vx + uy * vy));
  };
  constexpr double kHalfTurn = 3.14159265358979323846, kRounding = 1e-9;
  return angle(opposite(a, b)) + angle(opposite(b, a)) > kHalfTurn + kRounding;
}

void FaceTriangulation::improve() {
  bool changed = true;
  for (std::size_t round = 0; changed && round < triangles_.size() + 8; ++round) {
    changed = false;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = triangles_[t][k], b = triangles_[t][(k + 1) % 3];
        if (!can_flip(a, b) || !should_flip(a, b)) continue;
        flip(a, b);
        changed = true;
      }
    }
  }
}

std::vector<std::uint32_t> FaceTriangulation::chain(std::size_t segment) const {
  std::vector<std::uint32_t> chain{segments_[segment].front()};
  std::vector<std::array<std::uint32_t, 2>> open;  // the first is last
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
