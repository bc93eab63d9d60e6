#include "tools/quality/drawings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <variant>

#include "talweg/core/drawing/edge_dijkstra.hpp"
#include "talweg/core/io/curve_file.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/surface/spokes.hpp"
#include "tools/quality/level_sets.hpp"
#include "tools/scenes/random.hpp"

namespace talweg::quality {
namespace {

std::vector<HalfedgeId> spokes(const Surface& surface, VertexId v) {
  std::vector<HalfedgeId> out;
  for_each_spoke(surface, v, [&](HalfedgeId h) { out.push_back(h); });
  return out;
}

class Hand {
 public:
  Hand(const OpenedMesh& mesh, std::uint64_t seed)
      : mesh_(mesh.mesh()), surface_(mesh.surface()), dijkstra_(surface_), random_(seed) {}

  /// A trembling copy of at most `points` vertices from the middle of a shortest path.
  std::optional<NamedPath> open(std::size_t points) {
    for (int attempt = 0; attempt < 20; ++attempt) {
      const std::optional<std::vector<VertexId>> path = straight();
      if (!path || path->size() < std::min<std::size_t>(points, 24) / 2) continue;
      const std::size_t n = std::min(points, path->size());
      const auto from = path->begin() + static_cast<std::ptrdiff_t>((path->size() - n) / 2);
      auto drawn = trembling({from, from + static_cast<std::ptrdiff_t>(n)}, false);
      if (drawn) return named("open", std::move(*drawn), false);
    }
    return std::nullopt;
  }

  /// A loop of about this many edges around a random vertex.
  std::optional<NamedPath> loop(std::size_t points) {
    for (int attempt = 0; attempt < 20; ++attempt) {
      const VertexId centre = any_vertex();
      const std::vector<HalfedgeId> out = spokes(surface_, centre);
      if (out.empty()) continue;
      double edge = 0;
      for (const HalfedgeId h : out) edge += surface_.length(edge_of(h));
      const double radius = edge / static_cast<double>(out.size()) * static_cast<double>(points) /
                            (2 * std::numbers::pi);
      const Point p = mesh_.point(centre);
      auto drawn = longest([&](const Point& q) { return radius - (q - p).norm(); });
      if (drawn && drawn->size() >= points / 2) return named("loop", std::move(*drawn), true);
    }
    return std::nullopt;
  }

  /// A plane section through a random vertex.
  std::optional<NamedPath> section() {
    for (int attempt = 0; attempt < 20; ++attempt) {
      const Point p = mesh_.point(any_vertex());
      const Point normal = Point(random_.in(-1, 1), random_.in(-1, 1), random_.in(-1, 1));
      auto drawn = longest([&](const Point& q) { return normal.dot(q - p); });
      if (drawn && drawn->size() >= 12) return named("section", std::move(*drawn), true);
    }
    return std::nullopt;
  }

 private:
  static NamedPath named(const char* kind, std::vector<VertexId> path, bool closed) {
    std::string name = kind;
    name += ' ';
    name += std::to_string(path.size());
    return {std::move(name), std::move(path), closed};
  }

  VertexId any_vertex() {
    const auto n = static_cast<double>(surface_.vertex_count());
    return VertexId{static_cast<std::size_t>(random_.in(0, n))};
  }

  std::optional<std::vector<VertexId>> straight() {
    try {
      return dijkstra_.draw(std::vector{any_vertex(), any_vertex()}, false);
    } catch (const Error&) {
      return std::nullopt;
    }
  }

  std::optional<std::vector<VertexId>> longest(const std::function<double(const Point&)>& f) {
    const auto loops = closed_level_sets(mesh_, f);
    return loops.empty() ? std::nullopt : trembling(loops.front(), true);
  }

  VertexId strayed(VertexId v, int steps) {
    for (int k = 0; k < steps; ++k) {
      const std::vector<HalfedgeId> out = spokes(surface_, v);
      v = surface_.head(
          out[static_cast<std::size_t>(random_.in(0, static_cast<double>(out.size())))]);
    }
    return v;
  }

  std::optional<std::vector<VertexId>> trembling(const std::vector<VertexId>& line, bool closed) {
    const std::size_t stride = std::clamp<std::size_t>(line.size() / 6, 2, 9);
    std::vector<VertexId> through;
    for (std::size_t i = 0; i < line.size(); i += stride) {
      const VertexId v = strayed(line[i], static_cast<int>(stride / 3));
      if (std::find(through.begin(), through.end(), v) == through.end()) through.push_back(v);
    }
    try {
      return dijkstra_.draw(through, closed);
    } catch (const Error&) {  // the loop crosses itself: another place is tried
      return std::nullopt;
    }
  }

  const SurfaceMesh& mesh_;
  const Surface& surface_;
  EdgeDijkstra dijkstra_;
  scenes::Random random_;
};

}  // namespace

SurfaceCurve NamedPath::curve(const Surface& surface) const {
  SurfaceCurve result{closed, {}};
  for (const VertexId v : path) result.points.push_back(SurfacePoint::at_vertex(surface, v));
  return result;
}

std::vector<NamedPath> generated_drawings(const OpenedMesh& mesh, std::uint64_t seed) {
  Hand hand(mesh, seed);
  std::vector<NamedPath> drawings;
  const auto add = [&](std::optional<NamedPath> drawing) {
    if (drawing) drawings.push_back(std::move(*drawing));
  };
  for (const std::size_t points : {24, 48, 96, 200, 2000}) add(hand.open(points));
  for (const std::size_t points : {12, 24, 60, 150}) add(hand.loop(points));
  add(hand.section());
  return drawings;
}

std::vector<NamedPath> stored_drawings(const std::filesystem::path& folder,
                                       const std::string& mesh) {
  std::vector<std::filesystem::path> files;
  if (std::filesystem::is_directory(folder)) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      const std::string stem = entry.path().stem().string();
      const bool ours = stem == mesh || stem.starts_with(mesh + "_");
      if (entry.path().extension() == ".txt" && ours) files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  std::vector<NamedPath> drawings;
  for (const auto& file : files) {
    for (const CurveInput& input : read_curves(file)) {
      const auto* path = std::get_if<std::vector<VertexId>>(&input.points);
      if (path == nullptr) continue;
      std::string name = "stored ";
      name += std::to_string(path->size());
      drawings.push_back({std::move(name), *path, input.closed});
    }
  }
  return drawings;
}

}  // namespace talweg::quality
