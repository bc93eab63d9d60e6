// The unrolled domain has strips of surface for curves that cross, on which they do not.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "talweg/core/lifting/paper_lift.hpp"
#include "talweg/core/smoothing/sheet.hpp"
#include "talweg/core/smoothing/unrolled_mesh.hpp"
#include "talweg/core/smoothing/whole_sheet.hpp"

namespace talweg {

/// Each curve is smoothed separately. The corridor's distance is to the curve's own part on its
/// strip; the paper's distance is that on the mesh. In the corridor an open curve that ends where
/// it begins is smoothed as a loop that is pinned there, so that it closes without a kink. Cost:
/// that of MeshDomain on strips that reach twice as far each time, up to where the result does not
/// leave them. Worse: pins that are lost are compared with all points of the results.
class UnrolledDomain final : public SmoothingDomain {
 public:
  /// Takes a drawing that is embedded in the memory's triangulation out of it. `alone`: per curve
  /// whether it needs a strip of its own. `distance`: for the paper's method, if it was given.
  UnrolledDomain(SmoothingMemory& memory, const OrderedDrawing& drawing, CurveOptions options,
                 const std::vector<bool>& alone, std::optional<std::vector<double>> distance,
                 const Progress& progress);

  DomainResult smooth(const SmoothingOptions& options, const GivenPotential* given,
                      const Progress& progress) override;
  void set_pins(std::span<const SurfacePoint> pins, const Progress& progress) override;
  [[nodiscard]] std::vector<double> slack() const override;
  [[nodiscard]] std::span<const double> distance() const override { return lift_.distance(); }

 private:
  /// The strips up to some reach, and the curves on them.
  struct Strips {
    std::vector<SurfaceCurve> drawn;  ///< as they are unrolled
    std::vector<bool> is_ring;        ///< of these, whether they were drawn open
    UnrolledMesh mesh;
    std::unique_ptr<SmoothingMemory> memory;
    OrderedDrawing drawing;
    std::unique_ptr<MeshDomain> domain;
  };
  void close_rings();
  [[nodiscard]] std::unique_ptr<Strips> laid_strips(const std::vector<SurfaceCurve>& drawn,
                                                    const std::vector<bool>& is_ring,
                                                    const Progress& progress) const;
  bool open_lost_rings(Strips& strips) const;
  void set_reach();
  void add_strips(const Progress& progress);
  [[nodiscard]] CurveOptions options_on(const Strips& strips,
                                        std::span<const SurfaceCurve> curves) const;
  [[nodiscard]] SmoothingOptions options_on(const Strips& strips, SmoothingOptions options) const;
  static DomainResult curves_on(const Strips& strips, const SmoothingOptions& options,
                                const GivenPotential* given, const Progress& progress);
  static bool bound_deviation(const Strips& strips, DomainResult& result);
  [[nodiscard]] static std::vector<double> copies_of(const Strips& strips,
                                                     const GivenPotential& given);
  [[nodiscard]] static DomainResult opened(const Strips& strips, DomainResult smoothed);
  [[nodiscard]] static PointCopies copies_on(const Strips& strips,
                                             std::span<const SurfaceCurve> curves);
  [[nodiscard]] SmoothingOptions with_length_of_mesh(const SmoothingOptions& options) const;
  [[nodiscard]] std::vector<std::string> lost_pins(const DomainResult& smoothed) const;
  DomainResult folded(const Strips& strips, DomainResult smoothed, const Progress& progress);

  SmoothingMemory* memory_;
  const OrderedDrawing* drawing_;
  CurveOptions options_;
  std::vector<bool> alone_;  // per drawn curve: whether it needs a strip of its own
  PaperLift lift_;
  std::vector<SurfaceCurve> curves_;    // those that may be rings are closed
  std::vector<bool> is_ring_;           // of these, whether they were drawn open
  std::vector<std::size_t> crossings_;  // of the drawing, per drawn curve
  double reach_ = 0;                    // of the next strips, mesh units
  std::size_t most_faces_ = 0;          // of strips that are followed by larger ones
  std::vector<std::unique_ptr<Strips>> strips_;
  double solve_ms_ = 0;
};

}  // namespace talweg
