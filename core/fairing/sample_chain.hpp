// A sample chain is a curve of samples anywhere on the surface, joined by straight lines.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "talweg/core/fairing/curve_trace.hpp"
#include "talweg/intrinsic/lines/straight_walk.hpp"
#include "talweg/intrinsic/lines/strip_line.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The line from a sample to the next.
struct ChainJoin {
  FaceCoordinates from, to;            ///< the samples, each in a face that the join passes
  PlanePoint start, end;               ///< unit directions in the frames of these faces
  double length = 0;                   ///< mesh units
  std::uint32_t first = 0, count = 0;  ///< its strip in SampleChain::crossed
  bool bends = false;                  ///< whether it bends at a vertex
  double to_first_bend = 0, from_last_bend = 0;  ///< lengths; the whole length if nothing bends
  /// The turns at the first and at the last bend, which may be the same bend: the least of the
  /// turns on both sides and their mean; radians, positive to the left.
  double first_turn = 0, last_turn = 0;
  bool bends_once = false;
  std::uint32_t stretch = 0;  ///< the stretch with the join; freed samples still count as fixed
};

/// The ends of an open chain are fixed, and other samples may be. Free samples lie inside faces.
struct SampleChain {
  bool closed = false;
  std::vector<FaceCoordinates> samples;
  std::vector<bool> fixed;
  std::vector<SurfacePoint> fixed_points;  ///< the points of the fixed samples, in order
  std::vector<bool> corners;               ///< unless empty: fixed samples with a free turn
  std::vector<bool> freed;                 ///< unless empty: samples freed by with_freed()
  std::vector<double> turns;               ///< radians, positive to the left; 0 at ends
  /// Unless empty: the place of each sample on the drawing (DrawnLine), not decreasing.
  std::vector<double> drawn;
  double drawn_length = 0;       ///< for a loop: length of the drawing, mesh units
  std::vector<ChainJoin> joins;  ///< as many as samples if closed, else one less
  FaceStrip crossed;

  [[nodiscard]] std::size_t size() const { return samples.size(); }
  [[nodiscard]] bool is_end(std::size_t i) const {
    return !closed && (i == 0 || i + 1 == samples.size());
  }
  /// Whether the turn at a sample costs nothing: at corners, and at ends, which have no turn.
  [[nodiscard]] bool turns_freely(std::size_t i) const {
    return is_end(i) || (!corners.empty() && corners[i]);
  }
  [[nodiscard]] std::size_t before(std::size_t i) const { return i == 0 ? size() - 1 : i - 1; }
  [[nodiscard]] std::size_t after(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }
  /// The join that ends at sample i, which must not be an end of the chain.
  [[nodiscard]] const ChainJoin& join_before(std::size_t i) const {
    return joins[i == 0 ? joins.size() - 1 : i - 1];
  }
  [[nodiscard]] const ChainJoin& join_after(std::size_t i) const { return joins[i]; }
  [[nodiscard]] std::span<const HalfedgeId> strip(const ChainJoin& join) const {
    return std::span(crossed).subspan(join.first, join.count);
  }
  [[nodiscard]] double length() const;
  /// The place on the drawing of the end of a join, which is not before the place of its start.
  [[nodiscard]] double drawn_after(std::size_t join) const {
    return join + 1 == size() ? drawn.front() + drawn_length : drawn[join + 1];
  }
  /// The place on the drawing at the fraction `part` of a join, in [0, 1].
  [[nodiscard]] double drawn_along(std::size_t join, double part) const {
    return drawn[join] + part * (drawn_after(join) - drawn[join]);
  }
  /// At a free sample: the unit direction halfway between the directions of both joins.
  [[nodiscard]] PlanePoint tangent(std::size_t i) const;
};

/// The move of a sample, straight over the faces.
struct SampleStep {
  PlanePoint direction;  ///< unit, in the frame of the sample's face
  double distance = 0;   ///< mesh units, >= 0
};

/// The ways of the samples of a chain over the faces, one strip per sample.
using SampleTrail = std::vector<FaceStrip>;

/// A chain whose samples were moved to the left, with the data that another move of the same chain
/// reuses.
struct ChainMove {
  SampleChain chain;
  std::vector<double> left;          ///< per sample, mesh units
  FaceStrip walks;                   ///< the ways of the samples, one after the other
  std::vector<std::uint32_t> first;  ///< per sample: start of its way in `walks`; last, the end
  /// Per sample: whether the sample or one of its joins differs from the move that was reused.
  std::vector<bool> changed;

  [[nodiscard]] std::span<const HalfedgeId> way(std::size_t i) const {
    return std::span(walks).subspan(first[i], first[i + 1] - first[i]);
  }
};

/// Makes chains. Functions return no chain where two samples cannot be joined, and throw no Error.
/// Cost: O(samples + faces that their joins and ways pass).
class ChainMaker {
 public:
  explicit ChainMaker(const Surface& surface) : surface_(&surface), lines_(surface) {}

  [[nodiscard]] const Surface& surface() const { return *surface_; }

  /// Whether the part of a trace between two samples is to be halved. The part is given by the
  /// places of its ends on the drawing (NaN without a drawing) and its length, mesh units.
  using Divided = std::function<bool(double from, double to, double length)>;
  /// Samples at equal arc lengths between fixed points; at least 8 joins if closed, else 2.
  /// `spacings` limits their distance (mesh units): one number for each stretch between fixed
  /// points (the last stretch of a loop leads to its first fixed point), or one for all. The parts
  /// between samples are halved, again and again, while `divided` is true and the halves are not
  /// shorter than `least`.
  std::optional<SampleChain> sampled(const CurveTrace& trace, std::span<const double> spacings,
                                     double least = 0, const Divided& divided = {});
  std::optional<SampleChain> sampled(const CurveTrace& trace, double spacing) {
    return sampled(trace, std::span(&spacing, 1));
  }
  /// The chain with each free sample moved by its step.
  std::optional<SampleChain> moved(const SampleChain& chain, std::span<const SampleStep> steps);
  /// The chain with each free sample moved to the left by left[i], mesh units. Samples that move as
  /// in `other`, an earlier move of the same chain, are copied from it, unless it is null.
  std::optional<ChainMove> moved_left(const SampleChain& chain, std::span<const double> left,
                                      const ChainMove* other);
  /// The chain whose samples lie on the lines from the samples of one chain to the samples of
  /// another, which moved there along `trail`. `parts`: a fraction in [0, 1] for each sample of
  /// `from`. Without a trail, the chain that is nearer by the first fraction.
  std::optional<SampleChain> between(const SampleChain& from, const SampleChain& to,
                                     const SampleTrail& trail, std::span<const double> parts);
  /// The chain in which the samples that `freed` marks are free.
  std::optional<SampleChain> with_freed(const SampleChain& chain, const std::vector<bool>& freed);
  /// The chain with each join divided into `parts` joins, on a cubic through the chain's samples
  /// with its tangents: one number for each join, or one for all.
  std::optional<SampleChain> divided(const SampleChain& chain, std::span<const int> parts);
  std::optional<SampleChain> divided(const SampleChain& chain, int parts) {
    return divided(chain, std::span(&parts, 1));
  }
  /// The trace of the chain's joins.
  CurveTrace trace_of(const SampleChain& chain);
  /// Computes the turns of a chain that was assembled from parts.
  void set_turns(SampleChain& chain) const;

 private:
  bool move(const SampleChain& chain, std::span<const SampleStep> steps, const ChainMove* other,
            ChainMove& move);
  bool walk(const SampleChain& chain, std::span<const SampleStep> steps, const ChainMove* other,
            ChainMove& move);
  [[nodiscard]] double turn_between(const ChainJoin& in, const ChainJoin& out) const;
  [[nodiscard]] double turn_at(VertexId bend, double in_strip) const;
  bool add_join(SampleChain& chain, const FaceCoordinates& from, const FaceCoordinates& to,
                std::uint32_t stretch);
  /// A straight piece of a join, from one of its ends.
  struct StraightPiece {
    FaceCoordinates from;
    PlanePoint direction;
    double length = 0, start_slope = 0, end_slope = 0;
    bool backwards = false;
  };
  struct Inserted {
    FaceCoordinates at;
    FaceStrip way;  ///< from the start of the join, or from its end
    bool from_end = false;
  };
  WalkEnd walk_off_boundary(const FaceCoordinates& from, const SampleStep& step, double off,
                            FaceStrip& crossed) const;
  bool insert_beside(const StraightPiece& piece, int parts, std::vector<Inserted>& inserted);
  bool divide(const SampleChain& chain, std::size_t join, int parts, SampleChain& result);

  const Surface* surface_;
  StripLines lines_;
  FaceStrip strip_, side_;
};

}  // namespace talweg
