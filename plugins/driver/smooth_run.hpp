// A run of `talweg smooth` reads the curves of one mesh, smooths them and writes them.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "drawing_file.hpp"
#include "failure.hpp"
#include "repaired_mesh.hpp"
#include "smooth_options.hpp"
#include "talweg/core/drawing/placed_curve.hpp"
#include "talweg/core/measure/report.hpp"
#include "talweg/core/mesh/opened_mesh.hpp"
#include "talweg/core/ridges/ridge_snapping.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"

namespace talweg::driver {

/// A mesh read from a file, and its origin.
struct MeshFromFile {
  std::shared_ptr<const OpenedMesh> opened;
  double load_ms = 0;
  CoordinateFrame frame;                 ///< of the coordinates, as the file says
  std::size_t polygons = 0;              ///< number of polygons that were split into triangles
  std::shared_ptr<const RepairMap> map;  ///< to the file's numbers; null without a repair
  std::vector<std::string> changes;      ///< made by the repair, as sentences

  [[nodiscard]] const SurfaceMesh& mesh() const { return opened->mesh(); }
};

/// Throws Error as read_and_repair() and OpenedMesh::open() do.
MeshFromFile load_mesh(const std::string& path, const std::string& repair);

/// A curve that could not be smoothed.
struct CurveFailure {
  std::size_t curve = 0;  ///< its number among the run's curves, from 0
  Failure why;
};

/// The result of smoothing, ready to be written.
struct PlacedResult {
  std::vector<PlacedCurve> curves;
  std::vector<double> spacings;  ///< of the curves' points, if they were resampled; mesh units
  std::vector<SmoothingReport> reports;
  std::vector<RidgeMoves> ridges;  ///< of the curves, if ridges were to attract them
  SmoothingReport total;
};

/// `result.curves` lacks curves that failed; only independent curves can fail separately.
struct RunOutcome {
  PlacedResult result;
  std::vector<std::size_t> numbers;  ///< numbers of result.curves among the run's curves
  std::vector<CurveFailure> failures;
  CoordinateFrame frame;  ///< of the mesh
  SnappedDrawing moved;   ///< moves of the curves onto the mesh, without curves

  [[nodiscard]] bool cancelled() const;
};

/// A mesh and the memory to work on it, kept from run to run. One thread at a time.
class Workspace {
 public:
  /// Independent curves are distributed among `threads`, which does not change results.
  Workspace(MeshFromFile mesh, std::size_t threads);

  /// Reads the curves and smooths them, as one set or separately. `options` must have passed
  /// check_method(). Throws Error for failures that concern all curves. If there are several
  /// threads, `progress` is called from them.
  RunOutcome smooth(const SmoothOptions& options, const Progress& progress);

 private:
  MeshFromFile mesh_;
  DrawingReader reader_;
  std::vector<std::unique_ptr<CurveSmoother>> smoothers_;  ///< one per thread, made when needed
};

/// Writes the outputs and the report. Writes nothing if the run was cancelled or all curves failed.
void write_run(const SmoothOptions& options, const RunOutcome& outcome);

}  // namespace talweg::driver
