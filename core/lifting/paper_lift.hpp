// The paper's lift raises the surface by a potential of the distance to the drawing, everywhere.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "talweg/core/lifting/potential.hpp"
#include "talweg/core/lifting/straightening.hpp"
#include "talweg/core/mesh/opened_mesh.hpp"
#include "talweg/intrinsic/flips/signpost_triangulation.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// The distance, computed by heat or given, and the lengths in the lifted surface that follow from
/// it (Pawellek, Rössl & Lawonn, section 3.3 and equations 4 to 6). Cost of solve(): the cost of
/// HeatDistance over the whole mesh, once for a drawing; of set(): O(vertices); of a length: O(1).
class PaperLift {
 public:
  /// Both must outlive this object. Each function uses the curves that `curves` has embedded when
  /// the function is called.
  PaperLift(const OpenedMesh& mesh, const Straightening& curves) : mesh_(&mesh), curves_(&curves) {}

  void clear();
  [[nodiscard]] bool is_known() const { return !distance_.empty(); }
  /// One value per mesh vertex.
  [[nodiscard]] std::span<const double> distance() const { return distance_; }

  /// Throws Error(kBadUsage) when there is not one distance per vertex, or a distance is NaN or
  /// -infinity.
  static void check(const Surface& surface, std::span<const double> distance);
  /// Sets a distance that check() accepts. `several`: whether there is more than one curve.
  void set(std::vector<double> distance, bool several);
  /// Computes the distance to the curves by heat. Throws Cancelled; the distance is unchanged then.
  void solve(std::span<const SurfaceCurve> curves, const HeatSettings& settings,
             const Progress& progress);

  /// The metric of the lifted surface, a function that refers to this object. `drawn_length`: total
  /// of all curves.
  [[nodiscard]] SignpostTriangulation::Metric metric(const PotentialOptions& options, double tau,
                                                     double drawn_length) const;
  /// The characteristic length L of the component that a vertex is on.
  [[nodiscard]] double characteristic_length(const PotentialOptions& options, double drawn_length,
                                             VertexId vertex) const;

  /// The length that was added to edges to compute the distance, mesh units, and a warning about
  /// it.
  [[nodiscard]] double mollification() const { return mollification_; }
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }
  /// The times for factorising the mesh's matrices and for the solve, ms.
  [[nodiscard]] double open_ms() const { return open_ms_; }
  [[nodiscard]] double solve_ms() const { return solve_ms_; }

 private:
  void find_largest(bool several);
  [[nodiscard]] std::size_t component_of(VertexId v) const;
  [[nodiscard]] double length_of(const PotentialOptions& options, double drawn_length,
                                 std::size_t component) const;

  const OpenedMesh* mesh_;
  const Straightening* curves_;
  std::vector<double> distance_;          // per mesh vertex
  std::vector<double> at_inserted_;       // per inserted vertex
  std::optional<Components> components_;  // made when first needed
  std::vector<double> largest_;           // the largest distance per component, or one for all
  double mollification_ = 0, open_ms_ = 0, solve_ms_ = 0;
  std::vector<std::string> warnings_;
};

}  // namespace talweg
