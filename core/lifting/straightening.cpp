#include "talweg/core/lifting/straightening.hpp"

#include <utility>

#include "talweg/core/drawing/crossings.hpp"
#include "talweg/core/measure/result_report.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg {

Straightening::Straightening(const Surface& surface)
    : triangulation_(surface), flip_out_(triangulation_), tracer_(triangulation_) {}

void Straightening::embed(std::span<const SurfaceCurve> curves, std::span<const SurfacePoint> pins,
                          Loops loops, std::span<const std::size_t> names,
                          const Progress& progress) {
  clear();
  embedded_ = embed_curves(triangulation_, curves, pins, loops, names, progress);
}

void Straightening::clear() {
  triangulation_.remove_inserted();
  embedded_ = {};
}

Straightened Straightening::run(SignpostTriangulation::Metric metric, Options options,
                                const Progress& progress) {
  triangulation_.set_metric(std::move(metric));
  options.flip_out.pinned = embedded_.pinned;
  try {
    Straightened result = straightened(options, progress);
    triangulation_.set_metric({});
    return result;
  } catch (...) {  // usually Cancelled, at any point
    while (triangulation_.flip_count() > 0) triangulation_.undo_flip();
    triangulation_.set_metric({});
    throw;
  }
}

Straightened Straightening::straightened(const Options& options, const Progress& progress) {
  Stopwatch watch;
  Straightened result;
  if (options.prepare_whole_mesh) triangulation_.prepare_all();
  const FlipOutResult straight = flip_out_.run(embedded_.paths, options.flip_out, progress);
  result.time_ms.straighten = watch.lap();

  std::vector<EdgePath> paths;
  for (const FlipOutResult::Path& path : straight.paths) {
    if (path.termination == Termination::kCancelled) throw Cancelled();
    paths.push_back(path.path);
    result.paths.push_back({path.length_before, path.length_after, path.termination});
  }
  TraceResult traced = tracer_.trace_and_undo(paths, progress);
  result.time_ms.trace = watch.ms();
  result.curves = std::move(traced.curves);
  result.counts = {straight.flips, straight.iterations, straight.blocked, traced.clamped,
                   count_touched_faces(triangulation_)};
  const auto touched = triangulation_.touched();
  result.touched.assign(touched.begin(), touched.end());
  return result;
}

std::vector<double> Straightening::at_inserted(std::span<const double> values,
                                               std::size_t k) const {
  const Surface& surface = triangulation_.surface();
  std::vector<double> result;
  for (std::size_t i = 0; i < triangulation_.inserted_count(); ++i) {
    const SurfacePoint point = triangulation_.location(VertexId{surface.vertex_count() + i});
    const FaceCoordinates at = coordinates_in(surface, point, any_face(surface, point));
    const auto corners = surface.corners(at.face);
    for (std::size_t j = 0; j < k; ++j) {
      double value = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        if (at.barycentric[c] > 0) value += at.barycentric[c] * values[corners[c].index() * k + j];
      }
      result.push_back(value);
    }
  }
  return result;
}

std::vector<std::size_t> Straightening::crossings_of(std::span<const SurfaceCurve> curves,
                                                     const Progress& progress) {
  std::vector<std::size_t> crossings(curves.size(), 0);
  try {
    const EmbeddedCurves embedded =
        embed_curves(triangulation_, curves, {}, Loops::kKeep, {}, progress);
    crossings = path_contacts(triangulation_, embedded.paths).crossings;
  } catch (const Error&) {  // a loop of less than three edges, which has no crossings
  } catch (...) {
    triangulation_.remove_inserted();
    throw;
  }
  triangulation_.remove_inserted();
  return crossings;
}

}  // namespace talweg
