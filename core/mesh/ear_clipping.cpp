#include "talweg/core/mesh/ear_clipping.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace talweg {
namespace {

constexpr std::size_t kStepsPerCorner = 1000;
constexpr std::uint32_t kFewInward = 8;

PlanePoint lower_of(PlanePoint p, PlanePoint q) { return {std::min(p.x, q.x), std::min(p.y, q.y)}; }
PlanePoint upper_of(PlanePoint p, PlanePoint q) { return {std::max(p.x, q.x), std::max(p.y, q.y)}; }
bool same_place(PlanePoint p, PlanePoint q) { return p.x == q.x && p.y == q.y; }

/// A tree of boxes around the corners that do not turn left. Corners leave the tree when they are
/// cut off or turn left.
class InwardTree {
 public:
  InwardTree(std::span<const PlanePoint> corners, std::vector<std::uint32_t> inward)
      : corners_(corners), inward_(std::move(inward)), place_(corners.size(), kNone) {
    if (!inward_.empty()) build(0, static_cast<std::uint32_t>(inward_.size()));
    for (std::uint32_t i = 0; i < inward_.size(); ++i) place_[inward_[i]] = i;
  }

  void leave(std::uint32_t corner) {
    const std::uint32_t place = place_[corner];
    if (place == kNone) return;
    place_[corner] = kNone;
    for (std::uint32_t id = 0;;) {
      --nodes_[id].count;
      if (nodes_[id].right == 0) return;
      id = place < nodes_[nodes_[id].right].begin ? id + 1 : nodes_[id].right;
    }
  }

  /// Whether `is_in` holds for any corner of the tree near the triangle; `steps` counts visited
  /// boxes and corners.
  template <class IsIn>
  bool any(const std::array<PlanePoint, 3>& triangle, const IsIn& is_in, std::size_t& steps) {
    if (nodes_.empty()) return false;
    open_.assign(1, 0);
    while (!open_.empty()) {
      const std::uint32_t id = open_.back();
      open_.pop_back();
      ++steps;
      const Node& node = nodes_[id];
      if (node.count == 0 || is_apart(node, triangle)) continue;
      if (node.right != 0) {
        open_.push_back(id + 1);
        open_.push_back(node.right);
        continue;
      }
      for (std::uint32_t i = node.begin; i < node.end; ++i) {
        if (place_[inward_[i]] == kNone) continue;
        ++steps;
        if (is_in(inward_[i])) return true;
      }
    }
    return false;
  }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  struct Node {
    PlanePoint low{}, high{};
    std::uint32_t begin = 0, end = 0;  // range of inward_
    std::uint32_t right = 0;           // the first child follows its parent; 0: no children
    std::uint32_t count = 0;           // of the corners still in the tree
  };

  std::uint32_t build(std::uint32_t begin, std::uint32_t end) {
    const auto id = static_cast<std::uint32_t>(nodes_.size());
    const PlanePoint& first = corners_[inward_[begin]];
    Node node{first, first, begin, end, 0, end - begin};
    for (std::uint32_t i = begin; i < end; ++i) {
      node.low = lower_of(node.low, corners_[inward_[i]]);
      node.high = upper_of(node.high, corners_[inward_[i]]);
    }
    nodes_.push_back(node);
    if (end - begin <= kFewInward) return id;
    const bool high = node.high.x - node.low.x < node.high.y - node.low.y;
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(inward_.begin() + begin, inward_.begin() + middle, inward_.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) {
                       const PlanePoint &p = corners_[a], &q = corners_[b];
                       return high ? p.y < q.y : p.x < q.x;
                     });
    build(begin, middle);
    const std::uint32_t right = build(middle, end);
    nodes_[id].right = right;
    return id;
  }

  /// Whether a side of the box or of the triangle separates box and triangle.
  static bool is_apart(const Node& node, const std::array<PlanePoint, 3>& t) {
    const PlanePoint low = lower_of(lower_of(t[0], t[1]), t[2]),
                     high = upper_of(upper_of(t[0], t[1]), t[2]);
    if (low.x > node.high.x + kMargin || low.y > node.high.y + kMargin) return true;
    if (high.x < node.low.x - kMargin || high.y < node.low.y - kMargin) return true;
    for (std::size_t k = 0; k < 3; ++k) {
      const PlanePoint along = t[(k + 1) % 3] - t[k];
      // The corner of the box that is farthest to the left of the side.
      const PlanePoint far{along.y > 0 ? node.low.x : node.high.x,
                           along.x > 0 ? node.high.y : node.low.y};
      if (cross(along, far - t[k]) < -kMargin) return true;
    }
    return false;
  }

  static constexpr double kMargin = 1e-12;  // rounding of coordinates about 1
  std::span<const PlanePoint> corners_;
  std::vector<std::uint32_t> inward_;
  std::vector<std::uint32_t> place_;  // per corner, its place in inward_
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> open_;
};

/// A candidate for an ear, with its neighbours at the time of queueing. The queue gives the
/// shortest cut first: cutting in the order of the corners would make fans of slivers with large
/// boxes.
struct Asked {
  double cut;
  std::uint32_t corner, before, next;
  friend bool operator>(const Asked& a, const Asked& b) {
    return std::pair{a.cut, a.corner} > std::pair{b.cut, b.corner};
  }
};

class EarClipper {
 public:
  EarClipper(std::span<const PlanePoint> corners, double rounding)
      : corners_(corners),
        rounding_(rounding),
        left_(corners.size()),
        next_(corners.size()),
        before_(corners.size()),
        is_cut_(corners.size(), false),
        inward_(corners, inward_corners()) {
    for (std::uint32_t i = 0; i < left_; ++i) {
      next_[i] = i + 1 < left_ ? i + 1 : 0;
      before_[next_[i]] = i;
    }
  }

  std::vector<PolygonTriangle> run() {
    while (left_ > 3) {
      if (steps_ > kStepsPerCorner * corners_.size()) return {};
      if (!cut_an_ear() && !ask_all() && !cut_flat()) return {};
    }
    const std::uint32_t last = last_cut_neighbour_;
    if (turn(last).right()) return {};
    triangles_.push_back({before_[last], last, next_[last]});
    return std::move(triangles_);
  }

 private:
  [[nodiscard]] TurnInPlane turn_of(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return {corners_[a], corners_[b], corners_[c], rounding_};
  }
  [[nodiscard]] TurnInPlane turn(std::uint32_t b) const { return turn_of(before_[b], b, next_[b]); }

  [[nodiscard]] std::vector<std::uint32_t> inward_corners() const {
    std::vector<std::uint32_t> result;
    const auto n = static_cast<std::uint32_t>(corners_.size());
    for (std::uint32_t b = 0; b < n; ++b) {
      if (!turn_of(b > 0 ? b - 1 : n - 1, b, b + 1 < n ? b + 1 : 0).left()) result.push_back(b);
    }
    return result;
  }

  /// Whether corner w prevents cutting off the triangle at b: w lies inside or on the triangle. A
  /// corner at the position of b prevents cutting only if the polygon continues from there into the
  /// triangle.
  [[nodiscard]] bool is_in_the_way(std::uint32_t w, std::uint32_t b) const {
    const std::uint32_t a = before_[b], c = next_[b];
    if (w == a || w == b || w == c) return false;
    const PlanePoint& p = corners_[w];
    if (same_place(p, corners_[b])) return leads_inside(w, b);
    if (same_place(p, corners_[a]) || same_place(p, corners_[c])) return false;
    return !turn_of(a, b, w).right() && !turn_of(b, c, w).right() && !turn_of(c, a, w).right();
  }
  [[nodiscard]] bool leads_inside(std::uint32_t w, std::uint32_t b) const {
    const auto inside = [&](std::uint32_t x) {
      return turn_of(before_[b], b, x).left() && turn_of(b, next_[b], x).left();
    };
    return inside(before_[w]) || inside(next_[w]);
  }

  [[nodiscard]] bool is_ear(std::uint32_t b) {
    ++steps_;
    if (!turn(b).left()) return false;
    const std::array<PlanePoint, 3> triangle{corners_[before_[b]], corners_[b], corners_[next_[b]]};
    return !inward_.any(
        triangle, [&](std::uint32_t w) { return is_in_the_way(w, b); }, steps_);
  }

  /// Queues every corner that turns left. Normally, after the first time, only the neighbours of a
  /// cut corner can become ears; rounding and corners at the same position break this rule, so all
  /// corners are queued again when no ear is found.
  bool ask_all() {
    if (asked_with_ == left_) return false;
    asked_with_ = left_;
    for (std::uint32_t b = 0; b < corners_.size(); ++b) {
      if (!is_cut_[b]) ask(b);
    }
    return true;
  }

  void ask(std::uint32_t b) {
    if (!turn(b).left()) return;
    const std::uint32_t a = before_[b], c = next_[b];
    asked_.push({norm(corners_[c] - corners_[a]), b, a, c});
  }

  bool cut_an_ear() {
    while (!asked_.empty()) {
      const Asked asked = asked_.top();
      asked_.pop();
      const std::uint32_t b = asked.corner;
      if (is_cut_[b] || before_[b] != asked.before || next_[b] != asked.next) continue;
      if (!is_ear(b)) continue;
      cut(b);
      return true;
    }
    return false;
  }

  /// Cuts off a corner on the line of its neighbours, when no ear is left.
  bool cut_flat() {
    for (std::uint32_t b = 0; b < corners_.size(); ++b) {
      ++steps_;
      if (is_cut_[b] || turn(b).left() || turn(b).right()) continue;
      cut(b);
      return true;
    }
    return false;
  }

  void cut(std::uint32_t b) {
    const std::uint32_t a = before_[b], c = next_[b];
    triangles_.push_back({a, b, c});
    is_cut_[b] = true;
    inward_.leave(b);
    next_[a] = c;
    before_[c] = a;
    --left_;
    last_cut_neighbour_ = c;
    for (const std::uint32_t v : {a, c}) {
      if (turn(v).left()) inward_.leave(v);
      ask(v);
    }
  }

  std::span<const PlanePoint> corners_;
  double rounding_;
  std::size_t left_;
  std::vector<std::uint32_t> next_, before_;
  std::vector<bool> is_cut_;
  InwardTree inward_;
  std::priority_queue<Asked, std::vector<Asked>, std::greater<>> asked_;
  std::vector<PolygonTriangle> triangles_;
  std::size_t asked_with_ = 0;
  std::size_t steps_ = 0;
  std::uint32_t last_cut_neighbour_ = 0;
};

/// Puts the triangle with the side from corner 0 to corner 1 first, beginning with these corners.
void begin_at_corner_0(std::vector<PolygonTriangle>& triangles) {
  for (PolygonTriangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (t[k] != 0 || t[(k + 1) % 3] != 1) continue;
      std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(k), t.end());
      std::swap(t, triangles.front());
      return;
    }
  }
}

}  // namespace

TurnInPlane::TurnInPlane(PlanePoint a, PlanePoint b, PlanePoint c, double rounding) {
  area = cross(b - a, c - a);
  error = rounding * (norm(b - a) + norm(c - a));
}

std::vector<PolygonTriangle> clip_ears(std::span<const PlanePoint> corners, double rounding) {
  std::vector<PolygonTriangle> triangles = EarClipper(corners, rounding).run();
  begin_at_corner_0(triangles);
  return triangles;
}

}  // namespace talweg
