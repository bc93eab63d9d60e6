#include "sight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace talweg::editing {
namespace {

constexpr std::uint32_t kLeaf = 8;  // the most triangles of a box that is not split

/// The intersection of a ray with a triangle.
struct Meeting {
  double at = -1;  // in lengths of the ray's direction; < 0: no intersection
  std::array<double, 3> barycentric = {0, 0, 0};
};

/// Moeller & Trumbore 1997, "Fast, minimum storage ray/triangle intersection".
Meeting meeting(const Vector& from, const Vector& way, const Vector& a, const Vector& b,
                const Vector& c) {
  const Vector ab = minus(b, a), ac = minus(c, a);
  const Vector normal = cross(way, ac);
  const double det = dot(ab, normal);
  if (det == 0) return {};
  const Vector from_a = minus(from, a);
  const double u = dot(from_a, normal) / det;
  if (u < 0 || u > 1) return {};
  const Vector q = cross(from_a, ab);
  const double v = dot(way, q) / det;
  if (v < 0 || u + v > 1) return {};
  return {dot(ac, q) / det, {1 - u - v, u, v}};
}

}  // namespace

Sight::Sight(std::shared_ptr<const MeshArrays> mesh)
    : mesh_(std::move(mesh)), order_(mesh_->triangles.size()) {
  if (order_.empty()) return;
  std::iota(order_.begin(), order_.end(), 0U);
  std::vector<Vector> middles;
  middles.reserve(order_.size());
  for (const auto& t : mesh_->triangles) {
    Vector sum = plus(plus(mesh_->positions[t[0]], mesh_->positions[t[1]]), mesh_->positions[t[2]]);
    for (double& x : sum) {
      if (!std::isfinite(x)) x = 0;  // no ray meets such a triangle
    }
    middles.push_back(sum);
  }
  split(0, static_cast<std::uint32_t>(order_.size()), middles);
}

Sight::Box Sight::box_of(std::uint32_t begin, std::uint32_t end) const {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Box box{{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}, begin, end};
  for (std::uint32_t k = begin; k < end; ++k) {
    for (const std::uint32_t v : mesh_->triangles[order_[k]]) {
      for (std::size_t i = 0; i < 3; ++i) {
        box.least[i] = std::min(box.least[i], mesh_->positions[v][i]);
        box.most[i] = std::max(box.most[i], mesh_->positions[v][i]);
      }
    }
  }
  return box;
}

/// Splits a box at the median triangle along its longest side, so that the tree has depth O(log n).
void Sight::split(std::uint32_t begin, std::uint32_t end, const std::vector<Vector>& middles) {
  const std::size_t at = boxes_.size();
  boxes_.push_back(box_of(begin, end));
  if (end - begin > kLeaf) {
    const Vector size = minus(boxes_[at].most, boxes_[at].least);
    const auto axis =
        static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
    const std::uint32_t half = begin + (end - begin) / 2;
    std::nth_element(
        order_.begin() + begin, order_.begin() + half, order_.begin() + end,
        [&](std::uint32_t a, std::uint32_t b) { return middles[a][axis] < middles[b][axis]; });
    split(begin, half, middles);
    split(half, end, middles);
  }
  boxes_[at].next = static_cast<std::uint32_t>(boxes_.size());
}

/// Calls `met(triangle, meeting)` for each triangle that the ray meets before `most`, in the order
/// of the tree; `met` returns the new `most`.
template <class Met>
void Sight::meet(const Vector& from, const Vector& way, double most, const Met& met) const {
  const auto crosses = [&](const Box& box) {
    double first = 0, last = most;
    for (std::size_t i = 0; i < 3; ++i) {
      if (way[i] == 0) {
        if (from[i] < box.least[i] || from[i] > box.most[i]) return false;
        continue;
      }
      double near = (box.least[i] - from[i]) / way[i], far = (box.most[i] - from[i]) / way[i];
      if (near > far) std::swap(near, far);
      // The interval is widened a little, so that rounding loses no triangle in a side of its box.
      first = std::max(first, near - 1e-12 * std::abs(near));
      last = std::min(last, far + 1e-12 * std::abs(far));
    }
    return first <= last;
  };
  for (std::uint32_t b = 0; b < boxes_.size();) {
    const Box& box = boxes_[b];
    if (!crosses(box)) {
      b = box.next;
      continue;
    }
    ++b;
    if (b != box.next) continue;  // the box has boxes inside it, which come next
    for (std::uint32_t k = box.begin; k < box.end; ++k) {
      const auto& t = mesh_->triangles[order_[k]];
      const Meeting m = meeting(from, way, mesh_->positions[t[0]], mesh_->positions[t[1]],
                                mesh_->positions[t[2]]);
      if (m.at >= 0 && m.at < most) most = met(order_[k], m);
    }
  }
}

std::optional<Point> Sight::first(const Vector& from, const Vector& way) const {
  std::optional<Point> found;
  meet(from, way, std::numeric_limits<double>::infinity(),
       [&](std::uint32_t triangle, const Meeting& m) {
         found = Point{triangle, m.barycentric};
         return m.at;
       });
  return found;
}

bool Sight::is_hidden(const Point& point, const Vector& from) const {
  const Vector start = position_of(*mesh_, point);
  std::vector<std::uint32_t> own;  // the corners between which the point lies
  for (std::size_t k = 0; k < 3; ++k) {
    if (point.barycentric[k] > 0) own.push_back(mesh_->triangles[point.face][k]);
  }
  const auto touches = [&own](const std::array<std::uint32_t, 3>& t) {
    return std::all_of(own.begin(), own.end(), [&t](std::uint32_t vertex) {
      return std::find(t.begin(), t.end(), vertex) != t.end();
    });
  };
  bool hidden = false;
  meet(start, minus(from, start), 1, [&](std::uint32_t triangle, const Meeting& m) {
    hidden = hidden || (m.at > 0 && !touches(mesh_->triangles[triangle]));
    return hidden ? 0.0 : 1.0;
  });
  return hidden;
}

}  // namespace talweg::editing
