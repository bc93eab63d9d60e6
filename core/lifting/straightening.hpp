// Straightening makes drawn curves geodesic in any metric and traces them back onto the surface.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "talweg/core/drawing/curve_embedding.hpp"
#include "talweg/core/measure/report.hpp"
#include "talweg/intrinsic/flips/flip_out.hpp"
#include "talweg/intrinsic/flips/signpost_triangulation.hpp"
#include "talweg/intrinsic/flips/trace.hpp"

namespace talweg {

/// The result of straightening one curve.
struct StraightenedPath {
  double length_before = 0;  ///< in the metric
  double length_after = 0;   ///< in the metric
  Termination termination = Termination::kConverged;
};

/// The work of a straightening, summed over all curves.
struct StraighteningCounts {
  std::size_t flips = 0;
  std::size_t iterations = 0;
  std::size_t blocked = 0;  ///< joints that stay bent because of another path in their wedge
  std::size_t clamped = 0;  ///< crossings that the tracing put at the end of their edge
  std::size_t faces_touched = 0;
};

/// Geodesics in the lifted surface, traced back onto the mesh.
struct Straightened {
  std::vector<SurfaceCurve> curves;
  std::vector<StraightenedPath> paths;  ///< one for each curve
  StraighteningCounts counts;
  std::vector<VertexId> touched;  ///< vertices whose directions were computed
  bool at_fence = false;          ///< see EmbeddedDrawing::Ground; set by EmbeddedDrawing
  StageTimes time_ms;             ///< straighten, trace
};

/// The triangulation of a surface with embedded curves. The memory is allocated once; a run costs
/// only the elements that it touches, and leaves the triangulation unchanged.
class Straightening {
 public:
  /// O(surface). The surface must outlive this object.
  explicit Straightening(const Surface& surface);

  /// Replaces the embedded curves by `curves`. Arguments and errors are as in embed_curves(); no
  /// curves are embedded after an error.
  void embed(std::span<const SurfaceCurve> curves, std::span<const SurfacePoint> pins, Loops loops,
             std::span<const std::size_t> names, const Progress& progress);
  void clear();

  /// The embedded curves.
  [[nodiscard]] const std::vector<EdgePath>& paths() const { return embedded_.paths; }

  /// Limits of FlipOut; `pinned` is filled in by run().
  struct Options {
    FlipOutOptions flip_out;
    bool prepare_whole_mesh = false;  ///< compute all directions first; slower, same result
    friend bool operator==(const Options&, const Options&) = default;
  };
  /// Straightens the curves in a metric on the edges; the metric is not needed afterwards. Throws
  /// Cancelled.
  Straightened run(SignpostTriangulation::Metric metric, Options options, const Progress& progress);

  /// Interpolates per-vertex values (k per row) at the inserted vertices, linearly in each face.
  [[nodiscard]] std::vector<double> at_inserted(std::span<const double> values,
                                                std::size_t k) const;

  /// For each of these curves (not the embedded ones) the number of crossings with itself and with
  /// the curves after it. No curves may be embedded. Throws Cancelled.
  std::vector<std::size_t> crossings_of(std::span<const SurfaceCurve> curves,
                                        const Progress& progress);

  [[nodiscard]] const SignpostTriangulation& triangulation() const { return triangulation_; }

 private:
  Straightened straightened(const Options& options, const Progress& progress);

  SignpostTriangulation triangulation_;
  FlipOut flip_out_;
  Tracer tracer_;
  EmbeddedCurves embedded_;
};

}  // namespace talweg
