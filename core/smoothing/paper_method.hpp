// The paper's method straightens curves over a potential on the mesh's vertices, and relaxes them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "talweg/core/lifting/paper_lift.hpp"
#include "talweg/core/smoothing/embedded_drawing.hpp"
#include "talweg/core/smoothing/smoothed.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// A potential given by the caller: row by row `components` values per mesh vertex, mesh units.
struct GivenPotential {
  std::span<const double> values;
  std::size_t components = 1;
};

/// Straightens in that potential and relaxes. Throws Cancelled.
DomainResult smooth_in(EmbeddedDrawing& drawing, const GivenPotential& potential,
                       const SmoothingOptions& options, const Progress& progress);

/// The method of Pawellek, Rössl & Lawonn, sections 3.3 and 4, with the distance computed by heat
/// or given. Refers to the objects it is made from. Cost: that of PaperLift once for a drawing,
/// then a run of Straightening and relax() for each tau.
class PaperMethod {
 public:
  PaperMethod(const OpenedMesh& mesh, EmbeddedDrawing& drawing)
      : drawing_(&drawing), lift_(mesh, drawing.straightening()) {}

  /// Computes the distance if it is not known yet. Throws Cancelled.
  void need_distance(const Progress& progress);
  /// Sets a distance that was checked with PaperLift::check().
  void set_distance(std::vector<double> distance);
  [[nodiscard]] const PaperLift& lift() const { return lift_; }

  /// Needs no distance at tau = 0. Throws Cancelled.
  DomainResult smooth(const SmoothingOptions& options, const Progress& progress);

 private:
  EmbeddedDrawing* drawing_;
  PaperLift lift_;
};

}  // namespace talweg
