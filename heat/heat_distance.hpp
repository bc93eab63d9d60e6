// The heat distance is a smoothed geodesic distance to a curve or to any weighted vertices.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "talweg/heat/curve_sources.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

/// Options that are fixed when a surface is opened.
struct HeatOptions {
  double time_scale = 10;       ///< heat time in units of h², h mean edge length; [1e-3, 1e6]
  double mollification = 1e-5;  ///< least slack of a triangle in units of h; [1e-10, 1e-2]
  bool delaunay = true;         ///< work on the intrinsic Delaunay triangulation
  unsigned threads = 2;         ///< used while opening; >= 1; no effect on results

  /// Throws Error(kBadUsage) naming the field and its bound.
  void validate() const;
};

/// Options that may differ from one distance to the next.
struct DistanceOptions {
  bool zero_on_sources = true;  ///< shift so that the weighted mean over the sources is 0
  bool clamp = true;            ///< negative distances (around the curve) become 0
};

/// The work done when a surface was opened.
struct HeatReport {
  std::size_t components = 0;            ///< connected parts of the surface
  std::size_t flips = 0;                 ///< to the intrinsic Delaunay triangulation
  std::size_t flat_triangles = 0;        ///< without area even after mollification; ignored
  std::vector<double> mean_edge_length;  ///< h of each component
  std::vector<double> mollification;     ///< length added to each edge, per component; 0 if none
  std::size_t factor_entries = 0;        ///< of one triangular factor
  double laplacian_ms = 0;               ///< mollification, flips and matrices
  double order_ms = 0;                   ///< symbolic analysis
  double factor_ms = 0;                  ///< all numeric factors
};

/// The heat method (Crane, Weischedel & Wardetzky 2013) with a larger time step, as the paper uses
/// it (section 4): heat flows from the sources for the time s h², its gradient is normalised, and
/// the distance is the function whose gradient fits it best.
///
/// The constructor, called once per surface, factors all matrices; any number of distances can then
/// be solved for. Immutable, so any number of threads may call solve at the same time. The object
/// does not refer to the surface after construction.
///
/// Where a component has a boundary and a source off the boundary, the heat is the average of the
/// solutions with free (Neumann) and with cold (Dirichlet) boundary, as Crane et al. advise;
/// elsewhere the boundary is free. The time and all other scales are taken per component, so
/// components do not influence each other.
class HeatDistance {
 public:
  /// Throws Error(kBadUsage) for bad options, Error(kBadMesh) for a surface without vertices,
  /// Error(kNumerical) or Error(kOutOfMemory) when the factorization fails.
  explicit HeatDistance(const Surface& surface, const HeatOptions& options = {});

  /// Like the constructor, with progress (stages "laplacian", "order", "factor"); empty when
  /// cancelled.
  static std::optional<HeatDistance> open(const Surface& surface, const HeatOptions& options,
                                          const Progress& progress);

  ~HeatDistance();
  HeatDistance(HeatDistance&&) noexcept;
  HeatDistance& operator=(HeatDistance&&) noexcept;

  /// One distance per vertex, in length units: +infinity in components without a source, finite
  /// elsewhere. Without zero_on_sources only differences within a component are meaningful. Throws
  /// Error(kBadCurve) when a source is not a vertex of the surface, a weight is negative or not
  /// finite, or no weight is positive; Error(kNumerical) if a distance is not finite. `progress`
  /// (stage "solve") is called between the steps of the solve; Cancelled is thrown when it returns
  /// false.
  [[nodiscard]] std::vector<double> solve(std::span<const WeightedVertex> sources,
                                          const DistanceOptions& options = {},
                                          const Progress& progress = {}) const;

  [[nodiscard]] const HeatReport& report() const;

 private:
  struct Impl;
  explicit HeatDistance(std::unique_ptr<const Impl> impl);
  std::unique_ptr<const Impl> impl_;
};

/// Computes the distance to a curve in one call.
std::vector<double> heat_distance(const Surface& surface, const SurfaceCurve& curve,
                                  const HeatOptions& options = {});

}  // namespace talweg
