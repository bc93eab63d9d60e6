// talweg-session: the times that a user waits for at a slider, on given meshes and drawings.
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
constexpr int kSteps = 6;  // of a dragged click, an edge each

double shortest(const std::function<void()>& run) {
  double least = HUGE_VAL;
  for (int k = 0; k < kRepeat; ++k) least = std::min(least, mean_ms(1, run));
  return least;
}

struct Waits {
  double drawn = 0;
  std::vector<double> moves;  // of tau, ascending
};

/// Times of a new drawing and of changes of tau. Legs are kept from one drawing to the next, so a
/// drawing without common legs is set before.
Waits waits(CurveSmoother& smoother, const SurfaceCurve& curve, const CurveOptions& drawing,
            const CurveOptions& before, SmoothingOptions& options) {
  Waits waits;
  waits.drawn = HUGE_VAL;
  for (int k = 0; k < kRepeat; ++k) {
    smoother.set_curve(curve, before);
    smoother.smooth(options);
    waits.drawn = std::min(waits.drawn, mean_ms(1, [&] {
                             smoother.set_curve(curve, drawing);
                             smoother.smooth(options);
                           }));
  }
  for (double tau = 1.01; tau < 1.9; tau *= 1.05) {
    options.tau = tau;
    waits.moves.push_back(shortest([&] { smoother.smooth(options); }));
  }
  std::sort(waits.moves.begin(), waits.moves.end());
  return waits;
}

/// The points of the drawing that are clicks, the path between them being their legs. They are
/// `aside` points farther on, but for the ends of an open drawing.
std::vector<std::size_t> clicked(const SurfaceCurve& curve, std::size_t aside = 0) {
  std::vector<std::size_t> points;
  const std::size_t n = curve.points.size(), gaps = curve.closed ? kClicks : kClicks - 1;
  for (std::size_t k = 0; k < kClicks; ++k) {
    const bool is_end = !curve.closed && (k == 0 || k == gaps);
    points.push_back(std::min(k * n / gaps + (is_end ? 0 : aside), n - 1));
  }
  return points;
}

CurveOptions clicks_on(const SurfaceCurve& curve, std::size_t aside = 0) {
  CurveOptions options;
  for (const std::size_t i : clicked(curve, aside)) options.way_points.push_back({curve.points[i]});
  return options;
}

/// One click, in the middle, is moved aside from edge to edge; the time of the
/// median step.
double dragged_click(CurveSmoother& smoother, const SurfaceCurve& curve, EdgeDijkstra& dijkstra,
                     const SmoothingOptions& options) {
  const SurfaceMesh& mesh = smoother.opened().mesh();
  std::vector<Drawing> steps;
  for (int aside = 1; aside <= kSteps; ++aside) {
    const DraggedPoint dragged(mesh, curve, clicked(curve), aside);
    Drawing& step = steps.emplace_back(Drawing{dragged.redraw(dijkstra), {}});
    for (const VertexId v : dragged.through()) {
      step.way_points.push_back({SurfacePoint::at_vertex(mesh.surface(), v)});
    }
  }
  std::vector<double> times(steps.size(), HUGE_VAL);
  for (int k = 0; k <= kRepeat; ++k) {  // the first round allocates the memory
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const double time = mean_ms(1, [&] { smoother.drag(0, steps[i], options); });
      if (k > 0) times[i] = std::min(times[i], time);
    }
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
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
  const Waits strokes = waits(smoother, curve, {}, clicks_on(curve), options);
  EdgeDijkstra dijkstra(opened->surface());
  const DraggedPoint dragged(opened->mesh(), curve, kLeg);
  const auto drag = [&] { smoother.drag(0, dragged.redraw(dijkstra), options); };
  drag();  // allocates the memory
  const double dragging = shortest(drag);
  options.tau = 1;
  const Waits clicks = waits(smoother, curve, clicks_on(curve), clicks_on(curve, 1), options);
  options.tau = 1;
  const double dragged_one = dragged_click(smoother, curve, dijkstra, options);
  std::printf("| %s | %zu | %.1f | %.1f | %.1f | %.1f | %.1f | %.1f | %.1f |\n",
              std::filesystem::path(mesh).stem().string().c_str(), curve.points.size(),
              strokes.drawn, strokes.moves[strokes.moves.size() / 2], strokes.moves.back(),
              dragging, clicks.drawn, clicks.moves[clicks.moves.size() / 2], dragged_one);
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
        "| drag a click |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|\n",
        talweg::benchmarks::kRepeat, talweg::benchmarks::kClicks);
    for (int k = 1; k < argc; k += 2) talweg::benchmarks::print_row(argv[k], argv[k + 1]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
