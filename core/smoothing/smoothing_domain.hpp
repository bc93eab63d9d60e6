// A smoothing domain is the surface on which a drawing is smoothed: the mesh, or a surface made for
// the drawing.
#pragma once

#include <span>
#include <vector>

#include "talweg/core/drawing/point_copies.hpp"
#include "talweg/core/lifting/corridor.hpp"
#include "talweg/core/smoothing/domain_result.hpp"
#include "talweg/core/smoothing/ordered_drawing.hpp"
#include "talweg/core/smoothing/paper_method.hpp"
#include "talweg/core/smoothing/smoothing_memory.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// Converts a drawing from its mesh to the domain, smooths it there, and converts results back.
/// Arguments and results are on the mesh, in the drawing's order. Every non-const function throws
/// Cancelled; set_pins() must then be called again.
class SmoothingDomain {
 public:
  SmoothingDomain() = default;
  virtual ~SmoothingDomain() = default;
  SmoothingDomain(const SmoothingDomain&) = delete;
  SmoothingDomain& operator=(const SmoothingDomain&) = delete;

  /// `given`: a potential on the mesh that replaces the method's potential; null for none.
  virtual DomainResult smooth(const SmoothingOptions& options, const GivenPotential* given,
                              const Progress& progress) = 0;
  virtual void set_pins(std::span<const SurfacePoint> pins, const Progress& progress) = 0;
  /// Per curve, the corridor's default slack, mesh units; empty for the paper's method.
  [[nodiscard]] virtual std::vector<double> slack() const = 0;
  /// Per curve, its valley in the corridor; null if the domain is not the mesh itself.
  [[nodiscard]] virtual const std::vector<Corridor::Valley>* valleys() const { return nullptr; }
  /// The paper's distance per mesh vertex; empty if not known.
  [[nodiscard]] virtual std::span<const double> distance() const { return {}; }
  virtual void need_distance(const Progress& /*progress*/) {}
};

/// The options in the drawing's order; unchanged for the paper's method, which has no options per
/// curve.
inline SmoothingOptions ordered_for(Method method, const OrderedDrawing& drawing,
                                    const SmoothingOptions& options) {
  return method == Method::kCorridor ? drawing.ordered(options) : options;
}

/// The options for a drawing on another surface, given the copies of its points there.
inline CurveOptions options_there(const CurveOptions& options, const PointCopies& copies) {
  CurveOptions there = options;
  there.pins = copies.of(options.pins);
  there.corners = copies.of(options.corners);
  there.painted = copies.of(options.painted);
  there.way_points.clear();
  for (const WayPoint& way_point : options.way_points) {
    for (const SurfacePoint& point : copies.of(std::span(&way_point.point, 1))) {
      there.way_points.push_back({point, way_point.tolerance});
    }
  }
  return there;
}

/// Whether a result might continue beyond a part of the surface that was cut off at the vertices
/// `at_cut`. O(points).
bool may_leave(const std::vector<bool>& at_cut, const Surface& part, const DomainResult& result);

}  // namespace talweg
