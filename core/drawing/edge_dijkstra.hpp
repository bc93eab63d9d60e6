// Dijkstra's algorithm draws shortest paths along the edges of a mesh through given vertices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/ids.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

/// Dijkstra's algorithm on the edges of a surface, with memory that is allocated once: every call
/// costs O(m log m) for the m edges it looks at, whatever the size of the mesh.
/// The surface must outlive the object. One thread at a time.
class EdgeDijkstra {
 public:
  /// O(vertices).
  explicit EdgeDijkstra(const Surface& surface);

  /// Shortest edge paths between successive vertices, joined to one path that meets no vertex
  /// twice: no leg runs over a vertex of an earlier leg, nor over a way-point that is not its own
  /// end. A closed path goes on from the last way-point to the first, which is not repeated in the
  /// result, and has at least three vertices. Among equally long paths the smaller predecessor
  /// vertex wins, so the result is always the same. Later legs give way to earlier ones: the path
  /// is not the shortest of all simple paths through the way-points.
  ///
  /// Throws Error(kBadCurve) when there are fewer than 2 way-points, when one is out of range or
  /// repeated, or when a leg has no path; then the sentence names the leg (counted from 1) and
  /// says whether its ends lie on different components or the earlier legs are in its way. Throws
  /// Cancelled when `progress` (stage "draw") says so.
  std::vector<VertexId> draw(std::span<const VertexId> through, bool closed,
                             const Progress& progress = {});

  /// The path when one way-point has moved: `path` was drawn through the same way-points but for
  /// number `moved`, whose new place is in `through`. Only the legs that meet it are drawn anew,
  /// around the rest, which stays; so the result may differ from that of draw(), which lets earlier
  /// legs go first. Where the rest is in the way, or `path` does not pass the neighbours of the
  /// moved way-point, it is draw(through, closed). Throws as draw() does, and Error(kBadUsage)
  /// where there is no way-point `moved`. O(path + two legs).
  std::vector<VertexId> redraw(std::span<const VertexId> path, std::span<const VertexId> through,
                               std::size_t moved, bool closed, const Progress& progress = {});

 private:
  struct Entry {
    double distance;
    VertexId vertex;
  };

  void check(std::span<const VertexId> through) const;
  std::vector<VertexId> drawn(std::span<const VertexId> through, bool closed);
  bool append_redrawn(VertexId from, VertexId over, VertexId to, std::vector<VertexId>& path);
  /// Writes the path from just behind `from` to `to`; false where there is none.
  bool append_leg(VertexId from, VertexId to, bool not_along_edge, std::vector<VertexId>& path);
  bool search(VertexId from, VertexId to, bool not_along_edge, bool obey_blocks);
  void reach(VertexId vertex, VertexId from, double distance);
  [[noreturn]] void no_path(std::size_t leg, VertexId from, VertexId to);

  [[nodiscard]] bool blocked(VertexId v) const { return block_stamp_[v.index()] == drawing_; }
  [[nodiscard]] bool reached(VertexId v) const { return reach_stamp_[v.index()] == search_; }

  const Surface* surface_;
  // A stamp that differs from the running number is one of an earlier call: nothing is cleared.
  std::uint64_t drawing_ = 0;
  std::uint64_t search_ = 0;
  std::vector<std::uint64_t> block_stamp_;
  std::vector<std::uint64_t> reach_stamp_;
  std::vector<std::uint64_t> settled_stamp_;
  std::vector<double> distance_;
  std::vector<VertexId> parent_;
  std::vector<Entry> heap_;
  Asker asker_{{}, "draw"};
};

/// One drawing without keeping the memory: EdgeDijkstra(surface).draw(through, closed).
std::vector<VertexId> draw_edge_path(const Surface& surface, std::span<const VertexId> through,
                                     bool closed = false);

}  // namespace talweg
