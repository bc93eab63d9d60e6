// The time of a change of tau through the plugin interface, beside the time in the library itself.
//   talweg-plugin-overhead MESH CURVE [ROUNDS]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <span>
#include <vector>

#include "talweg/core/drawing/placed_curve.hpp"
#include "talweg/core/drawing/snapping.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/io/curve_file.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"
#include "talweg/intrinsic/stopwatch.hpp"
#include "talweg/loader/talweg_loader.h"
#include "talweg/plugin/talweg_host.hpp"

namespace {

using namespace talweg;

/// Processor time of this process, ms, so that other programs on the machine do not count.
double cpu_ms() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

host::Curve as_host_curve(const SurfaceMesh& mesh, const SurfaceCurve& curve) {
  host::Curve result;
  result.closed = curve.closed;
  for (const FaceCoordinates& at : place(mesh, curve).faces) {
    result.faces.push_back(static_cast<std::uint32_t>(at.face.index()));
    result.barycentrics.push_back(at.barycentric);
  }
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return std::fputs("usage: MESH CURVE [ROUNDS]\n", stderr), 1;
  const int rounds = argc > 3 ? std::atoi(argv[3]) : 25;
  const MeshLists lists = read_mesh(argv[1]);
  const auto opened = OpenedMesh::open(lists);
  StraightLines lines(opened->surface());
  const SnappedCurve snapped = snap(opened->mesh(), read_curves(argv[2])).front();
  const SurfaceCurve drawn = lines.join(snapped.points, snapped.closed);
  CurveSmoother library(opened);
  library.set_curve(drawn);

  talweg_loader* loader = talweg_loader_open(nullptr);
  const talweg_plugin* plugin = talweg_loader_find(loader, "talweg.smooth");
  if (plugin == nullptr) return std::fputs("no talweg.smooth\n", stderr), 1;
  {
    const host::Services services("talweg-plugin-overhead", "1", [](auto, auto) { return true; });
    host::Instance instance(*plugin, services);
    const Stopwatch watch;
    instance.set_mesh(host::view(lists.points.front().data(), lists.points.size(), 3),
                      host::view(lists.triangles.front().data(), lists.triangles.size(), 3));
    std::printf("%zu faces, set_mesh %.1f ms (OpenedMesh::open %.1f ms)\n", lists.triangles.size(),
                watch.ms(), opened->open_ms());
    instance.set_curves({as_host_curve(opened->mesh(), drawn)});
    std::printf("%8s %12s %12s %12s  (CPU ms, medians of %d)\n", "tau", "library", "interface",
                "more", rounds);
    for (const double tau : {0.5, 1.0, 2.0, 5.0, 10.0}) {
      std::vector<double> by_library, by_interface, more;
      std::size_t points = 0;
      for (int k = 0; k < rounds; ++k) {
        // The slack differs from that of the last round, so that no result is reused.
        const double slack = library.slack().front() * (1 + 1e-9 * k);
        SmoothingOptions options;
        options.tau = tau;
        options.slack = slack;
        double start = cpu_ms();
        points = library.smooth(options).curves.front().points.size();
        by_library.push_back(cpu_ms() - start);
        start = cpu_ms();
        instance.set("tau", tau);
        instance.set("slack", slack);
        const host::Results results = instance.run();
        by_interface.push_back(cpu_ms() - start);
        more.push_back(by_interface.back() - by_library.back());
        if (results.curves.front().faces.size() != points) return 1;
      }
      std::printf("%8g %12.3f %12.3f %12.3f  %zu points\n", tau, median(by_library),
                  median(by_interface), median(more), points);
    }
  }
  talweg_loader_close(loader);
}
