#include "talweg/intrinsic/exact_distance/marched_distance.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <stdexcept>
#include <utility>

namespace talweg {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Two corners of a face: their distances, the length of the side between them, and the lengths of
/// the sides to the third corner.
struct Base {
  double left, right, width, to_left, to_right;
};

/// The distance of the third corner from the virtual source, the point below the base that has both
/// distances. Infinite if there is no such point, or if the straight line from the source to the
/// corner does not cross the base.
double across(const Base& b) {
  const auto height_at = [](double x, double hypotenuse) {
    return std::sqrt(std::max(0.0, hypotenuse * hypotenuse - x * x));
  };
  const auto foot = [&](double from_left, double from_right) {
    return (b.width * b.width + from_left * from_left - from_right * from_right) / (2 * b.width);
  };
  if (!(b.width > 0) || b.left + b.right < b.width) return kInfinite;
  const double source_x = foot(b.left, b.right);
  const double source_y = -height_at(source_x, b.left);
  const double corner_x = foot(b.to_left, b.to_right);
  const double corner_y = height_at(corner_x, b.to_left);
  if (!(corner_y > source_y)) return kInfinite;
  const double t = -source_y / (corner_y - source_y);
  const double crossing = source_x + t * (corner_x - source_x);
  if (crossing < 0 || crossing > b.width) return kInfinite;
  return std::hypot(corner_x - source_x, corner_y - source_y);
}

class March {
 public:
  March(const Surface& surface, std::vector<double>& distance)
      : surface_(surface),
        distance_(distance),
        known_(distance.size(), false),
        passed_(distance.size(), false) {
    for (std::size_t v = 0; v < distance.size(); ++v) {
      if (std::isfinite(distance[v])) {
        known_[v] = true;
        front_.push({distance[v], v});
      }
    }
  }

  void run(ProgressPoller& poller) {
    std::size_t count = 0;
    while (!front_.empty()) {
      const auto [value, v] = front_.top();
      front_.pop();
      if (passed_[v] || value > distance_[v]) continue;
      passed_[v] = true;
      poller.set_fraction(static_cast<double>(++count) / static_cast<double>(distance_.size()));
      poller.add_work(1);
      go_on_from(VertexId{v});
    }
  }

 private:
  /// Updates the faces around a vertex.
  void go_on_from(VertexId v) {
    const HalfedgeId first = surface_.halfedge(v);
    if (!first.valid()) return;
    HalfedgeId h = first;
    do {
      improve(h);
      h = surface_.turn_ccw(h);
      if (!surface_.has_face(h)) return offer_along(h);  // the boundary
    } while (h != first);
  }

  void offer_along(HalfedgeId h) { offer(surface_.head(h), at(surface_.tail(h)) + length(h)); }

  /// Updates the corners of the face of h from the tail of h, which the front has passed, and from
  /// the other corners that it has passed.
  void improve(HalfedgeId h) {
    const HalfedgeId opposite = surface_.next(h), back = surface_.next(opposite);
    const VertexId v = surface_.tail(h), a = surface_.head(h), b = surface_.tail(back);
    offer(a, at(v) + length(h));
    offer(b, at(v) + length(back));
    const auto offer_across = [&](VertexId other, VertexId third, double width, double to_v,
                                  double to_other) {
      if (!passed_[other.index()]) return;
      // The third corner is not nearer than the corner that the front has just passed.
      offer(third, std::max(at(v), across({at(v), at(other), width, to_v, to_other})));
    };
    offer_across(a, b, length(h), length(back), length(opposite));
    offer_across(b, a, length(back), length(h), length(opposite));
  }

  void offer(VertexId v, double value) {
    if (known_[v.index()] || !(value < distance_[v.index()])) return;
    distance_[v.index()] = value;
    front_.push({value, v.index()});
  }

  [[nodiscard]] double at(VertexId v) const { return distance_[v.index()]; }
  [[nodiscard]] double length(HalfedgeId h) const { return surface_.length(edge_of(h)); }

  const Surface& surface_;
  std::vector<double>& distance_;
  std::vector<bool> known_, passed_;
  using Entry = std::pair<double, std::size_t>;  // ties go to the smaller vertex number
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front_;
};

}  // namespace

void march_distance(const Surface& surface, std::vector<double>& distance, ProgressPoller& poller) {
  if (distance.size() != surface.vertex_count()) {
    throw std::invalid_argument("march_distance: one distance for each vertex is needed");
  }
  March(surface, distance).run(poller);
}

}  // namespace talweg
