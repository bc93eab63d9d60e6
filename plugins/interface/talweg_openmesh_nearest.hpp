// Moves points in space to the nearest points of an OpenMesh mesh.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "talweg_openmesh_mesh.hpp"

namespace talweg::openmesh {
namespace detail {

using Place = std::array<double, 3>;

inline Place minus(const Place& a, const Place& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline double dot(const Place& a, const Place& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The parameter in [0, 1], on the segment from 0 to `along`, of the point nearest to p.
inline double nearest_on(const Place& along, const Place& p) {
  const double length = dot(along, along);
  return length > 0 ? std::clamp(dot(along, p) / length, 0.0, 1.0) : 0;
}

/// Barycentric coordinates of the point of a triangle nearest to p.
inline Place nearest_in(const std::array<Place, 3>& corners, const Place& p) {
  const Place u = minus(corners[1], corners[0]), v = minus(corners[2], corners[0]);
  const Place w = minus(p, corners[0]);
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
  const double area = uu * vv - uv * uv;
  const double b = vv * uw - uv * vw, c = uu * vw - uv * uw;
  if (area > 0 && b >= 0 && c >= 0 && b + c <= area) {
    return {1 - b / area - c / area, b / area, c / area};
  }
  Place best = {1, 0, 0};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {  // on the edges
    const Place& from = corners[k];
    const Place along = minus(corners[(k + 1) % 3], from), to = minus(p, from);
    const double t = nearest_on(along, to);
    const Place off = {to[0] - t * along[0], to[1] - t * along[1], to[2] - t * along[2]};
    if (dot(off, off) >= least) continue;
    least = dot(off, off);
    best = {};
    best[k] = 1 - t;
    best[(k + 1) % 3] = t;
  }
  return best;
}

struct Box {
  Place low, high;

  [[nodiscard]] double distance2(const Place& p) const {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double off = std::max({low[i] - p[i], p[i] - high[i], 0.0});
      sum += off * off;
    }
    return sum;
  }
};

}  // namespace detail

/// Finds nearest points of a mesh without deleted elements, which must outlive it. Its tree of
/// boxes is built at the first query: O(n log n).
template <class Mesh>
class Nearest {
 public:
  explicit Nearest(const Mesh& mesh) : mesh_(mesh) {}

  struct Found {
    FaceHandle face;
    std::array<double, 3> barycentric;
  };
  /// The mesh must have faces. Of faces at equal distance the first in the tree is found.
  Found to(const std::array<double, 3>& p) {
    if (order_.empty()) build();
    Best best;
    search(0, 0, order_.size(), p, best);
    return best.found;
  }

 private:
  static constexpr std::size_t kLeaf = 4;
  struct Best {
    double distance2 = std::numeric_limits<double>::infinity();
    Found found = {FaceHandle(0), {1, 0, 0}};
  };

  [[nodiscard]] std::array<detail::Place, 3> corners(FaceHandle f) const {
    std::array<detail::Place, 3> result;
    const auto vertices = corners_of(mesh_, f);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& p = mesh_.point(vertices[k]);
      result[k] = {double(p[0]), double(p[1]), double(p[2])};
    }
    return result;
  }

  void build() {
    order_.resize(mesh_.n_faces());
    std::vector<detail::Place> centers(order_.size());
    for (std::size_t k = 0; k < order_.size(); ++k) {
      order_[k] = static_cast<int>(k);
      const auto [a, b, c] = corners(FaceHandle(static_cast<int>(k)));
      for (std::size_t i = 0; i < 3; ++i) centers[k][i] = a[i] / 3 + b[i] / 3 + c[i] / 3;
    }
    split(0, 0, order_.size(), centers);
  }

  /// Splits the faces from first to last of a node; its halves are nodes 2 n + 1 and 2 n + 2.
  void split(std::size_t node, std::size_t first, std::size_t last,
             const std::vector<detail::Place>& centers) {
    if (node >= boxes_.size()) boxes_.resize(node + 1);
    boxes_[node] = box_of(first, last);
    if (last - first <= kLeaf) return;
    const detail::Place size = detail::minus(boxes_[node].high, boxes_[node].low);
    const auto axis =
        static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
    const std::size_t middle = first + (last - first) / 2;
    const auto at = [&](std::size_t k) { return order_.begin() + static_cast<std::ptrdiff_t>(k); };
    std::nth_element(at(first), at(middle), at(last), [&](int a, int b) {
      const double x = centers[static_cast<std::size_t>(a)][axis];
      const double y = centers[static_cast<std::size_t>(b)][axis];
      return x != y ? x < y : a < b;
    });
    split(2 * node + 1, first, middle, centers);
    split(2 * node + 2, middle, last, centers);
  }

  [[nodiscard]] detail::Box box_of(std::size_t first, std::size_t last) const {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    detail::Box box{{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
    for (std::size_t k = first; k < last; ++k) {
      for (const detail::Place& p : corners(FaceHandle(order_[k]))) {
        for (std::size_t i = 0; i < 3; ++i) {
          box.low[i] = std::min(box.low[i], p[i]);
          box.high[i] = std::max(box.high[i], p[i]);
        }
      }
    }
    return box;
  }

  void search(std::size_t node, std::size_t first, std::size_t last, const detail::Place& p,
              Best& best) const {
    if (boxes_[node].distance2(p) >= best.distance2) return;
    if (last - first <= kLeaf) return look_at(first, last, p, best);
    const std::size_t middle = first + (last - first) / 2;
    const std::size_t left = 2 * node + 1, right = left + 1;
    if (boxes_[left].distance2(p) <= boxes_[right].distance2(p)) {
      search(left, first, middle, p, best);
      search(right, middle, last, p, best);
    } else {
      search(right, middle, last, p, best);
      search(left, first, middle, p, best);
    }
  }

  void look_at(std::size_t first, std::size_t last, const detail::Place& p, Best& best) const {
    for (std::size_t k = first; k < last; ++k) {
      const FaceHandle face(order_[k]);
      const auto at = corners(face);
      const detail::Place weights = detail::nearest_in(at, p);
      detail::Place off = p;
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t c = 0; c < 3; ++c) off[c] -= weights[i] * at[i][c];
      }
      const double distance2 = detail::dot(off, off);
      if (distance2 < best.distance2) best = {distance2, {face, weights}};
    }
  }

  const Mesh& mesh_;
  std::vector<int> order_;
  std::vector<detail::Box> boxes_;
};

}  // namespace talweg::openmesh
