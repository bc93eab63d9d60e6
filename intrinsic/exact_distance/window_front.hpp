// The window front spreads windows over the surface, in the order of their distance.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "talweg/intrinsic/exact_distance/bending_vertices.hpp"
#include "talweg/intrinsic/exact_distance/nearest_on_curve.hpp"
#include "talweg/intrinsic/exact_distance/polyline_queue.hpp"
#include "talweg/intrinsic/exact_distance/polyline_window.hpp"
#include "talweg/intrinsic/exact_distance/polyline_window_lists.hpp"
#include "talweg/intrinsic/exact_distance/vertex_distances.hpp"
#include "talweg/intrinsic/exact_distance/work_tally.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

/// The front holds the windows of all edges and the distances of the vertices that are known so
/// far. send() and start_at() add sources; each march() then moves the front on by one step.
/// Distances below the front are final. Memory is allocated once per object; all other costs are
/// proportional to the elements touched. The surface must outlive the object.
class WindowFront {
 public:
  explicit WindowFront(const Surface& surface);

  /// The limit of the number of windows. Among needles the number grows with the square of the
  /// number of edges; ordinary edges have a few windows each.
  struct Room {
    std::size_t windows = SIZE_MAX;   ///< for all edges together
    std::size_t windows_of_edge = 0;  ///< added for each edge that has windows
    std::size_t most = SIZE_MAX;      ///< upper limit of the sum
  };
  /// Forgets all sources, windows and distances. `step` > 0, mesh units.
  void reset(double step, const Room& room);
  void reset(double step) { reset(step, Room{}); }

  /// Adds a window of a source inside a face. The window is laid out along the halfedge of this
  /// face whose twin is window.into.
  void send(const EdgeWindow& window);
  /// Adds a vertex as source.
  void start_at(VertexId v, const NearestOnCurve& from);

  /// Processes all windows and vertices of one step. Throws Cancelled, between two of them, if
  /// the poller of work() does; the next march() continues there.
  void march();

  /// A lower bound of the distances still to come; infinite when the front is done.
  [[nodiscard]] double distance() const { return queue_.front(); }
  /// Whether a distance that was found can no longer decrease.
  [[nodiscard]] bool is_final(double found) const {
    return is_done() || is_behind(found, distance());
  }
  /// The same for a distance that was found when the front was at `front`.
  [[nodiscard]] bool is_behind(double found, double front) const {
    return found + queue_.step() / 64 < front;
  }
  [[nodiscard]] bool is_done() const { return queue_.empty(); }

  /// The limit up to which distances are exact; larger distances are upper bounds. Infinite while
  /// there is room for windows; without room, only paths along edges continue.
  [[nodiscard]] double exact_within() const { return exact_within_; }

  /// The best known values, which are final where is_final() says so.
  [[nodiscard]] const VertexDistances& vertices() const { return vertices_; }
  /// The best known value at x, measured from the tail of the edge's own halfedge.
  [[nodiscard]] NearestOnCurve on_edge(EdgeId edge, double x) const;

  [[nodiscard]] const WindowLists& windows() const { return windows_; }
  [[nodiscard]] WorkTally& work() { return work_; }

 private:
  enum ItemKind : std::uint32_t { kWindowItem, kVertexItem };

  void fetch_ahead() const;
  void propagate(const EdgeWindow& stored);
  void add(const EdgeWindow& window);
  void pass_on(const EdgeWindow& window, int most = 64);
  void spread_from(VertexId v);
  void spread_across(HalfedgeId spoke, const NearestOnCurve& from);
  void insert(const EdgeWindow& window);
  bool has_room();
  void lower(VertexId v, const NearestOnCurve& way);

  const Surface* surface_;
  BendingVertices bending_;
  VertexDistances vertices_;
  WindowLists windows_;
  StepQueue queue_;
  WorkTally work_;
  Room room_;
  double exact_within_ = HUGE_VAL;
};

}  // namespace talweg
