// Bending vertices are the vertices around which a shortest path can bend.
#pragma once

#include <cstdint>
#include <vector>

#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

/// A shortest path bends only around a vertex whose total angle exceeds 2π (π at the boundary). A
/// vertex with an edge of length 0 counts, too, because its angles are meaningless. The answer for
/// a vertex is computed at its first query. The surface must outlive the object.
class BendingVertices {
 public:
  explicit BendingVertices(const Surface& surface);

  /// O(degree of v) the first time.
  bool contain(VertexId v) {
    std::uint8_t& known = known_[v.index()];
    if (known == kUnknown) known = compute(v) ? kBends : kStraight;
    return known == kBends;
  }

 private:
  enum : std::uint8_t { kUnknown, kStraight, kBends };
  [[nodiscard]] bool compute(VertexId v) const;

  const Surface* surface_;
  std::vector<std::uint8_t> known_;  // per vertex
};

}  // namespace talweg
