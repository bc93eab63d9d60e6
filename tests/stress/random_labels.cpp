#include "stress/random_labels.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "core/label_parts.hpp"
#include "core/voronoi_labels.hpp"
#include "talweg/core/drawing/crossings.hpp"
#include "talweg/core/labels/label_network.hpp"
#include "talweg/core/measure/surface_deviation.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::stress {
namespace {

using test::Labels;

Labels stripes(const SurfaceMesh& mesh, Random& random) {
  const double width = random.scale(1, 20) * mesh.mean_edge_length();
  const Point across = Point(random.unit(), random.unit(), 1 - random.unit()).normalized() / width;
  const Point& origin = mesh.points().front();
  Labels labels;
  for (std::size_t f = 0; f < mesh.surface().face_count(); ++f) {
    const VertexId first = mesh.surface().corners(FaceId{f})[0];
    const double at = (mesh.point(first) - origin).dot(across);
    labels.push_back(std::abs(at) < 1e9 ? static_cast<std::int64_t>(std::floor(at)) : 0);
  }
  return labels;
}

/// Random labels per face; `what` names their kind.
Labels random_labels(const SurfaceMesh& mesh, Random& random, std::string& what) {
  Labels labels;
  if (random.one_in(3)) {
    what += "stripes";
    labels = stripes(mesh, random);
  } else {
    const std::size_t count = static_cast<std::size_t>(random.scale(2, 60));
    what += fmt::format("{} regions", count);
    labels = test::voronoi_labels(mesh, count, static_cast<unsigned>(random.below32(1U << 30U)));
  }
  if (!random.one_in(4)) return labels;
  const std::size_t one = random.one_in(3) ? 2 : 30;  // noise or islands
  what += one == 2 ? " noise" : " islands";
  for (std::int64_t& label : labels) {
    if (random.one_in(one)) label = static_cast<std::int64_t>(random.below(4));
  }
  return labels;
}

LabelNetworkOptions network_options(const SurfaceMesh& mesh, Random& random, std::string& what) {
  const double edge = mesh.mean_edge_length();
  LabelNetworkOptions options;
  options.tau = random.one_in(8) ? 0 : random.scale(1e-2, 1e2);
  if (random.one_in(4)) options.slack = random.scale(1e-3, 10) * edge;
  if (random.one_in(2)) options.max_deviation = random.scale(0.1, 5) * edge;
  options.free_junctions = random.one_in(2);
  options.sliding_ends = random.one_in(2);
  if (random.one_in(3)) {
    options.budget.work = static_cast<std::uint64_t>(random.scale(1, 1e7));
  }
  what += fmt::format(" tau {:.3g} slack {:.3g} within {:.3g}{}{} work {}", options.tau,
                      options.slack.value_or(-1), options.max_deviation.value_or(-1),
                      options.free_junctions ? " free" : "", options.sliding_ends ? " slide" : "",
                      options.budget.work.value_or(0));
  return options;
}

bool is_on_boundary(const Surface& surface, const SurfacePoint& point) {
  if (const auto* v = std::get_if<AtVertex>(&point.where())) return surface.on_boundary(v->vertex);
  const auto* e = std::get_if<OnEdge>(&point.where());
  return e != nullptr && surface.on_boundary(e->edge);
}

/// Whether a border may end up on the boundary of the mesh, where it separates no labels.
bool may_follow_boundary(const Surface& surface, const LabelNetwork& network) {
  if (network.moved > 0) return true;  // an end may have slid along the boundary
  return std::any_of(
      network.borders.begin(), network.borders.end(), [&](const SmoothedBorder& border) {
        const std::vector<SurfacePoint>& points = border.border.curve.points;
        const auto is_on = [&](const SurfacePoint& p) { return is_on_boundary(surface, p); };
        return std::adjacent_find(points.begin(), points.end(),
                                  [&](const SurfacePoint& p, const SurfacePoint& q) {
                                    return is_on(p) && is_on(q);
                                  }) != points.end() ||
               (border.border.curve.closed && is_on(points.front()) && is_on(points.back()));
      });
}

std::string fault_of_regions(const SurfaceMesh& mesh, const MeshLists& lists, const Labels& labels,
                             const LabelNetwork& network) {
  const bool by_face = labels.size() == mesh.surface().face_count();
  const auto before =
      by_face ? test::parts(lists, labels) : test::parts_of_vertices(mesh.surface(), labels);
  if (test::parts(network.cut.lists, network.cut_labels) != before) return "regions have torn";
  if (by_face && !may_follow_boundary(mesh.surface(), network) &&
      test::degrees(network.cut.lists, network.cut_labels) != test::degrees(lists, labels)) {
    return "borders meet otherwise";
  }
  double area_before = 0, area_after = 0;
  for (const LabelRegion& region : network.regions) {
    if (region.parts_after != region.parts_before) {
      return fmt::format("region {} had {} parts and has {}", region.label, region.parts_before,
                         region.parts_after);
    }
    area_before += region.area_before;
    area_after += region.area_after;
  }
  if (!(std::abs(area_after - area_before) <= 1e-7 * area_before)) {
    return fmt::format("area {} became {}", area_before, area_after);
  }
  if (network.face_labels.size() != lists.triangles.size()) return "not a label for each face";
  SurfaceMesh::open(network.cut.lists);
  return "";
}

std::string fault_of_borders(const SurfaceMesh& mesh, std::span<const LabelBorder> drawn,
                             const LabelNetworkOptions& options, const LabelNetwork& network) {
  if (network.borders.size() != drawn.size()) return "borders are missing";
  std::vector<SurfaceCurve> curves;
  for (const SmoothedBorder& border : network.borders) curves.push_back(border.border.curve);
  if (!crossing_curves(mesh.surface(), curves).empty()) return "borders cross";
  DeviationMeter meter(mesh);
  for (std::size_t c = 0; c < drawn.size(); ++c) {
    if (curves[c].closed != drawn[c].curve.closed) return "open and closed mixed up";
    if (network.borders[c].border.labels != drawn[c].labels) return "a border has other labels";
    for (const SurfacePoint& point : curves[c].points) {
      if (!mesh.position(point).allFinite()) return "a position is not finite";
    }
    if (!options.max_deviation || network.borders[c].as_drawn) continue;
    // The meter is exact up to 1e-3 of the distance or of a mean edge.
    const SurfaceDeviation apart =
        meter.measure(std::span(&curves[c], 1), std::span(&drawn[c].curve, 1));
    if (apart.larger().max > *options.max_deviation * (1 + 2e-3) + 2e-3 * mesh.mean_edge_length()) {
      return fmt::format("border {} is {:.6g} away", c, apart.larger().max);
    }
  }
  return "";
}

}  // namespace

LabelRun random_label_run(const std::shared_ptr<const OpenedMesh>& mesh, Random& random) {
  LabelRun run;
  Labels labels = random_labels(mesh->mesh(), random, run.what);
  if (random.one_in(3)) {
    run.what += " of vertices";
    labels = test::on_vertices(mesh->surface(), labels);
  }
  const LabelNetworkOptions options = network_options(mesh->mesh(), random, run.what);
  std::vector<LabelBorder> drawn;
  try {
    drawn = label_borders(mesh->surface(), labels);
  } catch (const Error& error) {
    const std::string text = error.what();
    if (error.code() != ErrorCode::kBadCurve) run.broken = "labels are refused: " + text;
    return run;
  }
  run.borders = drawn.size();
  MeshLists lists;
  lists.points.assign(mesh->mesh().points().begin(), mesh->mesh().points().end());
  for (std::size_t f = 0; f < mesh->surface().face_count(); ++f) {
    Triangle t;
    const auto corners = mesh->surface().corners(FaceId{f});
    for (std::size_t k = 0; k < 3; ++k) t[k] = static_cast<std::uint32_t>(corners[k].index());
    lists.triangles.push_back(t);
  }
  try {
    const LabelNetwork network = smooth_labels(mesh, labels, options);
    run.points = network.total.points_before;
    run.cut_labels = network.cut_labels;
    run.broken = fault_of_borders(mesh->mesh(), drawn, options, network);
    if (run.broken.empty()) run.broken = fault_of_regions(mesh->mesh(), lists, labels, network);
  } catch (const Error& error) {
    run.broken = std::string("labels: ") + error.what();
  }
  return run;
}

}  // namespace talweg::stress
