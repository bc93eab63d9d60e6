// A fair group consists of curves that are faired as one: curves joined at their ends, or a single
// curve.
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

/// Curves that are faired as one, with values of their drawing.
struct FairGroup {
  JoinedCurves joined;
  SurfaceCurve drawn;                     ///< all curves, joined
  std::vector<SurfacePoint> junctions;    ///< the points where curves are joined
  double edge = 0;                        ///< mean edge near the curves, mesh units
  double length = 0;                      ///< of all curves, mesh units
  std::shared_ptr<const DrawnLine> line;  ///< `drawn` in space

  /// Per stretch of a chain between fixed samples, its curve, as an index into joined.parts.
  /// O(fixed samples · junctions).
  [[nodiscard]] std::vector<std::size_t> parts_of_stretches(const SampleChain& chain) const;
};

/// One tau per curve of a group.
using Taus = std::vector<double>;

/// The group of the given curves of a drawing. O(points).
FairGroup fair_group(const EmbeddedDrawing& drawing, JoinedCurves curves);
Taus taus_of(const FairGroup& group, const SmoothingOptions& options);
bool has_legs(const EmbeddedDrawing& drawing, const FairGroup& group);
/// The legs on the straightened curve of a group; empty if the curve does not pass the ends of the
/// legs in order. O(points).
std::optional<LegStart> leg_start(const EmbeddedDrawing& drawing, const FairGroup& group,
                                  const SurfaceCurve& taut, double length_exponent);

}  // namespace talweg
