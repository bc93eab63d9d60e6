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

/// It holds everything that is known so far: the windows of all edges and the distances of the
/// vertices. Sources are given by send() and start_at(); each march() then moves the front on by
/// one step. What lies behind the front is final. Memory is allocated once per object; everything
/// else costs what it touches. The surface must outlive the object.
class WindowFront {
 public:
  explicit WindowFront(const Surface& surface);

  /// How many windows there may be. Among needles their number grows with the square of the number
  /// of edges, elsewhere there are a few for each.
  struct Room {
    std::size_t windows = SIZE_MAX;   ///< besides
    std::size_t windows_of_edge = 0;  ///< for each edge that has windows
    std::size_t most = SIZE_MAX;      ///< in any case
  };
  /// Forgets all sources, windows and distances. `step` > 0, mesh units.
  void reset(double step, const Room& room);
  void reset(double step) { reset(step, Room{}); }

  /// Adds a window of a source inside a face. It is laid out along the halfedge of that face, whose
  /// twin is window.into.
  void send(const EdgeWindow& window);
  /// Adds a vertex as source.
  void start_at(VertexId v, const NearestOnCurve& from);

  /// Processes all windows and vertices of one step. Throws Cancelled, between two of them, if
  /// the asker of work() does; the next march() continues there.
  void march();

  /// Nothing that is still to come is nearer; infinite when all is done.
  [[nodiscard]] double distance() const { return queue_.front(); }
  /// Whether a distance that was found can no longer become shorter.
  [[nodiscard]] bool is_final(double found) const {
    return is_done() || is_behind(found, distance());
  }
  /// The same for what was found when the front was at `front`, however far it is now.
  [[nodiscard]] bool is_behind(double found, double front) const {
    return found + queue_.step() / 64 < front;
  }
  [[nodiscard]] bool is_done() const { return queue_.empty(); }

  /// Distances up to this are exact; those farther out are not less than the exact ones. Infinite
  /// while there is room for windows; then only ways along edges lead on.
  [[nodiscard]] double exact_within() const { return exact_within_; }

  /// The best known values, which are final where is_final() says so.
  [[nodiscard]] const VertexDistances& vertices() const { return vertices_; }
  /// x from the tail of the edge's own halfedge.
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
