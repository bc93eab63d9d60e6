// tau_sweep MESH CURVE: smoothness against closeness, as a table. Threads share the opened mesh;
// each has a smoother of its own. The table is the same for any number of threads.
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <exception>
#include <memory>
#include <thread>
#include <vector>

#include <talweg/talweg.hpp>

namespace {

const std::vector<double> kTaus = {0, 0.125, 0.25, 0.5, 1, 2, 4, 8, 16, 32};

/// Smooths for every tau that nobody has taken yet.
void work(const std::shared_ptr<const talweg::OpenedMesh>& opened,
          const talweg::SurfaceCurve& drawn, std::atomic<std::size_t>& next,
          std::vector<talweg::SmoothingReport>& reports) {
  talweg::CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  for (std::size_t i = next++; i < kTaus.size(); i = next++) {
    reports[i] = smoother.smooth(kTaus[i]).report();
  }
}

int run(const char* mesh_file, const char* curve_file) {
  const auto opened = talweg::OpenedMesh::open(talweg::read_mesh(mesh_file));
  const talweg::SnappedCurve snapped =
      talweg::snap(opened->mesh(), talweg::read_curves(curve_file).front());
  const talweg::SurfaceCurve drawn =
      talweg::StraightLines(opened->surface()).join(snapped.points, snapped.closed);

  std::vector<talweg::SmoothingReport> reports(kTaus.size());
  std::vector<std::exception_ptr> errors(std::clamp(std::thread::hardware_concurrency(), 1U, 8U));
  std::atomic<std::size_t> next = 0;
  std::vector<std::thread> threads;
  for (std::exception_ptr& error : errors) {
    threads.emplace_back([&] {
      try {
        work(opened, drawn, next, reports);
      } catch (...) {
        error = std::current_exception();
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::exception_ptr& error : errors) {
    if (error) std::rethrow_exception(error);
  }

  std::printf("%8s %12s %12s %12s %12s\n", "tau", "length", "curvature", "deviation", "");
  for (const talweg::SmoothingReport& r : reports) {
    std::printf("%8g %12.6g %12.6g %12.6g %12s\n", r.tau, r.after.length, r.after.total_curvature,
                r.deviation_from_drawn_max, to_string(r.termination));
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc == 3) return run(argv[1], argv[2]);
  std::fprintf(stderr, "usage: tau_sweep MESH CURVE\n");
  return 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
