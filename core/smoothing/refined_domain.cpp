#include "talweg/core/smoothing/refined_domain.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "talweg/core/drawing/drawn_legs.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/core/smoothing/corridor_width.hpp"
#include "talweg/core/smoothing/undivided_domain.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg {
namespace {

/// The longest allowed edge: twice the slack, or a 200th of the curve's length if this is shorter,
/// so that the curve crosses enough edges to look smooth; but at least a quarter of the slack.
double longest_edge(const Surface& surface, const SurfaceCurve& drawn, double slack) {
  constexpr double kEdges = 200;
  return std::max(std::min(2 * slack, curve_length(surface, drawn) / kEdges), slack / 4);
}

/// Interpolates values per vertex (k per row) of a mesh linearly at the vertices of its refined
/// part.
std::vector<double> values_on(const RefinedMesh& mesh, const Surface& original,
                              const GivenPotential& given) {
  const std::size_t components = given.components;
  std::vector<double> result(mesh.lists.points.size() * components);
  for (std::size_t f = 0; f < mesh.face_of.size(); ++f) {
    const auto corners = original.corners(mesh.face_of[f]);
    for (std::size_t j = 0; j < 3; ++j) {
      double* row = result.data() + mesh.lists.triangles[f][j] * components;
      std::fill_n(row, components, 0.0);
      for (std::size_t i = 0; i < 3 * components; ++i) {
        row[i % components] +=
            mesh.corners_of[f][j][i / components] *
            given.values[corners[i / components].index() * components + i % components];
      }
    }
  }
  return result;
}

}  // namespace

std::vector<FaceId> faces_to_divide(const SurfaceMesh& mesh, const OrderedDrawing& drawing,
                                    const CurveOptions& options) {
  std::vector<FaceId> faces;
  for (std::size_t c = 0; c < drawing.curves().size(); ++c) {
    const SurfaceCurve& curve = drawing.curves()[c];
    // Legs do not follow the drawing, so its fineness there does not matter.
    if (legs_of(curve, options.pins, options.way_points, options.painted).all()) continue;
    const std::vector<FaceId> own = too_large_faces(mesh, curve, drawing.slacks()[c].slack);
    faces.insert(faces.end(), own.begin(), own.end());
  }
  return faces;
}

RefinedDomain::RefinedDomain(const SurfaceMesh& mesh, const OrderedDrawing& drawing,
                             CurveOptions options, const Progress& progress)
    : mesh_(&mesh), drawing_(&drawing), options_(std::move(options)) {
  parts_.push_back(part_within(reach(), progress));
}

/// The largest distance of a result from the drawing for tau >= 1/8, mesh units.
double RefinedDomain::reach() const {
  double reach = 0;
  for (std::size_t c = 0; c < drawing_->curves().size(); ++c) {
    reach =
        std::max(reach, corridor_reach(*mesh_, drawing_->curves()[c], drawing_->edges_near()[c]));
  }
  return reach;
}

std::unique_ptr<RefinedDomain::Part> RefinedDomain::part_within(double reach,
                                                                const Progress& progress) {
  const Stopwatch watch;
  std::vector<double> longest;
  for (std::size_t c = 0; c < drawing_->curves().size(); ++c) {
    longest.push_back(
        longest_edge(mesh_->surface(), drawing_->curves()[c], drawing_->slacks()[c].slack));
  }
  auto part = std::make_unique<Part>();
  part->mesh = refine_along(*mesh_, drawing_->curves(),
                            faces_to_divide(*mesh_, *drawing_, options_), longest, reach, progress);
  part->memory = std::make_unique<SmoothingMemory>(OpenedMesh::open(part->mesh.lists));
  const std::vector<SurfaceCurve> curves =
      part->mesh.refined(part->memory->surface(), drawing_->curves());
  const CurveOptions options = options_there(options_, copies_on(part->mesh, curves));
  part->drawing =
      checked_drawing(part->memory->mesh(), curves, drawing_->slacks(), options, progress);
  part->domain = undivided_domain_for(*part->memory, part->drawing, options, &part->mesh.at_cut,
                                      std::nullopt, progress);
  solve_ms_ += watch.ms();
  return part;
}

PointCopies RefinedDomain::copies_on(const RefinedMesh& mesh,
                                     std::span<const SurfaceCurve> curves) const {
  PointCopies copies;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    for (std::size_t i = 0; i < curves[c].points.size(); ++i) {
      const RefinedMesh::Place& place = mesh.curves[c][i];
      if (place.part > 0) continue;
      copies.add(drawing_->curves()[c].points[place.drawn], curves[c].points[i]);
    }
  }
  return copies;
}

void RefinedDomain::set_pins(std::span<const SurfacePoint> pins, const Progress& progress) {
  options_.pins.assign(pins.begin(), pins.end());
  for (const std::unique_ptr<Part>& part : parts_) {
    part->domain->set_pins(copies_on(part->mesh, part->drawing.drawn()).of(options_.pins),
                           progress);
  }
}

std::vector<double> RefinedDomain::slack() const {
  return parts_.front()->drawing.in_drawn_order(parts_.front()->domain->slack());
}

DomainResult RefinedDomain::smooth(const SmoothingOptions& options, const GivenPotential* given,
                                   const Progress& progress) {
  bool held = true;
  for (std::size_t c = 0; c < drawing_->curves().size(); ++c) {
    held = held && options.tau_of(c) >= kLeastHeldTau;
  }
  if (given == nullptr && held)
    return coarse(*parts_.front(), smooth_on(*parts_.front(), options, given, progress));
  SmoothingOptions lazy = options;
  lazy.prepare_whole_mesh = false;  // only touched faces matter
  double reach = this->reach();
  for (std::size_t k = 0;; ++k, reach *= 2) {
    if (k == parts_.size()) parts_.push_back(part_within(reach, progress));
    const Part& part = *parts_[k];
    DomainResult result = smooth_on(part, lazy, given, progress);
    if (may_leave(part.mesh.at_cut, part.memory->surface(), result)) continue;
    if (options.prepare_whole_mesh) result = smooth_on(part, options, given, progress);
    return coarse(part, std::move(result));
  }
}

/// The result in the order of the drawing, on the refined part.
DomainResult RefinedDomain::smooth_on(const Part& part, const SmoothingOptions& options,
                                      const GivenPotential* given, const Progress& progress) {
  SmoothingOptions own = options;
  for (std::size_t c = 0; c < options.slack_at.size(); ++c) {
    own.slack_at[c] = slack_on(part, c, options.slack_at[c]);
  }
  if (given == nullptr) {
    return as_drawn(part.drawing,
                    part.domain->smooth(part.drawing.ordered(std::move(own)), nullptr, progress));
  }
  const std::vector<double> values = values_on(part.mesh, mesh_->surface(), *given);
  const GivenPotential there{values, given->components};
  return as_drawn(part.drawing, part.domain->smooth(own, &there, progress));
}

/// The slack along the curve on the refined part, linear between the points of the drawing.
std::vector<double> RefinedDomain::slack_on(const Part& part, std::size_t curve,
                                            const std::vector<double>& drawn) const {
  const std::size_t n = drawing_->curves()[curve].points.size();
  std::vector<double> result;
  for (std::size_t i = 0; i < part.drawing.drawn()[curve].points.size(); ++i) {
    const RefinedMesh::Place& place = part.mesh.curves[curve][i];
    const double from = drawn[place.drawn], to = drawn[(place.drawn + 1) % n];
    result.push_back(place.part > 0 ? from + place.part * (to - from) : from);
  }
  return result;
}

/// The result, converted to the mesh.
DomainResult RefinedDomain::coarse(const Part& part, DomainResult smoothed) const {
  const Surface& fine = part.memory->surface();
  for (CurveResult& curve : smoothed.curves) {
    curve.curve = part.mesh.coarse(fine, mesh_->surface(), curve.curve);
  }
  smoothed.engine = Engine::kRefined;
  smoothed.time_ms.open = 0;
  smoothed.time_ms.solve = solve_ms_;
  return smoothed;
}

}  // namespace talweg
