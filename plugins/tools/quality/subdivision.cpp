// Smooths the same drawing on finer versions of one mesh.
#include <algorithm>
#include <utility>

#include "talweg/core/measure/deviation.hpp"
#include "talweg/core/measure/edge_length_near.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/core/strokes/stroke_slack.hpp"
#include "tools/paper/refinement.hpp"
#include "tools/quality/runs.hpp"

namespace talweg::quality {
namespace {

/// The drawing with the midpoints of its edges, which are vertices of `finer` only.
std::vector<VertexId> with_midpoints(const SurfaceMesh& finer, std::size_t vertices,
                                     const NamedPath& drawing) {
  const Surface& surface = finer.surface();
  const std::size_t n = drawing.path.size();
  std::vector<VertexId> path;
  for (std::size_t i = 0; i < n; ++i) {
    const VertexId a = drawing.path[i];
    path.push_back(a);
    if (i + 1 == n && !drawing.closed) break;
    const VertexId b = drawing.path[(i + 1) % n];
    const Point middle = (finer.point(a) + finer.point(b)) / 2;
    VertexId nearest;
    double least = HUGE_VAL;
    const HalfedgeId first = surface.halfedge(a);
    HalfedgeId h = first;
    do {
      const VertexId v = surface.head(h);
      const double distance = (finer.point(v) - middle).norm();
      if (v.index() >= vertices && distance < least) {
        least = distance;
        nearest = v;
      }
      if (!surface.has_face(h)) break;
      h = surface.turn_ccw(h);
    } while (h != first);
    path.push_back(nearest);
  }
  return path;
}

}  // namespace

Subdivision subdivision(const Subject& subject, const NamedPath& drawing, double tau,
                        const CurveOptions& curve_options) {
  Subdivision result{subject.name, drawing.name, {}, {}, {}};
  const Surface& coarse = subject.mesh->surface();
  const double edge = edge_length_near(coarse, drawing.curve(coarse));
  SmoothingOptions options;
  options.tau = tau;
  const SurfaceCurve drawn = drawing.curve(coarse);
  options.slack = stroke_slack(subject.mesh->mesh(), std::span(&drawn, 1), edge).slack;
  MeshLists lists = subject.lists;
  NamedPath now = drawing;
  std::vector<Point> coarsest;
  for (std::size_t level = 0; level < 3; ++level) {
    std::shared_ptr<const OpenedMesh> mesh = subject.mesh;
    if (level > 0) {
      const std::size_t vertices = lists.points.size();
      lists = paper::refined(lists, [](const Point&) { return true; });
      mesh = OpenedMesh::open(lists);
      now.path = with_midpoints(mesh->mesh(), vertices, now);
    }
    const SmoothingResult smoothed =
        smooth_curve(mesh, now.curve(mesh->surface()), options, curve_options);
    const std::vector<Point> points = positions_of(mesh->mesh(), smoothed.curve());
    if (level == 0) coarsest = points;
    const Deviation apart = deviation(points, now.closed, coarsest, now.closed);
    result.curvature[level] = smoothed.report().after.total_curvature;
    result.bending[level] = measure_curve(mesh->surface(), smoothed.curve(), edge).bending;
    result.apart[level] = std::max(apart.to_drawn.max, apart.from_drawn.max) / edge;
  }
  return result;
}

}  // namespace talweg::quality
