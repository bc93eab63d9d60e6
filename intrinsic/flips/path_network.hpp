// A path network holds paths that share one triangulation without crossing, side by side.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "talweg/intrinsic/flips/edge_path.hpp"
#include "talweg/intrinsic/flips/signpost_triangulation.hpp"
#include "talweg/intrinsic/surface/ids.hpp"

namespace talweg {

/// A side of a path at a joint.
enum class Side : std::uint8_t { kLeft, kRight };

/// The data structure of FlipOut. A path is a chain of segments, each along one halfedge. An edge
/// keeps its segments ordered from left to right (seen along halfedge_of(edge)), so that paths that
/// share edges keep their sides and never cross.
///
/// One array over the edges is allocated once; all other costs are proportional to the edges that
/// the paths touch.
class PathNetwork {
 public:
  using SegmentId = std::uint32_t;
  static constexpr SegmentId kNone = std::numeric_limits<SegmentId>::max();

  struct Segment {
    HalfedgeId halfedge;
    SegmentId prev = kNone, next = kNone;   // along the path
    SegmentId left = kNone, right = kNone;  // across the edge, seen along halfedge_of(edge)
    std::uint32_t path = 0;
    bool alive = true;
    bool blocked = false;  // a wedge at its end could not be cleared because another path was in it
    bool pinned = false;   // the joint at its end must stay
  };

  struct Path {
    bool closed = false;
    SegmentId first = kNone;
    std::size_t size = 0;
    double length = 0;
  };

  /// A wedge to be cleared: the fan swept counterclockwise from `out` to `back` about their tail.
  struct Wedge {
    SegmentId before = kNone;  // the segment that ends at the joint
    SegmentId after = kNone;   // the segment that starts at the joint
    HalfedgeId out, back;
    Side side = Side::kLeft;
  };

  explicit PathNetwork(SignpostTriangulation& triangulation) : triangulation_(&triangulation) {}

  /// Adds a path. Where the path shares edges with earlier paths (or with itself), it runs on the
  /// side from which it comes, so paths cross only where a crossing cannot be avoided.
  void add(const EdgePath& path);
  void clear();

  [[nodiscard]] std::size_t path_count() const { return paths_.size(); }
  [[nodiscard]] const Path& path(std::size_t i) const { return paths_[i]; }
  [[nodiscard]] const Segment& segment(SegmentId s) const { return segments_[s]; }
  [[nodiscard]] std::size_t segment_count() const { return segments_.size(); }
  [[nodiscard]] EdgePath extract(std::size_t path) const;

  [[nodiscard]] bool occupied(EdgeId e) const { return first_on(e) != kNone; }
  [[nodiscard]] Wedge wedge(SegmentId before, Side side) const;
  /// The wedge's angle; +infinity if the wedge is not on the surface or is the outside of a spike.
  double angle(const Wedge& wedge) const;
  /// Whether no other segment runs inside the wedge or between the wedge and its own two segments.
  /// O(degree).
  [[nodiscard]] bool is_free(const Wedge& wedge) const;
  void set_blocked(SegmentId s, bool blocked);
  void pin(SegmentId s) { segments_[s].pinned = true; }
  [[nodiscard]] std::size_t blocked_count() const { return blocked_count_; }
  /// Calls `visit` for every segment that ends at the vertex `tail(around)`. O(degree).
  template <class Visit>
  void for_each_joint(HalfedgeId around, Visit visit) const;

  /// Replaces the wedge's two segments (or its only one, for a one-edge loop) by a path with the
  /// same ends. The path is given in counterclockwise order from the head of `out` to the head of
  /// `back`, with the wedge on the left of each halfedge. New segments are the nearest ones to the
  /// wedge's vertex. The wedge's own joint must not be pinned; a pinned joint after the wedge stays
  /// pinned. `ids` receives the new segments in the order of the path.
  void replace(const Wedge& wedge, std::span<const HalfedgeId> arc, std::vector<SegmentId>& ids);

  /// Replaces a closed path by a single edge, outermost on the left of `inward`.
  void restart(std::size_t path, HalfedgeId loop, HalfedgeId inward);

 private:
  [[nodiscard]] SegmentId first_on(EdgeId e) const {
    return e.index() < first_on_.size() ? first_on_[e.index()] : kNone;
  }
  [[nodiscard]] bool outermost(SegmentId s, HalfedgeId along, Side side) const;
  [[nodiscard]] SegmentId neighbour(SegmentId s, HalfedgeId along, Side side) const;
  void put(SegmentId s, SegmentId left_neighbour);
  void put_outermost_left(SegmentId s, HalfedgeId along);
  void take_off(SegmentId s);
  SegmentId new_segment(HalfedgeId h, std::uint32_t path);
  void place_among(SegmentId s);
  [[nodiscard]] bool runs_left_of(SegmentId s, SegmentId other) const;
  [[nodiscard]] std::size_t turn_order(HalfedgeId from, HalfedgeId to) const;

  SignpostTriangulation* triangulation_;
  std::vector<SegmentId> first_on_;  // leftmost segment of each edge
  std::vector<Segment> segments_;
  std::vector<Path> paths_;
  std::size_t blocked_count_ = 0;
};

template <class Visit>
void PathNetwork::for_each_joint(HalfedgeId around, Visit visit) const {
  const SignpostTriangulation& t = *triangulation_;
  const auto look = [&](HalfedgeId h) {
    for (SegmentId s = first_on(edge_of(h)); s != kNone; s = segments_[s].right) {
      if (segments_[s].halfedge == twin(h)) {
        visit(s);
      } else if (segments_[s].prev != kNone) {
        visit(segments_[s].prev);
      }
    }
  };
  HalfedgeId h = around;
  do {
    look(h);
    if (!t.has_face(h)) break;
    h = t.turn_ccw(h);
  } while (h != around);
  if (h == around) return;
  for (h = t.turn_cw(around); h.valid(); h = t.turn_cw(h)) look(h);
}

}  // namespace talweg
