// smooth_file MESH CURVE RESULT [TAU]: a small `talweg smooth`, with progress, Ctrl-C and errors.
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <vector>

#include <talweg/talweg.hpp>

namespace {

volatile std::sig_atomic_t g_interrupted = 0;

/// The curves of a file, put on the mesh and joined straight where points are far apart.
std::vector<talweg::SurfaceCurve> read_drawing(const char* path, const talweg::SurfaceMesh& mesh) {
  std::vector<talweg::SurfaceCurve> curves;
  talweg::StraightLines lines(mesh.surface());
  for (const talweg::SnappedCurve& snapped : talweg::snap(mesh, talweg::read_curves(path))) {
    if (snapped.largest_snap_distance > 0) {
      std::printf("moved onto the mesh by up to %g\n", snapped.largest_snap_distance);
    }
    curves.push_back(lines.join(snapped.points, snapped.closed));
  }
  return curves;
}

int run(int argc, char** argv) {
  const auto opened = talweg::OpenedMesh::open(talweg::read_mesh(argv[1]));
  const talweg::Progress progress = [](const char* stage, double fraction) {
    std::fprintf(stderr, "\r%-12s %3.0f %%", stage, 100 * fraction);
    return g_interrupted == 0;
  };

  talweg::CurveSmoother smoother(opened);
  if (!smoother.set_curves(read_drawing(argv[2], opened->mesh()), {}, progress)) return 4;

  talweg::SmoothingOptions options;
  options.tau = argc > 4 ? std::atof(argv[4]) : 1;
  const talweg::SmoothingResult result = smoother.smooth(options, progress);
  std::fprintf(stderr, "\n");

  for (std::size_t i = 0; i < result.reports.size(); ++i) {
    const talweg::SmoothingReport& r = result.reports[i];
    std::printf("curve %zu: %s, length %g -> %g, curvature %g -> %g rad, off by %g at most\n", i,
                to_string(r.termination), r.before.length, r.after.length, r.before.total_curvature,
                r.after.total_curvature, r.deviation_from_drawn_max);
    for (const std::string& warning : r.warnings) std::printf("  %s\n", warning.c_str());
  }
  if (result.report().termination == talweg::Outcome::kCancelled) return 4;
  talweg::write_curves(argv[3], opened->mesh(), result.curves);
  return result.report().termination == talweg::Outcome::kConverged ? 0 : 3;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4 || argc > 5) {
    std::fprintf(stderr, "usage: smooth_file MESH CURVE RESULT [TAU]\n");
    return 1;
  }
  std::signal(SIGINT, [](int) { g_interrupted = 1; });
  try {
    return run(argc, argv);
  } catch (const talweg::Error& error) {  // the sentence is fit for users
    std::fprintf(stderr, "%s\n", error.what());
    return error.code() == talweg::ErrorCode::kBadUsage ? 1 : 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "internal error: %s\n", error.what());
    return 5;
  }
}
