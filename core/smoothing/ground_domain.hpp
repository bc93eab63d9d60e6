// The ground domain smooths on a rough mesh without its roughness.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "talweg/core/drawing/drawn_legs.hpp"
#include "talweg/core/smoothing/smoothing_domain.hpp"

namespace talweg {

/// On a rough mesh, a fair curve would follow every bump. The curve is therefore faired on the
/// mesh's smooth_ground(), which has the same faces; the result has the same barycentric
/// coordinates on the mesh. Taut curves, and curves in a given potential, are smoothed on the mesh
/// itself. Deviations are measured on the mesh. Only for the corridor.
class GroundDomain final : public SmoothingDomain {
 public:
  GroundDomain(SmoothingMemory& memory, const OrderedDrawing& drawing, CurveOptions options,
               const Progress& progress);

  DomainResult smooth(const SmoothingOptions& options, const GivenPotential* given,
                      const Progress& progress) override;
  void set_pins(std::span<const SurfacePoint> pins, const Progress& progress) override;
  [[nodiscard]] std::vector<double> slack() const override;

 private:
  [[nodiscard]] bool is_fair(const SmoothingOptions& options) const;
  [[nodiscard]] std::vector<DrawnLegs> legs() const;
  SmoothingDomain& as_it_is(const Progress& progress);

  SmoothingMemory* memory_;
  const OrderedDrawing* drawing_;
  CurveOptions options_;
  OrderedDrawing there_;                       // the drawing as curves on the ground
  std::unique_ptr<SmoothingDomain> ground_;    // the domain on the ground
  std::unique_ptr<SmoothingDomain> as_it_is_;  // on the mesh; made on first use
  double solve_ms_ = 0;
};

}  // namespace talweg
