// The unrolled sheet has strips of surface for curves that cross, on which they do not.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "talweg/core/smoothing/paper_lift.hpp"
#include "talweg/core/smoothing/sheet.hpp"
#include "talweg/core/smoothing/unrolled_mesh.hpp"
#include "talweg/core/smoothing/whole_sheet.hpp"

namespace talweg {

/// Each curve is smoothed separately. The corridor's distance is to the curve's own part on its
/// strip; the paper's distance is that on the mesh. In the corridor an open curve that ends where
/// it begins is smoothed as a loop that is pinned there, so that it closes without a kink.
class UnrolledSheet final : public Sheet {
 public:
  /// Takes a drawing that is embedded in the memory's triangulation out of it. `alone`: per curve
  /// whether it needs a strip of its own. `distance`: for the paper's method, if it was given.
  UnrolledSheet(SmoothingMemory& memory, const OrderedDrawing& drawing, CurveOptions options,
                const std::vector<bool>& alone, std::optional<std::vector<double>> distance,
                const Progress& progress);

  Smoothed smooth(const SmoothingOptions& options, const GivenPotential* given,
                  const Progress& progress) override;
  void set_pins(std::span<const SurfacePoint> pins, const Progress& progress) override;
  [[nodiscard]] std::vector<double> slack() const override;
  [[nodiscard]] std::span<const double> distance() const override { return lift_.distance(); }

 private:
  void close_rings();
  [[nodiscard]] CurveOptions options_on(std::span<const SurfaceCurve> curves) const;
  [[nodiscard]] SmoothingOptions options_on(SmoothingOptions options) const;
  [[nodiscard]] Smoothed opened(Smoothed smoothed) const;
  [[nodiscard]] double reach(const std::vector<bool>& alone) const;
  [[nodiscard]] std::vector<double> copies_of(const GivenPotential& given) const;
  [[nodiscard]] std::vector<SurfacePoint> copies_on(std::span<const SurfaceCurve> curves,
                                                    std::span<const SurfacePoint> points) const;
  [[nodiscard]] SmoothingOptions with_length_of_mesh(const SmoothingOptions& options) const;
  [[nodiscard]] std::vector<std::string> lost_pins(const Smoothed& smoothed) const;
  Smoothed folded(Smoothed smoothed, const Progress& progress);

  SmoothingMemory* memory_;
  const OrderedDrawing* drawing_;
  CurveOptions options_;
  PaperLift lift_;
  std::vector<SurfaceCurve> curves_;    // as they are unrolled
  std::vector<bool> is_ring_;           // of these, whether they were drawn open
  std::vector<std::size_t> crossings_;  // of the drawing, per drawn curve
  UnrolledMesh mesh_;
  std::unique_ptr<SmoothingMemory> strips_;
  OrderedDrawing on_strips_;
  std::unique_ptr<WholeSheet> sheet_;
  double solve_ms_ = 0;
};

}  // namespace talweg
