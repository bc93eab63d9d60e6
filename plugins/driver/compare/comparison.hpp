// A comparison runs several methods on one drawing and measures all in the same way.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compare/methods.hpp"
#include "drawing_file.hpp"
#include "repaired_mesh.hpp"
#include "talweg/core/drawing/placed_curve.hpp"
#include "talweg/core/measure/surface_deviation.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg::driver {

/// The measures of curves. Angles in radians, lengths in mesh units.
struct CurveNumbers {
  std::size_t curves = 0, points = 0;
  double length = 0;
  double curvature = 0, largest_turn = 0;  ///< radians
  double bending = 0, window_turning = 0;  ///< with the mean edge near the drawing
  std::size_t contacts = 0;                ///< places where the curves touch or cross
  std::vector<std::int64_t> pieces, bare;  ///< from pieces_along(), with and without spikes
};

/// A method with one value of its parameter.
struct ComparedRun {
  std::size_t method = 0;       ///< index
  std::optional<double> value;  ///< of the swept parameter; none for the method's default
  std::string refusal;          ///< the method's error message; then nothing else is set
  std::vector<PlacedCurve> curves;
  CurveNumbers numbers;
  double to_drawn = 0, to_drawn_mean = 0;      ///< mesh units, along the surface
  double from_drawn = 0, from_drawn_mean = 0;  ///< mesh units
  double first_ms = 0;                         ///< from the mesh's lists to the result
  std::optional<double> again_ms;              ///< the same run once more; not in a sweep
  std::string changed;  ///< how the curve's topology changed; empty if it did not

  [[nodiscard]] bool ok() const { return refusal.empty() && changed.empty(); }
  /// The larger of both ways, mesh units.
  [[nodiscard]] double deviation() const { return std::max(to_drawn, from_drawn); }
};

struct Comparison {
  std::string mesh, curve;  ///< files
  std::size_t faces = 0;
  double edge = 0;  ///< mean edge near the drawing, mesh units
  CurveNumbers drawn;
  std::vector<PlacedCurve> drawing;
  std::vector<Method> methods;
  std::vector<ComparedRun> runs;  ///< by method, in the order of its values
};

struct CompareOptions {
  std::vector<Method> methods;
  bool sweep = false;
  Progress progress;
};

/// In a sweep, if other methods beat the default in the steps of its own parameter, the default is
/// also run with exactly their deviation as a bound (bounded_method()). A method's refusal is
/// stored in its run.
Comparison compare_methods(const ReadMesh& mesh, const SnappedDrawing& drawing,
                           const SurfaceMesh& surface, const CompareOptions& options);

}  // namespace talweg::driver
