#include "tools/quality/level_sets.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace talweg::quality {
namespace {

class LevelSets {
 public:
  LevelSets(const SurfaceMesh& mesh, const std::function<double(const Point&)>& f)
      : surface_(mesh.surface()), seen_(surface_.edge_count(), false) {
    values_.reserve(mesh.points().size());
    for (const Point& p : mesh.points()) values_.push_back(f(p));
  }

  std::vector<std::vector<VertexId>> loops() {
    std::vector<std::vector<VertexId>> result;
    for (std::size_t e = 0; e < seen_.size(); ++e) {
      const HalfedgeId h = halfedge_of(EdgeId{e});
      if (seen_[e] || !crosses(h)) continue;
      std::vector<VertexId> loop = follow(inside(surface_.head(h)) ? h : twin(h));
      if (loop.size() >= 3) result.push_back(std::move(loop));
    }
    std::stable_sort(result.begin(), result.end(),
                     [](const auto& a, const auto& b) { return a.size() > b.size(); });
    return result;
  }

 private:
  [[nodiscard]] bool inside(VertexId v) const { return values_[v.index()] > 0; }
  [[nodiscard]] bool crosses(HalfedgeId h) const {
    return inside(surface_.tail(h)) != inside(surface_.head(h));
  }

  /// Follows the level set from face to face, with the positive side always on the same hand; empty
  /// at the boundary.
  std::vector<VertexId> follow(const HalfedgeId first) {
    std::vector<VertexId> loop;
    bool whole = true;
    HalfedgeId h = first;
    do {
      seen_[edge_of(h).index()] = true;
      const VertexId a = surface_.tail(h), b = surface_.head(h);
      const bool nearer = std::abs(values_[a.index()]) < std::abs(values_[b.index()]);
      if (loop.empty() || loop.back() != (nearer ? a : b)) loop.push_back(nearer ? a : b);
      if (!surface_.has_face(h)) {
        whole = false;
        break;
      }
      const HalfedgeId next = surface_.next(h);
      h = twin(crosses(next) ? next : surface_.next(next));
    } while (h != first);
    return whole ? loop : std::vector<VertexId>{};
  }

  const Surface& surface_;
  std::vector<double> values_;
  std::vector<bool> seen_;
};

}  // namespace

std::vector<std::vector<VertexId>> closed_level_sets(const SurfaceMesh& mesh,
                                                     const std::function<double(const Point&)>& f) {
  return LevelSets(mesh, f).loops();
}

}  // namespace talweg::quality
