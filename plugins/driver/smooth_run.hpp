// One run of `talweg smooth`: the curves of one mesh, read, smoothed and written.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "drawing_file.hpp"
#include "failure.hpp"
#include "smooth_options.hpp"
#include "talweg/core/curve_smoother.hpp"

namespace talweg::driver {

/// A mesh, opened, and how it was read.
struct MeshFromFile {
  std::shared_ptr<const OpenedMesh> opened;
  double load_ms = 0;
  std::size_t polygons = 0;  ///< that were split into triangles
};

/// Throws Error as read_mesh() and OpenedMesh::open() do.
MeshFromFile load_mesh(const std::string& path);

/// A curve that could not be smoothed.
struct CurveFailure {
  std::size_t curve = 0;  ///< its number among the run's curves, from 0
  Failure why;
};

/// `result.curves` lacks the curves that failed; only independent curves fail one by one.
struct RunOutcome {
  SmoothingResult result;
  std::vector<std::size_t> numbers;  ///< of result.curves among the run's curves
  std::vector<CurveFailure> failures;

  [[nodiscard]] bool cancelled() const;
};

/// A mesh and the memory to work on it, kept from run to run. One thread at a time.
class Workspace {
 public:
  /// Independent curves are shared out among `threads`; that changes no result.
  Workspace(MeshFromFile mesh, std::size_t threads);

  /// Reads the curves and smooths them, as one set or each by itself. `options` are after
  /// choose_method(). Throws Error for what concerns all curves. `progress` is called from several
  /// threads where there are several.
  RunOutcome smooth(const SmoothOptions& options, const Progress& progress);

  [[nodiscard]] const SurfaceMesh& mesh() const { return mesh_.opened->mesh(); }

 private:
  MeshFromFile mesh_;
  DrawingReader reader_;
  std::vector<std::unique_ptr<CurveSmoother>> smoothers_;  ///< one per thread, made when needed
};

/// Writes the outputs and the report. Nothing where the run was cancelled or no curve is left.
void write_run(const SmoothOptions& options, const SurfaceMesh& mesh, const RunOutcome& outcome);

}  // namespace talweg::driver
