#include "talweg/core/repair/sheet_splitting.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <tuple>
#include <utility>

#include "talweg/core/mesh/mesh_sides.hpp"
#include "talweg/core/mesh/union_find.hpp"

namespace talweg {
namespace {

constexpr std::size_t kMostPaired = 16;
constexpr int kRounds = 4;

using SidePair =
    std::pair<std::uint32_t, std::uint32_t>;  ///< two indices into the sides of an edge

/// The unit vector in the face perpendicular to the edge; zero for a face of zero area.
Point into_face(const MeshLists& lists, const FaceSide& s) {
  const Point& base = lists.points[s.low];
  const Point along = (lists.points[s.high] - base).stableNormalized();
  const std::uint32_t apex = lists.triangles[s.face()][(s.side % 3 + 2) % 3];
  const Point up = (lists.points[apex] - base).stableNormalized();
  return (up - along.dot(up) * along).stableNormalized();
}

/// The pairs of faces that stay joined at an edge, chosen greedily from the flattest pair on.
std::vector<SidePair> flattest_pairs(const MeshLists& lists, std::span<const FaceSide> edge) {
  if (edge.size() > kMostPaired) return {};
  std::vector<Point> into;
  for (const FaceSide& s : edge) into.push_back(into_face(lists, s));
  std::vector<std::tuple<double, std::uint32_t, std::uint32_t>> candidates;
  for (std::uint32_t i = 0; i < edge.size(); ++i) {
    for (std::uint32_t j = i + 1; j < edge.size(); ++j) {
      if (tail(lists, edge[i]) == tail(lists, edge[j])) continue;
      candidates.emplace_back(into[i].dot(into[j]), i, j);
    }
  }
  std::sort(candidates.begin(), candidates.end());
  std::vector<bool> taken(edge.size(), false);
  std::vector<SidePair> pairs;
  for (const auto& [flatness, i, j] : candidates) {
    if (taken[i] || taken[j]) continue;
    taken[i] = taken[j] = true;
    pairs.emplace_back(i, j);
  }
  return pairs;
}

class Splitter {
 public:
  Splitter(const MeshLists& lists, const std::vector<bool>& proper)
      : lists_(lists), sides_(sorted_sides(lists, proper)), plain_(3 * lists.triangles.size()) {}

  Sheets run() {
    Sheets result;
    for_each_edge(sides_, [&](std::span<const FaceSide> edge) {
      if (edge.size() == 2) join(plain_, edge, {0, 1});
      if (edge.size() > 2) {
        result.crowded.emplace_back(edge.begin(), edge.end());
        crowded_.push_back({edge, flattest_pairs(lists_, edge)});
      }
    });
    UnionFind fans = joined();
    for (int round = 1; cut_what_is_left(fans, round); ++round) fans = joined();
    result.fan_of_corner.resize(3 * lists_.triangles.size());
    for (std::uint32_t c = 0; c < result.fan_of_corner.size(); ++c) {
      result.fan_of_corner[c] = fans.find(c);
    }
    return result;
  }

 private:
  struct Crowded {
    std::span<const FaceSide> edge;
    std::vector<SidePair> pairs;
  };

  void join(UnionFind& fans, std::span<const FaceSide> edge, SidePair pair) const {
    for (const std::uint32_t v : {edge[0].low, edge[0].high}) {
      fans.join(corner_at(lists_, edge[pair.first], v), corner_at(lists_, edge[pair.second], v));
    }
  }

  [[nodiscard]] UnionFind joined() const {
    UnionFind fans = plain_;
    for (const Crowded& crowded : crowded_) {
      for (const SidePair& pair : crowded.pairs) join(fans, crowded.edge, pair);
    }
    return fans;
  }

  /// Whether more than two faces of the edge would still share both end vertices after splitting.
  bool still_crowded(UnionFind& fans, std::span<const FaceSide> edge) const {
    std::vector<SidePair> ends;
    for (const FaceSide& s : edge) {
      ends.emplace_back(fans.find(corner_at(lists_, s, s.low)),
                        fans.find(corner_at(lists_, s, s.high)));
    }
    std::sort(ends.begin(), ends.end());
    for (std::size_t i = 2; i < ends.size(); ++i) {
      if (ends[i] == ends[i - 2]) return true;
    }
    return false;
  }

  /// Cuts edges that are still crowded completely; after kRounds rounds, all crowded edges. Tells
  /// whether an edge was cut. When all crowded edges are cut, at most two faces share any edge, so
  /// the rounds end.
  bool cut_what_is_left(UnionFind& fans, int round) {
    bool any = false;
    for (Crowded& crowded : crowded_) {
      if (crowded.pairs.empty() || !still_crowded(fans, crowded.edge)) continue;
      crowded.pairs.clear();
      any = true;
    }
    if (any && round >= kRounds) {
      for (Crowded& crowded : crowded_) crowded.pairs.clear();
    }
    return any;
  }

  const MeshLists& lists_;
  std::vector<FaceSide> sides_;
  UnionFind plain_;  ///< fans of corners joined over edges with two faces
  std::vector<Crowded> crowded_;
};

}  // namespace

Sheets split_sheets(const MeshLists& lists, const std::vector<bool>& proper) {
  return Splitter(lists, proper).run();
}

}  // namespace talweg
