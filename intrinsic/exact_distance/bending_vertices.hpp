// Bending vertices are those around which a shortest way can bend.
#pragma once

#include <cstdint>
#include <vector>

#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

/// A shortest way bends only around a vertex whose total angle exceeds a full turn (half a turn at
/// the boundary). A vertex with an edge of length 0 counts, too, because its angles say little.
/// Computed when first asked for. The surface must outlive the object.
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
