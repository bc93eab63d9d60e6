#include "talweg/core/fairing/near_points.hpp"

#include <cstddef>
#include <utility>
#include <variant>

namespace talweg {
namespace {

class NearPoints {
 public:
  NearPoints(const Surface& surface, bool closed, double length, double near)
      : surface_(&surface), closed_(closed), length_(length), near_(near) {}

  void drop(bool vertices, std::vector<KeptPoint>& points) const {
    const std::size_t least = closed_ ? 3 : 2;
    const std::size_t n = points.size();
    std::vector<KeptPoint> kept;
    kept.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
      const bool is_end = !closed_ && (i == 0 || i + 1 == n);
      const bool may_go = !is_end && !points[i].stays && kept.size() + n - i > least &&
                          (vertices || !std::holds_alternative<AtVertex>(points[i].point.where()));
      const KeptPoint& before = kept.empty() ? points[n - 1] : kept.back();
      const KeptPoint& after = i + 1 < n || kept.empty() ? points[(i + 1) % n] : kept.front();
      if (!may_go || !is_needless(before, points[i], after)) kept.push_back(points[i]);
    }
    points = std::move(kept);
  }

 private:
  [[nodiscard]] bool is_needless(const KeptPoint& before, const KeptPoint& point,
                                 const KeptPoint& after) const {
    return (gap(before, point) < near_ || gap(point, after) < near_) &&
           common_face(*surface_, before.point, after.point).valid();
  }
  [[nodiscard]] double gap(const KeptPoint& from, const KeptPoint& to) const {
    return to.arc - from.arc + (to.arc < from.arc ? length_ : 0);
  }

  const Surface* surface_;
  bool closed_;
  double length_, near_;
};

}  // namespace

void drop_near_points(const Surface& surface, bool closed, double length, double near,
                      std::vector<KeptPoint>& points) {
  const NearPoints near_points(surface, closed, length, near);
  for (const bool vertices : {false, true}) near_points.drop(vertices, points);
}

}  // namespace talweg
