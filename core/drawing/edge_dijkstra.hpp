// Dijkstra's algorithm draws shortest paths along the edges of a mesh through given vertices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/ids.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

class EdgeLandmarks;

/// A vertex where an edge path may begin or end, for a path between points beside the vertices.
struct PathEnd {
  VertexId vertex;
  double beyond = 0;  ///< length of the way from the vertex to the point, mesh units
};

/// Dijkstra's algorithm on the edges of a surface, with memory that is allocated once. A call that
/// visits m edges costs O(m log m), whatever the size of the mesh; a leg of length r visits a disc
/// of radius r. After searches that together visited 16 times the whole mesh, the object
/// computes landmarks, whose bounds leave out vertices that no shortest path can pass; the paths
/// stay the same. The surface must outlive the object. One thread at a time.
class EdgeDijkstra {
 public:
  /// O(vertices).
  explicit EdgeDijkstra(const Surface& surface);
  ~EdgeDijkstra();

  /// Shortest edge paths between successive vertices, joined to one path that meets no vertex
  /// twice: no leg runs over a vertex of an earlier leg, or over a way-point that is not its own
  /// end. A closed path continues from the last way-point to the first, which is not repeated in
  /// the result, and has at least three vertices. Among equally long paths the one with the smaller
  /// predecessor vertex wins, so the result is deterministic. Later legs avoid earlier ones, so the
  /// path need not be the shortest of all simple paths through the way-points.
  ///
  /// Throws Error(kBadCurve) when there are fewer than 2 way-points, when one is out of range or
  /// repeated, or when a leg has no path; the message then names the leg (counted from 1) and says
  /// whether its ends lie on different components or the earlier legs block it. Throws Cancelled
  /// when `progress` (stage "draw") says so.
  std::vector<VertexId> draw(std::span<const VertexId> through, bool closed,
                             const Progress& progress = {});

  /// The path after one way-point has moved. `path` was drawn through the same way-points, except
  /// for way-point number `moved`, whose new place is in `through`. Only the legs at the moved
  /// way-point are drawn anew; they avoid the rest of the path, which stays. So the result may
  /// differ from the one of draw(), in which later legs avoid earlier ones. Where the rest of the
  /// path blocks a leg, or `path` does not pass the neighbours of the moved way-point, the result
  /// is draw(through, closed). Throws as draw() does, and Error(kBadUsage) if there is no way-point
  /// `moved`. O(path + two legs).
  std::vector<VertexId> redraw(std::span<const VertexId> path, std::span<const VertexId> through,
                               std::size_t moved, bool closed, const Progress& progress = {});

  /// The shortest of the edge paths from one of `starts` to one of `ends`, where the length of a
  /// path includes the ways beyond both. The path is a single vertex if going through this vertex
  /// is shortest. Throws Error(kBadCurve) if no path leads from any start to any end, and Cancelled
  /// when `progress` (stage "draw") says so.
  std::vector<VertexId> between(std::span<const PathEnd> starts, std::span<const PathEnd> ends,
                                const Progress& progress = {});

 private:
  /// The paths among which search() finds the shortest.
  struct Task {
    std::span<const PathEnd> starts, ends;
    bool not_along_edge = false;  ///< the edge from a start to an end is not a path
    bool obey_blocks = true;      ///< paths avoid blocked vertices that are no ends
  };
  struct Entry {
    double distance;  ///< from the start; with landmarks, a bound of the whole path
    VertexId vertex;
  };

  static bool later(const Entry& a, const Entry& b);

  void check(std::span<const VertexId> through) const;
  std::vector<VertexId> drawn(std::span<const VertexId> through, bool closed);
  bool append_redrawn(VertexId from, VertexId over, VertexId to, std::vector<VertexId>& path);
  /// Appends the path from the vertex after `from` up to `to`; false where no path exists.
  bool append_leg(VertexId from, VertexId to, bool not_along_edge, std::vector<VertexId>& path);
  /// Finds the shortest path, keeps it in parent_ and returns its end; invalid where no path
  /// exists.
  VertexId search(const Task& task);
  VertexId search_around(const Task& task);
  VertexId search_with_landmarks(const Task& task);
  bool find_parents(const Task& task, VertexId end);
  [[nodiscard]] std::vector<VertexId> path_to(VertexId end) const;
  [[nodiscard]] bool closed_way(const Task& task, VertexId from, VertexId to) const;
  template <class Visit>
  void visit_neighbours(VertexId vertex, const Visit& visit) const;
  void reach(VertexId vertex, VertexId from, double distance);
  [[noreturn]] void no_path(std::size_t leg, VertexId from, VertexId to);

  [[nodiscard]] bool blocked(VertexId v) const { return block_stamp_[v.index()] == drawing_; }
  [[nodiscard]] bool reached(VertexId v) const { return reach_stamp_[v.index()] == search_; }

  const Surface* surface_;
  // Stamps that differ from the running number belong to an earlier call, so arrays need no
  // clearing.
  std::uint64_t drawing_ = 0;
  std::uint64_t search_ = 0;
  std::vector<std::uint64_t> block_stamp_;
  std::vector<std::uint64_t> reach_stamp_;
  std::vector<std::uint64_t> settled_stamp_;
  std::vector<double> distance_;
  std::vector<VertexId> parent_;
  std::vector<Entry> heap_;
  std::size_t looked_at_ = 0;  // vertices visited, in all searches
  std::unique_ptr<EdgeLandmarks> landmarks_;
  ProgressPoller poller_{{}, "draw"};
};

/// Draws one path without keeping the memory: EdgeDijkstra(surface).draw(through, closed).
std::vector<VertexId> draw_edge_path(const Surface& surface, std::span<const VertexId> through,
                                     bool closed = false);

}  // namespace talweg
