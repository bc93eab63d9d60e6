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
constexpr std::size_t kLeg = 20;

double shortest(const std::function<void()>& run) {
  double least = HUGE_VAL;
  for (int k = 0; k < kRepeat; ++k) least = std::min(least, mean_ms(1, run));
  return least;
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
  const double drawn = shortest([&] {
    smoother.set_curve(curve);
    smoother.smooth(options);
  });
  std::vector<double> moves;
  for (double tau = 1.01; tau < 1.9; tau *= 1.05) {
    options.tau = tau;
    moves.push_back(shortest([&] { smoother.smooth(options); }));
  }
  std::sort(moves.begin(), moves.end());
  EdgeDijkstra dijkstra(opened->surface());
  const DraggedPoint dragged(opened->mesh(), curve, kLeg);
  const auto drag = [&] { smoother.drag(0, dragged.redraw(dijkstra), options); };
  drag();  // makes the memory for it
  std::printf("| %s | %zu | %.1f | %.1f | %.1f | %.1f |\n",
              std::filesystem::path(mesh).stem().string().c_str(), curve.points.size(), drawn,
              moves[moves.size() / 2], moves.back(), shortest(drag));
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
        "| mesh | drawn | new drawing | new tau, median | largest | drag a point |\n"
        "|---|--:|--:|--:|--:|--:|\n",
        talweg::benchmarks::kRepeat);
    for (int k = 1; k < argc; k += 2) talweg::benchmarks::print_row(argv[k], argv[k + 1]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
