// talweg-scale: the growth of times and memory with the mesh. The edges of one mesh are halved
// again and again; prints a Markdown table of the default method for a drawing along the edges of
// each mesh.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include "talweg/core/drawing/curve_through.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/core/io/mesh_writer.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg::benchmarks {
namespace {

using Path = std::vector<VertexId>;
namespace fs = std::filesystem;

/// Halves every edge: vertex n + e is the middle of edge e. The path gets the middles of its edges.
MeshLists halved(const MeshLists& mesh, Path& path) {
  const Surface surface = Surface::from_triangles(mesh.points.size(), mesh.triangles);
  const std::size_t n = mesh.points.size();
  const auto middle = [&](HalfedgeId h) {
    return static_cast<std::uint32_t>(n + edge_of(h).index());
  };
  MeshLists finer;
  finer.points.reserve(n + surface.edge_count());
  finer.points = mesh.points;
  for (std::size_t e = 0; e < surface.edge_count(); ++e) {
    const HalfedgeId h = halfedge_of(EdgeId{e});
    finer.points.push_back(
        (mesh.points[surface.tail(h).index()] + mesh.points[surface.head(h).index()]) / 2);
  }
  finer.triangles.reserve(4 * surface.face_count());
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    std::array<std::uint32_t, 3> corner{}, side{};
    HalfedgeId h = surface.halfedge(FaceId{f});
    for (std::size_t k = 0; k < 3; ++k, h = surface.next(h)) {
      corner[k] = static_cast<std::uint32_t>(surface.tail(h).index());
      side[k] = middle(h);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      finer.triangles.push_back({corner[k], side[k], side[(k + 2) % 3]});
    }
    finer.triangles.push_back(side);
  }
  Path longer;
  for (std::size_t i = 0; i < path.size(); ++i) {
    longer.push_back(path[i]);
    if (i + 1 == path.size()) break;
    longer.emplace_back(middle(surface.find_halfedge(path[i], path[i + 1])));
  }
  path = std::move(longer);
  return finer;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

template <class Work>
double ms_of(const Work& work) {
  const Stopwatch watch;
  work();
  return watch.ms();
}

SmoothingOptions at_tau(double tau, double slack_factor, const CurveSmoother& smoother) {
  SmoothingOptions options;
  options.tau = tau;
  options.slack = slack_factor * smoother.slack().front();
  options.deviation = DeviationMeasure::kNone;
  return options;
}

/// One line of the table.
void measure(const fs::path& file, const Path& path, double slack_factor) {
  MeshLists lists;
  const double load = ms_of([&] { lists = read_mesh(file); });
  std::shared_ptr<const OpenedMesh> opened;
  const double open = ms_of([&] { opened = OpenedMesh::open(std::move(lists)); });
  const SurfaceCurve curve = curve_through(opened->surface(), path);
  std::unique_ptr<CurveSmoother> smoother;
  const double workspace = ms_of([&] { smoother = std::make_unique<CurveSmoother>(opened); });
  SmoothingResult result;
  const auto new_curve = [&] {
    smoother->set_curve(curve);
    result = smoother->smooth(at_tau(1, slack_factor, *smoother));
  };
  const double first = ms_of(new_curve);
  std::vector<double> again, moves;
  for (int k = 0; k < 5; ++k) again.push_back(ms_of(new_curve));
  const std::size_t touched = result.report().faces_touched;
  for (int k = 0; k < 20; ++k) {
    const SmoothingOptions options = at_tau(0.7 + 0.06 * ((7 * k) % 20), slack_factor, *smoother);
    moves.push_back(ms_of([&] { smoother->smooth(options); }));
  }
  fmt::print(
      "| {} | {} | {:g} | {} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {:.2f} | {:.0f} |\n",
      opened->surface().face_count(), path.size(), slack_factor, touched, load, open, workspace,
      first, median(again), median(moves), peak_memory_mib());
  std::fflush(stdout);
}

/// In a process of its own, whose peak memory is that of this work alone.
template <class Work>
void apart(const Work& work) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child < 0) std::exit(5);
  if (child == 0) {
    try {
      work();
    } catch (const std::exception& error) {
      std::fprintf(stderr, "talweg-scale: %s\n", error.what());
      std::fflush(stdout);
      _exit(2);
    }
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (status != 0) std::exit(5);
}

Path read_path(const fs::path& file) {
  Path path;
  std::ifstream in(file);
  for (std::size_t v = 0; in >> v;) path.emplace_back(v);
  return path;
}

void write_path(const fs::path& file, const Path& path) {
  std::ofstream out(file);
  for (const VertexId v : path) out << v.index() << '\n';
}

int run(const fs::path& mesh, const fs::path& path, int levels) {
  const fs::path folder = fs::temp_directory_path() / fmt::format("talweg-scale-{}", getpid());
  fs::create_directory(folder);
  std::puts(
      "| faces | points | slack | touched | load | open | workspace | first | again | new tau | "
      "MiB |"
      "\n|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|");
  const std::size_t points = read_path(path).size();
  for (int level = 0; level <= levels; ++level) {
    const fs::path now = folder / fmt::format("{}.ply", level);
    const fs::path drawn = folder / fmt::format("{}.txt", level);
    apart([&] {
      Path longer = read_path(level == 0 ? path : folder / fmt::format("{}.txt", level - 1));
      MeshLists lists = read_mesh(level == 0 ? mesh : folder / fmt::format("{}.ply", level - 1));
      if (level > 0) lists = halved(lists, longer);
      write_mesh(now, lists);
      write_path(drawn, longer);
    });
    const Path whole = read_path(drawn);
    // The same number of points everywhere, then the same length; and wider bands.
    apart([&] { measure(now, Path(whole.begin(), whole.begin() + points), 1); });
    if (level > 0) apart([&] { measure(now, whole, 1); });
    if (level > 3) continue;  // smaller meshes show the cost of wide bands
    for (const double factor : {2.0, 4.0}) apart([&] { measure(now, whole, factor); });
  }
  fs::remove_all(folder);
  return 0;
}

}  // namespace
}  // namespace talweg::benchmarks

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fputs("usage: talweg-scale MESH VERTICES LEVELS\n", stderr);
    return 1;
  }
  try {
    return talweg::benchmarks::run(argv[1], argv[2], std::atoi(argv[3]));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "talweg-scale: %s\n", error.what());
    return 2;
  }
}
