// Mesh sides are the sides of faces in raw lists, grouped by edge, for any number of faces per
// edge.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "talweg/core/mesh/mesh_inspection.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg {

struct FaceSide {
  std::uint32_t low = 0;   ///< smaller vertex
  std::uint32_t high = 0;  ///< larger vertex
  std::uint32_t side = 0;  ///< 3 face + corner

  [[nodiscard]] std::uint32_t face() const { return side / 3; }
};

/// The vertex where the side begins in the direction of its face.
inline std::uint32_t tail(const MeshLists& lists, const FaceSide& s) {
  return lists.triangles[s.side / 3][s.side % 3];
}
/// The corner (3 face + corner) of the side's face at `vertex`, an end of the side.
inline std::uint32_t corner_at(const MeshLists& lists, const FaceSide& s, std::uint32_t vertex) {
  return tail(lists, s) == vertex ? s.side : 3 * s.face() + (s.side % 3 + 1) % 3;
}

/// Sorts items by a key in [0, keys), and items of equal key by `less`. O(keys + n log m) with at
/// most m items of one key.
template <class Item, class Key, class Less>
std::vector<Item> bucket_sort(const std::vector<Item>& items, std::size_t keys, Key key,
                              Less less) {
  std::vector<std::uint32_t> first(keys + 1, 0);
  for (const Item& item : items) ++first[key(item) + 1];
  for (std::size_t k = 0; k < keys; ++k) first[k + 1] += first[k];
  std::vector<std::uint32_t> fill(first.begin(), first.end() - 1);
  std::vector<Item> sorted(items.size());
  for (const Item& item : items) sorted[fill[key(item)]++] = item;
  for (std::size_t k = 0; k < keys; ++k) {
    std::sort(sorted.begin() + first[k], sorted.begin() + first[k + 1], less);
  }
  return sorted;
}

/// The sides of the `proper` faces (three different vertices that exist), grouped by edge, and by
/// ascending face within an edge. O(vertices + faces log degree).
inline std::vector<FaceSide> sorted_sides(const MeshLists& lists, const std::vector<bool>& proper) {
  std::vector<FaceSide> sides;
  sides.reserve(3 * lists.triangles.size());
  for (std::size_t f = 0; f < lists.triangles.size(); ++f) {
    if (!proper[f]) continue;
    const Triangle& t = lists.triangles[f];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
      sides.push_back({low, high, static_cast<std::uint32_t>(3 * f + k)});
    }
  }
  return bucket_sort(
      sides, lists.points.size(), [](const FaceSide& s) { return s.low; },
      [](const FaceSide& a, const FaceSide& b) {
        return std::pair{a.high, a.side} < std::pair{b.high, b.side};
      });
}

/// Calls `visit` with the sides of each edge.
template <class Visit>
void for_each_edge(std::span<const FaceSide> sides, Visit visit) {
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].low == sides[i].low &&
           sides[end].high == sides[i].high) {
      ++end;
    }
    visit(sides.subspan(i, end - i));
    i = end;
  }
}

/// The vertices and faces of an edge, given by its sides.
inline EdgePlace place_of(std::span<const FaceSide> edge) {
  EdgePlace place{{edge[0].low, edge[0].high}, {}};
  for (const FaceSide& s : edge.first(std::min(edge.size(), EdgePlace::kFaces))) {
    place.faces.push_back(s.face());
  }
  return place;
}

}  // namespace talweg
