// talweg-session: what somebody at a slider waits for, on given meshes and drawings.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "dragged_point.hpp"
#include "measured_apart.hpp"
#include "talweg/core/drawing/edge_dijkstra.hpp"
#include "talweg/core/drawing/snapping.hpp"
#include "talweg/core/io/curve_file.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"

namespace talweg::benchmarks {
namespace {

constexpr int kRepeat = 9;  // the shortest counts
constexpr std::size_t kLeg = 20, kClicks = 30;

double shortest(const std::function<void()>& run) {
  double least = HUGE_VAL;
  for (int k = 0; k < kRepeat; ++k) least = std::min(least, mean_ms(1, run));
  return least;
}

struct Waits {
  double drawn = 0;
  std::vector<double> moves;  // of tau, ascending
};

/// A new drawing, and moves of tau.
Waits waits(CurveSmoother& smoother, const SurfaceCurve& curve, const CurveOptions& drawing,
            SmoothingOptions& options) {
  Waits waits;
  waits.drawn = shortest([&] {
    smoother.set_curve(curve, drawing);
    smoother.smooth(options);
  });
  for (double tau = 1.01; tau < 1.9; tau *= 1.05) {
    options.tau = tau;
    waits.moves.push_back(shortest([&] { smoother.smooth(options); }));
  }
  std::sort(waits.moves.begin(), waits.moves.end());
  return waits;
}

/// Every so many points of the drawing as clicks, the path between them as their legs.
CurveOptions clicks_on(const SurfaceCurve& curve) {
  CurveOptions options;
  const std::size_t n = curve.points.size(), gaps = curve.closed ? kClicks : kClicks - 1;
  for (std::size_t k = 0; k < kClicks; ++k) {
    options.way_points.push_back({curve.points[std::min(k * n / gaps, n - 1)]});
  }
  return options;
}

void print_row(const std::string& mesh, const std::string& drawing) {
  const auto opened = OpenedMesh::open(read_mesh(mesh));
  SurfaceCurve curve;
  const SnappedCurve snapped = snap(opened->mesh(), read_curves(drawing).front());
  curve.closed = snapped.closed;
  curve.points = snapped.points;
  CurveSmoother smoother(opened);
  SmoothingOptions options;
  options.deviation = DeviationMeasure::kNone;
  const Waits strokes = waits(smoother, curve, {}, options);
  EdgeDijkstra dijkstra(opened->surface());
  const DraggedPoint dragged(opened->mesh(), curve, kLeg);
  const auto drag = [&] { smoother.drag(0, dragged.redraw(dijkstra), options); };
  drag();  // makes the memory for it
  const double dragging = shortest(drag);
  options.tau = 1;
  const Waits clicks = waits(smoother, curve, clicks_on(curve), options);
  std::printf("| %s | %zu | %.1f | %.1f | %.1f | %.1f | %.1f | %.1f |\n",
              std::filesystem::path(mesh).stem().string().c_str(), curve.points.size(),
              strokes.drawn, strokes.moves[strokes.moves.size() / 2], strokes.moves.back(),
              dragging, clicks.drawn, clicks.moves[clicks.moves.size() / 2]);
}

}  // namespace
}  // namespace talweg::benchmarks

// usage: talweg-session MESH CURVE [MESH CURVE]...; drawings along mesh edges
int main(int argc, char** argv) {
  if (argc < 3 || argc % 2 == 0) {
    std::fprintf(stderr, "usage: talweg-session MESH CURVE [MESH CURVE]...\n");
    return 1;
  }
  try {
    std::printf(
        "Processor time of one thread, ms, the shortest of %d; without the deviation.\n\n"
        "| mesh | drawn | new drawing | new tau, median | largest | drag a point | %zu clicks | "
        "new tau "
        "|\n|---|--:|--:|--:|--:|--:|--:|--:|\n",
        talweg::benchmarks::kRepeat, talweg::benchmarks::kClicks);
    for (int k = 1; k < argc; k += 2) talweg::benchmarks::print_row(argv[k], argv[k + 1]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
