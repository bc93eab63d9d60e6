#include "tools/paper/refinement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "tools/scenes/random.hpp"

namespace talweg::paper {
namespace {

class Refinement {
 public:
  explicit Refinement(const MeshLists& mesh) : old_(&mesh) { new_.points = mesh.points; }

  void split_edges_of(const Triangle& t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [at, is_new] = middle_.try_emplace(key(t[k], t[(k + 1) % 3]), 0);
      if (!is_new) continue;
      at->second = static_cast<std::uint32_t>(new_.points.size());
      new_.points.push_back(0.5 * (old_->points[t[k]] + old_->points[t[(k + 1) % 3]]));
    }
  }

  MeshLists finish() {
    for (const Triangle& t : old_->triangles) divide(t);
    return std::move(new_);
  }

 private:
  using Key = std::pair<std::uint32_t, std::uint32_t>;
  static Key key(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

  void divide(const Triangle& t) {
    std::array<std::uint32_t, 3> m{};  // the middle of the edge behind corner k, or kNone
    std::size_t split = 0, odd = 0;    // odd: the only split edge, or the only whole one
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = middle_.find(key(t[k], t[(k + 1) % 3]));
      m[k] = at == middle_.end() ? kNone : at->second;
      if (m[k] != kNone) ++split;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      if ((m[k] != kNone) == (split == 1)) odd = k;
    }
    const std::uint32_t a = t[odd], b = t[(odd + 1) % 3], c = t[(odd + 2) % 3];
    const std::uint32_t ab = m[odd], bc = m[(odd + 1) % 3], ca = m[(odd + 2) % 3];
    const auto add = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
      new_.triangles.push_back({p, q, r});
    };
    if (split == 0) {
      add(t[0], t[1], t[2]);
    } else if (split == 1) {
      add(a, ab, c);
      add(ab, b, c);
    } else if (split == 2) {
      add(bc, c, ca);
      add(a, b, bc);
      add(a, bc, ca);
    } else {
      add(a, ab, ca);
      add(ab, b, bc);
      add(ca, bc, c);
      add(ab, bc, ca);
    }
  }

  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
  const MeshLists* old_;
  MeshLists new_;
  std::map<Key, std::uint32_t> middle_;
};

}  // namespace

MeshLists refined(const MeshLists& mesh, const std::function<bool(const Point& middle)>& pick) {
  Refinement refinement(mesh);
  for (const Triangle& t : mesh.triangles) {
    if (pick((mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3)) {
      refinement.split_edges_of(t);
    }
  }
  return refinement.finish();
}

MeshLists disc(std::uint32_t rings) {
  MeshLists mesh;
  scenes::Random random(2);
  mesh.points.emplace_back(0, 0, 0);
  for (std::uint32_t k = 1; k <= rings; ++k) {
    for (std::uint32_t i = 0; i < 6 * k; ++i) {
      const double free = k < rings ? 0.22 : 0;
      const double angle = 2 * std::numbers::pi * (i + random.in(-free, free)) / (6 * k);
      const double r = (k + random.in(-free, free)) / rings;
      mesh.points.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
    }
  }
  // Ring k starts at vertex 1 + 3 k (k - 1); ring 0 is the centre.
  const auto vertex = [](std::uint32_t k, std::uint32_t i) {
    return k == 0 ? 0 : 1 + 3 * k * (k - 1) + i % (6 * k);
  };
  for (std::uint32_t k = 1; k <= rings; ++k) {
    for (std::uint32_t side = 0; side < 6; ++side) {
      for (std::uint32_t i = 0; i < k; ++i) {
        const std::uint32_t out = side * k + i, in = side * (k - 1) + i;
        mesh.triangles.push_back({vertex(k, out), vertex(k, out + 1), vertex(k - 1, in)});
        if (i + 1 < k) {
          mesh.triangles.push_back({vertex(k - 1, in), vertex(k, out + 1), vertex(k - 1, in + 1)});
        }
      }
    }
  }
  return mesh;
}

}  // namespace talweg::paper
