#include "talweg/core/mesh/face_dropping.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <tuple>

#include "talweg/core/mesh/mesh_sides.hpp"
#include "talweg/core/space/face_shape.hpp"

namespace talweg {
namespace {

bool is_collapsed(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

bool is_flat(const MeshLists& lists, std::uint32_t face) {
  const Triangle& t = lists.triangles[face];
  return shape_of({lists.points[t[0]], lists.points[t[1]], lists.points[t[2]]}).flat;
}

/// Drops faces of zero area whose removal leaves no gap.
class FlatFaces {
 public:
  FlatFaces(const MeshLists& lists, std::vector<bool>& kept)
      : lists_(lists), kept_(kept), flat_(lists.triangles.size(), false) {
    for (std::uint32_t f = 0; f < flat_.size(); ++f) {
      if (!kept_[f] || !is_flat(lists, f)) continue;
      flat_[f] = true;
      waiting_.push_back(f);
    }
  }

  std::vector<std::uint32_t> take_away() {
    if (waiting_.empty()) return {};
    join();
    std::vector<std::uint32_t> dropped;
    for (std::size_t i = 0; i < waiting_.size(); ++i) {
      const std::uint32_t f = waiting_[i];
      if (!kept_[f] || !leaves_no_gap(f)) continue;
      kept_[f] = false;
      dropped.push_back(f);
      for (std::uint32_t k = 0; k < 3; ++k) leave(edge_of_side_[3 * f + k]);
    }
    std::sort(dropped.begin(), dropped.end());
    return dropped;
  }

 private:
  struct Edge {
    std::span<const FaceSide> sides;
    std::size_t faces;  ///< the number of faces not yet dropped
  };

  void join() {
    sides_ = sorted_sides(lists_, kept_);
    edge_of_side_.resize(3 * lists_.triangles.size());
    for_each_edge(sides_, [&](std::span<const FaceSide> sides) {
      for (const FaceSide& s : sides) {
        edge_of_side_[s.side] = static_cast<std::uint32_t>(edges_.size());
      }
      edges_.push_back({sides, sides.size()});
    });
  }

  [[nodiscard]] bool leaves_no_gap(std::uint32_t f) const {
    std::size_t shared = 0, boundary = 0;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::size_t faces = edges_[edge_of_side_[3 * f + k]].faces;
      if (faces == 2) ++shared;
      if (faces == 1) ++boundary;
    }
    return shared == 0 || (shared == 1 && boundary == 2);
  }

  /// Removes one face from an edge. If one face remains, this face may have become droppable.
  void leave(std::uint32_t edge) {
    if (--edges_[edge].faces != 1) return;
    for (const FaceSide& s : edges_[edge].sides) {
      if (kept_[s.face()] && flat_[s.face()]) waiting_.push_back(s.face());
    }
  }

  const MeshLists& lists_;
  std::vector<bool>& kept_;
  std::vector<bool> flat_;
  std::vector<std::uint32_t> waiting_;
  std::vector<FaceSide> sides_;
  std::vector<Edge> edges_;
  std::vector<std::uint32_t> edge_of_side_;
};

}  // namespace

std::vector<RepeatPlace> duplicate_faces(const MeshLists& lists, const std::vector<bool>& proper) {
  struct Face {
    std::array<std::uint32_t, 3> corners;
    std::uint32_t id;
  };
  std::vector<Face> faces;
  faces.reserve(lists.triangles.size());
  for (std::size_t f = 0; f < lists.triangles.size(); ++f) {
    if (!proper[f]) continue;
    std::array<std::uint32_t, 3> c = lists.triangles[f];
    std::sort(c.begin(), c.end());
    faces.push_back({c, static_cast<std::uint32_t>(f)});
  }
  faces = bucket_sort(
      faces, lists.points.size(), [](const Face& f) { return f.corners[0]; },
      [](const Face& a, const Face& b) {
        return std::tie(a.corners, a.id) < std::tie(b.corners, b.id);
      });
  std::vector<RepeatPlace> repeats;
  for (std::size_t i = 1, earlier = 0; i < faces.size(); ++i) {
    if (faces[i].corners != faces[earlier].corners) {
      earlier = i;
    } else {
      repeats.push_back({faces[i].id, faces[earlier].id});
    }
  }
  std::sort(repeats.begin(), repeats.end(),
            [](const RepeatPlace& a, const RepeatPlace& b) { return a.element < b.element; });
  return repeats;
}

DroppedFaces faces_to_drop(const MeshLists& lists) {
  DroppedFaces result;
  result.kept.assign(lists.triangles.size(), true);
  for (std::uint32_t f = 0; f < lists.triangles.size(); ++f) {
    if (!is_collapsed(lists.triangles[f])) continue;
    result.collapsed.push_back(f);
    result.kept[f] = false;
  }
  result.duplicates = duplicate_faces(lists, result.kept);
  for (const RepeatPlace& place : result.duplicates) result.kept[place.element] = false;
  result.zero_area = FlatFaces(lists, result.kept).take_away();
  return result;
}

}  // namespace talweg
