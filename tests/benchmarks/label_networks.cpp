// talweg-label-networks: random partitions of meshes, smoothed; a table, one row per mesh and
// count.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "../core/voronoi_labels.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/core/labels/label_network.hpp"
#include "talweg/core/mesh/union_find.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg::benchmarks {
namespace {

/// Results of several seeds: the largest ratios and seconds, and sums of all other values.
struct Row {
  std::size_t borders = 0, tightened = 0, as_drawn = 0, not_whole = 0, beyond = 0;
  double curvature = 0, deviation = 0, seconds = 0;
  // Junctions and ends that may move.
  std::size_t moved = 0;
  double imbalance_before = 0, imbalance_after = 0;
};

void add(Row& row, const LabelNetwork& network, double h, double bound, double seconds) {
  row.borders += network.borders.size();
  row.tightened += network.tightened;
  row.as_drawn += network.as_drawn;
  for (const LabelRegion& region : network.regions) {
    if (region.parts_after != region.parts_before) ++row.not_whole;
  }
  const SmoothingReport& total = network.total;
  const double apart = std::max(total.deviation_to_drawn_max, total.deviation_from_drawn_max);
  if (bound > 0 && apart > bound) ++row.beyond;
  row.curvature =
      std::max(row.curvature, total.after.total_curvature / total.before.total_curvature);
  row.deviation = std::max(row.deviation, apart / h);
  row.seconds = std::max(row.seconds, seconds);
  row.moved += network.moved;
  row.imbalance_before = std::max(row.imbalance_before, network.imbalance_before);
  row.imbalance_after = std::max(row.imbalance_after, network.imbalance_after);
}

/// Two regions on two components may be a component each.
bool has_border(const Surface& surface, const std::vector<std::int64_t>& labels) {
  for (std::size_t e = 0; e < surface.edge_count(); ++e) {
    const HalfedgeId h = halfedge_of(EdgeId{e});
    if (surface.on_boundary(EdgeId{e})) continue;
    if (labels[surface.face(h).index()] != labels[surface.face(twin(h)).index()]) return true;
  }
  return false;
}

int run(double tau, double bound, unsigned seeds, bool free,
        const std::vector<std::string>& meshes) {
  std::printf(
      "| mesh | regions | borders | tightened | as drawn | regions not whole | beyond D | "
      "curvature, of before | deviation, mean edges | time, s |%s\n"
      "|---|---|---|---|---|---|---|---|---|---|%s\n",
      free ? " moved | sum before | sum after |" : "", free ? "---|---|---|" : "");
  for (const std::string& path : meshes) {
    const auto opened = OpenedMesh::open(read_mesh(path));
    const double h = opened->mesh().mean_edge_length();
    for (const std::size_t count : {2, 10, 50, 100, 200}) {
      Row row;
      for (unsigned seed = 1; seed <= seeds; ++seed) {
        const auto labels = test::voronoi_labels(opened->mesh(), count, seed);
        if (!has_border(opened->surface(), labels)) continue;
        LabelNetworkOptions options;
        options.tau = tau;
        options.free_junctions = options.sliding_ends = free;
        if (bound > 0) options.max_deviation = bound * h;
        const Stopwatch watch;
        const LabelNetwork network = smooth_labels(opened, labels, options);
        add(row, network, h, bound * h, watch.ms() / 1000);
      }
      std::printf("| %s | %zu | %zu | %zu | %zu | %zu | %zu | %.3f | %.2f | %.2f |",
                  std::filesystem::path(path).stem().c_str(), count, row.borders, row.tightened,
                  row.as_drawn, row.not_whole, row.beyond, row.curvature, row.deviation,
                  row.seconds);
      if (free) {
        std::printf(" %zu | %.2f | %.2f |", row.moved, row.imbalance_before, row.imbalance_after);
      }
      std::printf("\n");
      std::fflush(stdout);
    }
  }
  return 0;
}

}  // namespace
}  // namespace talweg::benchmarks

int main(int argc, char** argv) try {
  if (argc < 6) {
    std::fprintf(stderr,
                 "usage: talweg-label-networks TAU D SEEDS fixed|free MESH...\n"
                 "D: the largest deviation in mean edges, 0: none is asked for\n"
                 "free: junctions move, ends slide\n");
    return 1;
  }
  return talweg::benchmarks::run(std::atof(argv[1]), std::atof(argv[2]),
                                 static_cast<unsigned>(std::atoi(argv[3])),
                                 std::string(argv[4]) == "free", {argv + 5, argv + argc});
} catch (const std::exception& error) {
  std::fprintf(stderr, "talweg-label-networks: %s\n", error.what());
  return 2;
}
