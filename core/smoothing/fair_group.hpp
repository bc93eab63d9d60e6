// A fair group is the curves that are faired as one: joined at their ends, or one alone.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "talweg/core/fairing/drawn_line.hpp"
#include "talweg/core/fairing/joined_curves.hpp"
#include "talweg/core/fairing/sample_chain.hpp"
#include "talweg/core/lifting/leg_start.hpp"
#include "talweg/core/smoothing/embedded_drawing.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// Curves that are faired as one, and what follows from the drawing for that.
struct FairGroup {
  JoinedCurves joined;
  SurfaceCurve drawn;                     ///< all of them
  std::vector<SurfacePoint> junctions;    ///< where they meet
  double edge = 0;                        ///< mean edge near them, mesh units
  double length = 0;                      ///< of all of them, mesh units
  std::shared_ptr<const DrawnLine> line;  ///< `drawn` in space

  /// Per stretch of a chain between fixed samples, to which of the curves it belongs. O(fixed
  /// samples · junctions).
  [[nodiscard]] std::vector<std::size_t> parts_of_stretches(const SampleChain& chain) const;
};

/// For each of the curves of a group.
using Taus = std::vector<double>;

/// The group of these curves of the drawing. O(points).
FairGroup fair_group(const EmbeddedDrawing& drawing, JoinedCurves curves);
Taus taus_of(const FairGroup& group, const SmoothingOptions& options);
bool has_legs(const EmbeddedDrawing& drawing, const FairGroup& group);
/// Where the straightened curve of a group has its legs; none where it does not pass their ends in
/// their order. O(points).
std::optional<LegStart> leg_start(const EmbeddedDrawing& drawing, const FairGroup& group,
                                  const SurfaceCurve& taut, double length_exponent);

}  // namespace talweg
