// A sample chain is a curve as samples that lie anywhere on the surface, joined by straight lines.
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
  FaceCoordinates from, to;            ///< the samples; in other faces where they lie on edges
  PlanePoint start, end;               ///< unit directions in the frames of these faces
  double length = 0;                   ///< mesh units
  std::uint32_t first = 0, count = 0;  ///< its strip in SampleChain::crossed
  bool bends = false;                  ///< at a vertex
  double first_leg = 0, last_leg = 0;  ///< to the first bend, and from the last; else the length
  /// How much it turns at the first and the last bend, which may be one, on the side on which that
  /// is less; radians, to the left positive.
  double first_turn = 0, last_turn = 0;
  bool bends_once = false;
  std::uint32_t stretch = 0;  ///< counted by the points that were fixed at first
};

/// The ends of an open chain are fixed, as other samples may be; free samples lie inside faces.
struct SampleChain {
  bool closed = false;
  std::vector<FaceCoordinates> samples;
  std::vector<bool> fixed;
  std::vector<SurfacePoint> fixed_points;  ///< where these are, in their order
  std::vector<bool> corners;  ///< unless empty: fixed samples at which it may turn freely
  std::vector<bool> loose;    ///< unless empty: samples that were fixed at first
  std::vector<double> turns;  ///< radians, to the left positive; 0 at ends
  /// Unless empty: where each sample belongs on the drawing (DrawnLine), not decreasing.
  std::vector<double> drawn;
  double drawn_length = 0;       ///< of a loop: of the drawing, mesh units
  std::vector<ChainJoin> joins;  ///< as many as samples if closed, else one less
  FaceStrip crossed;

  [[nodiscard]] std::size_t size() const { return samples.size(); }
  [[nodiscard]] bool is_end(std::size_t i) const {
    return !closed && (i == 0 || i + 1 == samples.size());
  }
  /// Whether its turn at the sample costs nothing; ends have none.
  [[nodiscard]] bool turns_freely(std::size_t i) const {
    return is_end(i) || (!corners.empty() && corners[i]);
  }
  [[nodiscard]] std::size_t before(std::size_t i) const { return i == 0 ? size() - 1 : i - 1; }
  [[nodiscard]] std::size_t after(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }
  /// Not of an end.
  [[nodiscard]] const ChainJoin& join_before(std::size_t i) const {
    return joins[i == 0 ? joins.size() - 1 : i - 1];
  }
  [[nodiscard]] const ChainJoin& join_after(std::size_t i) const { return joins[i]; }
  [[nodiscard]] std::span<const HalfedgeId> strip(const ChainJoin& join) const {
    return std::span(crossed).subspan(join.first, join.count);
  }
  [[nodiscard]] double length() const;
  /// The place on the drawing of the end of a join, which is not before that of its start.
  [[nodiscard]] double drawn_after(std::size_t join) const {
    return join + 1 == size() ? drawn.front() + drawn_length : drawn[join + 1];
  }
  /// The place on the drawing of a part of a join, in [0, 1].
  [[nodiscard]] double drawn_along(std::size_t join, double part) const {
    return drawn[join] + part * (drawn_after(join) - drawn[join]);
  }
  /// At a free sample: unit direction halfway between those of both joins.
  [[nodiscard]] PlanePoint tangent(std::size_t i) const;
};

/// How a sample is moved: straight over the faces.
struct SampleStep {
  PlanePoint direction;  ///< unit, in the frame of the sample's face
  double distance = 0;   ///< mesh units, >= 0
};

/// Where the samples of a chain have come from: the way of each over the faces.
using SampleTrail = std::vector<FaceStrip>;

/// A chain whose samples were moved to the left, and what another such move can take over from it.
struct ChainMove {
  SampleChain chain;
  std::vector<double> left;          ///< per sample, mesh units
  FaceStrip walks;                   ///< the ways of the samples, one after the other
  std::vector<std::uint32_t> first;  ///< per sample: where its way begins; and their end
  /// Per sample: whether it, or one of its joins, is another than in the move that this one has
  /// taken over from.
  std::vector<bool> anew;

  [[nodiscard]] std::span<const HalfedgeId> way(std::size_t i) const {
    return std::span(walks).subspan(first[i], first[i + 1] - first[i]);
  }
};

/// Makes chains. Each function gives none where two samples cannot be joined; `Error` is not
/// thrown. Each costs O(samples + faces that their joins and ways pass).
class ChainMaker {
 public:
  explicit ChainMaker(const Surface& surface) : surface_(&surface), lines_(surface) {}

  [[nodiscard]] const Surface& surface() const { return *surface_; }

  /// Whether the part of a trace between two samples is to be halved. It is given by the places of
  /// its ends on the drawing (not a number where there is none) and its length, mesh units.
  using Divided = std::function<bool(double from, double to, double length)>;
  /// Samples at equal arc lengths between points that are fixed; at least 8 joins if closed, else
  /// 2. They are at most so far apart (mesh units): one number for each stretch between such points
  /// (of a loop, the last one leads to the first of these), or one for all. Parts between them are
  /// halved, and halved again, where `divided` says so and they stay longer than `least`.
  std::optional<SampleChain> sampled(const CurveTrace& trace, std::span<const double> spacings,
                                     double least = 0, const Divided& divided = {});
  std::optional<SampleChain> sampled(const CurveTrace& trace, double spacing) {
    return sampled(trace, std::span(&spacing, 1));
  }
  /// Each free sample moved by its step.
  std::optional<SampleChain> moved(const SampleChain& chain, std::span<const SampleStep> steps);
  /// Each free sample moved by so much to the left. What moves as in another move of the same chain
  /// is taken over from that, unless it is null.
  std::optional<ChainMove> moved_left(const SampleChain& chain, std::span<const double> left,
                                      const ChainMove* other);
  /// The chain whose samples lie at these parts of the ways from one chain to another; the nearer
  /// one where there is no trail. One part for each sample of `from`.
  std::optional<SampleChain> between(const SampleChain& from, const SampleChain& to,
                                     const SampleTrail& trail, std::span<const double> parts);
  /// The chain with these samples no longer fixed.
  std::optional<SampleChain> loosened(const SampleChain& chain, const std::vector<bool>& loose);
  /// With so many joins for each, on a cubic that has the chain's samples and tangents: one number
  /// for each join, or one for all.
  std::optional<SampleChain> divided(const SampleChain& chain, std::span<const int> parts);
  std::optional<SampleChain> divided(const SampleChain& chain, int parts) {
    return divided(chain, std::span(&parts, 1));
  }
  /// The lines of the chain.
  CurveTrace trace_of(const SampleChain& chain);
  /// Measures the turns of a chain that was put together.
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
  struct Leg {
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
  bool insert_beside(const Leg& leg, int parts, std::vector<Inserted>& inserted);
  bool divide(const SampleChain& chain, std::size_t join, int parts, SampleChain& result);

  const Surface* surface_;
  StripLines lines_;
  FaceStrip strip_, side_;
};

}  // namespace talweg
