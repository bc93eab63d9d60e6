// talweg-peer-table: times of a session at about a million faces, compared with CGAL's heat method.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cgal_heat.hpp"
#include "dragged_point.hpp"
#include "measured_apart.hpp"
#include "talweg/core/drawing/edge_dijkstra.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"
#include "talweg/heat/curve_sources.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "tools/paper/ball.hpp"
#include "tools/paper/hand.hpp"

namespace talweg::benchmarks {
namespace {

constexpr std::size_t kDrawnVertices = 1500;
constexpr std::uint32_t kMillion = 223;  // frequency of a ball of 994,580 faces
constexpr std::uint32_t kSmall = 50;     // of 50,000, where exact distances are cheap

MeshLists lists_of(const std::string& mesh) {
  return mesh.empty() ? paper::bumpy_ball(kMillion, 1) : read_mesh(mesh);
}

std::vector<double> draw(const MeshLists& lists, std::size_t count) {
  const auto opened = OpenedMesh::open(lists);
  std::vector<double> vertices{static_cast<double>(lists.triangles.size())};
  for (const SurfacePoint& point : paper::tour(*opened, count, 1).points) {
    vertices.push_back(static_cast<double>(std::get<AtVertex>(point.where()).vertex.index()));
  }
  return vertices;
}

SurfaceCurve curve_of(const Surface& surface, const std::vector<std::uint32_t>& vertices) {
  SurfaceCurve curve;
  for (const std::uint32_t v : vertices) {
    curve.points.push_back(SurfacePoint::at_vertex(surface, VertexId{v}));
  }
  return curve;
}

SmoothingOptions at(double tau) {
  SmoothingOptions options;
  options.tau = tau;
  options.deviation = DeviationMeasure::kNone;
  return options;
}

/// Open, a new curve to its last point, a move of tau; for the full engine the distances alone too.
std::vector<double> session(const std::string& mesh, const std::vector<std::uint32_t>& vertices,
                            Method method, int repeat) {
  const MeshLists lists = lists_of(mesh);
  CurveOptions options;
  options.method = method;
  options.threads = 1;
  std::shared_ptr<const OpenedMesh> opened;
  std::optional<CurveSmoother> smoother;
  std::vector<double> ms;
  ms.push_back(mean_ms(repeat, [&] {
    smoother.reset();
    opened.reset();
    opened = OpenedMesh::open(lists);
    smoother.emplace(opened);
    if (method == Method::kPaper) (void)opened->heat(options.heat_time, {}, 1);
  }));
  const SurfaceCurve curve = curve_of(opened->surface(), vertices);
  ms.push_back(mean_ms(repeat, [&] {
    smoother->set_curve(curve, options);
    smoother->smooth(at(1));
  }));
  double tau = 1;
  ms.push_back(mean_ms(2 * repeat, [&] { smoother->smooth(at(tau += 0.9 / (2 * repeat))); }));
  if (method == Method::kCorridor) {
    EdgeDijkstra dijkstra(opened->surface());
    const DraggedPoint dragged(opened->mesh(), curve, 20);
    const auto drag = [&] { smoother->drag(0, dragged.redraw(dijkstra), at(tau)); };
    drag();  // allocates the memory
    ms.push_back(mean_ms(repeat, drag));
  } else {
    const auto heat = opened->heat(options.heat_time);
    const auto sources = curve_sources(opened->surface(), curve);
    const WeightedVertex one[] = {{VertexId{vertices.front()}, 1}};
    ms.push_back(mean_ms(repeat, [&] { (void)heat->solve(sources); }));
    ms.push_back(mean_ms(repeat, [&] { (void)heat->solve(one); }));
  }
  return ms;
}

std::vector<double> peer_session(const std::string& mesh,
                                 const std::vector<std::uint32_t>& vertices, int repeat) {
  CgalHeat heat(lists_of(mesh));
  const double open = mean_ms(repeat, [&] { heat.open(); });
  const double distance = mean_ms(repeat, [&] { heat.solve(vertices); });
  return {open, distance, mean_ms(repeat, [&] { heat.solve(std::span(vertices).first(1)); })};
}

/// Mean and largest error in percent of the largest distance: ours at s = 10 and s = 1, and CGAL's.
std::vector<double> errors() {
  const MeshLists lists = paper::bumpy_ball(kSmall, 1);
  const auto opened = OpenedMesh::open(lists);
  const Surface& surface = opened->surface();
  const SurfaceCurve curve = paper::tour(*opened, 400, 1);
  std::vector<std::uint32_t> vertices;
  for (const SurfacePoint& point : curve.points) {
    vertices.push_back(
        static_cast<std::uint32_t>(std::get<AtVertex>(point.where()).vertex.index()));
  }
  PolylineDistance exact(surface);
  exact.set(std::span(&curve, 1));
  std::vector<double> truth(surface.vertex_count());
  for (std::size_t v = 0; v < truth.size(); ++v) truth[v] = exact.at_vertex(VertexId{v}).distance;
  const double largest = *std::max_element(truth.begin(), truth.end());

  std::vector<double> result;
  const auto compare = [&](const std::vector<double>& distance) {
    double sum = 0, most = 0;
    for (std::size_t v = 0; v < truth.size(); ++v) {
      const double error = std::abs(distance[v] - truth[v]);
      sum += error;
      most = std::max(most, error);
    }
    result.push_back(100 * sum / static_cast<double>(truth.size()) / largest);
    result.push_back(100 * most / largest);
  };
  for (const double time_scale : {10.0, 1.0}) {
    compare(opened->heat(time_scale)->solve(curve_sources(surface, curve)));
  }
  CgalHeat peer(lists);
  peer.open();
  compare(peer.solve(vertices));
  return result;
}

void row(const char* stage, double ours, const char* goal, double peer = 0) {
  std::printf("| %s | %.*f | %s |", stage, ours < 10 ? 1 : 0, ours, goal);
  if (peer > 0) std::printf(" %.0f | %.1f |\n", peer, peer / ours);
  if (!(peer > 0)) std::printf(" | |\n");
}

bool print_table(const std::string& mesh, int repeat) {
  const auto drawn = measured_apart([&] { return draw(lists_of(mesh), kDrawnVertices); });
  if (!drawn) return false;
  const std::vector<std::uint32_t> vertices(drawn->numbers.begin() + 1, drawn->numbers.end());
  const auto run = [&](Method method) {
    return measured_apart([&] { return session(mesh, vertices, method, repeat); });
  };
  const auto local = run(Method::kCorridor), full = run(Method::kPaper);
  const auto peer = measured_apart([&] { return peer_session(mesh, vertices, repeat); });
  if (!local || !full || !peer) return false;

  const std::string name =
      mesh.empty() ? "generated ball" : std::filesystem::path(mesh).stem().string();
  std::printf("\n%s: %.0f faces, drawing of %zu vertices\n\n", name.c_str(), drawn->numbers[0],
              vertices.size());
  std::printf("| stage [ms] | Talweg | goal | CGAL's heat | CGAL / Talweg |\n");
  std::printf("|---|--:|--:|--:|--:|\n");
  row("open, full engine", full->numbers[0], "4000", peer->numbers[0]);
  row("open, local engine", local->numbers[0], "400");
  row("distance, full engine", full->numbers[3], "", peer->numbers[1]);
  row("distance from one vertex", full->numbers[4], "", peer->numbers[2]);
  row("new curve, full engine, to the last point", full->numbers[1], "100");
  row("new curve, local engine, to the last point", local->numbers[1], "20");
  row("another tau, full engine", full->numbers[2], "8");
  row("another tau, local engine", local->numbers[2], "8");
  row("drag one point, local engine", local->numbers[3], "8");
  row("peak memory, full engine [MiB]", full->peak_mib, "1229", peer->peak_mib);
  row("peak memory, local engine [MiB]", local->peak_mib, "500");
  return true;
}

bool print_errors() {
  const auto e = measured_apart(errors);
  if (!e) return false;
  std::printf(
      "\nError of the heat distance on a generated ball of 50,000 faces, in percent of the "
      "largest distance\n\n| | mean | largest |\n|---|--:|--:|\n");
  const char* const names[] = {"Talweg, heat time 10 h²", "Talweg, heat time h²", "CGAL"};
  for (std::size_t k = 0; k < 3; ++k) {
    std::printf("| %s | %.2f | %.1f |\n", names[k], e->numbers[2 * k], e->numbers[2 * k + 1]);
  }
  return true;
}

}  // namespace
}  // namespace talweg::benchmarks

// usage: talweg-peer-table [REPEAT [MESH...]]; "" or no mesh: a generated one
int main(int argc, char** argv) {
  using namespace talweg::benchmarks;
  const int repeat = argc > 1 ? std::atoi(argv[1]) : 5;
  if (repeat < 1) {
    std::fprintf(stderr, "usage: talweg-peer-table [REPEAT [MESH...]]\n");
    return 1;
  }
  try {
    std::vector<std::string> meshes(argv + std::min(argc, 2), argv + argc);
    if (meshes.empty()) meshes.emplace_back();
    std::printf("Processor time of one thread, means of %d.\n", repeat);
    for (const std::string& mesh : meshes) {
      if (!print_table(mesh, repeat)) return 1;
    }
    return print_errors() ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
