// FlipOut straightens edge paths into geodesics by flips.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "talweg/intrinsic/flips/edge_path.hpp"
#include "talweg/intrinsic/flips/path_network.hpp"
#include "talweg/intrinsic/flips/signpost_triangulation.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

struct FlipOutOptions {
  /// A joint with a side angle below pi - angle_tolerance is not straight yet. Radians, in (0, 1).
  double angle_tolerance = 1e-5;
  /// Limit of cleared wedges; by default 1,000,000 + 1,000 per segment, which no reasonable input
  /// reaches.
  std::optional<std::size_t> max_iterations;
  /// Limit of flips, which are logged to be undone (40 bytes each); by default 4,000,000 + 16 per
  /// edge. Only paths with thousands of points in one face reach it, because their flips grow with
  /// the square of the number of points.
  std::optional<std::size_t> max_flips;
  /// Stop when the paths' total length has fallen to this fraction of the initial one. In [0, 1).
  double min_relative_length = 0;
  /// A closed path shorter than this counts as collapsed. Units of length, >= 0.
  double length_floor = 0;
  /// Vertices at which the paths that pass them are not straightened. Sorted.
  std::vector<VertexId> pinned;

  /// Throws Error(kBadUsage) naming the field and its bound.
  void validate() const;
  friend bool operator==(const FlipOutOptions&, const FlipOutOptions&) = default;
};

enum class Termination {
  kConverged,  ///< straight except where another path blocks it
  kCollapsed,  ///< a loop shrank below the floor; returned as it was at that moment
  kLimit,      ///< max_iterations, max_flips or min_relative_length reached
  kCancelled,  ///< cancelled by the caller; the path so far is returned
};
const char* to_string(Termination termination);

struct FlipOutResult {
  struct Path {
    EdgePath path;
    Termination termination = Termination::kConverged;
    double length_before = 0;
    double length_after = 0;
  };
  std::vector<Path> paths;  ///< in the order they were given
  std::size_t iterations = 0;
  std::size_t flips = 0;
  std::size_t blocked = 0;  ///< joints that stay bent because another path is in their wedge
};

/// Sharp & Crane, "You Can Find Geodesic Paths in Triangle Meshes by Just Flipping Edges" (2020).
///
/// The joint with the smallest side angle is cleared first: edges of its wedge are flipped until
/// the wedge's outer boundary is straight or bends away, and that boundary replaces the joint.
/// Every accepted step shortens the path, so paths never grow, and they never cross. The flips stay
/// pending in the triangulation until the result is traced (trace.hpp), which also undoes them.
/// A cleared wedge costs O(log s) for s segments, and its flips; a path through n points of one
/// face may need n² flips. Memory for the edges is allocated once per object. Not thread safe.
class FlipOut {
 public:
  explicit FlipOut(SignpostTriangulation& triangulation)
      : triangulation_(&triangulation), network_(triangulation) {}

  /// Throws Error(kBadUsage) for options out of range.
  FlipOutResult run(std::span<const EdgePath> paths, const FlipOutOptions& options,
                    const Progress& progress = {});

 private:
  using SegmentId = PathNetwork::SegmentId;
  using Wedge = PathNetwork::Wedge;

  struct Candidate {
    double angle;
    SegmentId before;
    SegmentId after;
    Side side;
    bool operator>(const Candidate& other) const {
      if (angle != other.angle) return angle > other.angle;
      return before != other.before ? before > other.before : side > other.side;
    }
  };

  void push(SegmentId before);
  void push(SegmentId before, Side side);
  void push_around(HalfedgeId around);
  bool valid(const Candidate& candidate) const;
  bool process(const Candidate& candidate);
  bool clear_wedge(const Wedge& wedge);
  bool open_single_edge_loop(const Wedge& wedge);
  bool shorten_opened_loop(const Wedge& first, double target);
  [[nodiscard]] bool only_a_spike_remains(const Wedge& wedge) const;
  bool remove_spike(const Wedge& wedge);
  void flip_inside(HalfedgeId out, HalfedgeId back);
  void accept(const Wedge& wedge, std::span<const HalfedgeId> arc);
  void check_floor(std::size_t path);

  SignpostTriangulation* triangulation_;
  PathNetwork network_;
  FlipOutOptions options_;
  std::vector<Termination> terminations_;
  std::vector<int> failed_openings_;
  std::vector<Candidate> heap_;
  std::vector<HalfedgeId> arc_;
  std::vector<SegmentId> fresh_;
};

}  // namespace talweg
