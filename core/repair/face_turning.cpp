#include "talweg/core/repair/face_turning.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>

#include "talweg/core/mesh/mesh_sides.hpp"

namespace talweg {
namespace {

constexpr std::uint32_t kNoSide = std::numeric_limits<std::uint32_t>::max();

/// Visits the faces of a part, and finds whether each is turned relative to the first face.
class Flood {
 public:
  Flood(const MeshLists& lists, const std::vector<bool>& proper)
      : lists_(lists),
        across_(3 * lists.triangles.size(), kNoSide),
        seen_(lists.triangles.size(), false),
        turned_(lists.triangles.size(), false) {
    for_each_edge(sorted_sides(lists, proper), [&](std::span<const FaceSide> edge) {
      if (edge.size() != 2) return;
      across_[edge[0].side] = edge[1].side;
      across_[edge[1].side] = edge[0].side;
    });
  }

  [[nodiscard]] bool seen(std::uint32_t face) const { return seen_[face]; }

  /// The faces to turn in the part of face `first`; empty if the part is one-sided.
  std::vector<std::uint32_t> part_of(std::uint32_t first) {
    std::vector<std::uint32_t> part{first};
    seen_[first] = true;
    bool two_sided = true;
    for (std::size_t i = 0; i < part.size(); ++i) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t side = 3 * part[i] + k;
        if (across_[side] == kNoSide) continue;
        const std::uint32_t other = across_[side] / 3;
        const bool turned = turned_[part[i]] != (tail_of(side) == tail_of(across_[side]));
        if (!seen_[other]) {
          seen_[other] = true;
          turned_[other] = turned;
          part.push_back(other);
        }
        two_sided = two_sided && turned_[other] == turned;
      }
    }
    if (!two_sided) return {};
    const auto count = static_cast<std::size_t>(
        std::count_if(part.begin(), part.end(), [&](std::uint32_t f) { return turned_[f]; }));
    const bool turn_these = 2 * count <= part.size();
    std::erase_if(part, [&](std::uint32_t f) { return turned_[f] != turn_these; });
    return part;
  }

 private:
  [[nodiscard]] std::uint32_t tail_of(std::uint32_t side) const {
    return lists_.triangles[side / 3][side % 3];
  }

  const MeshLists& lists_;
  std::vector<std::uint32_t> across_;  ///< per side, the opposite side of the edge
  std::vector<bool> seen_;
  std::vector<bool> turned_;
};

}  // namespace

std::vector<std::uint32_t> faces_to_turn(const MeshLists& lists, const std::vector<bool>& proper) {
  Flood flood(lists, proper);
  std::vector<std::uint32_t> result;
  for (std::uint32_t f = 0; f < lists.triangles.size(); ++f) {
    if (!proper[f] || flood.seen(f)) continue;
    const std::vector<std::uint32_t> part = flood.part_of(f);
    result.insert(result.end(), part.begin(), part.end());
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace talweg
