// CurveSmoother: drawings that are finer than the mesh, on faces as fine as they are.
#include <algorithm>
#include <utility>

#include "talweg/core/drawing/drawn_curves.hpp"
#include "talweg/core/measure/result_report.hpp"
#include "talweg/core/smoothing/corridor_scale.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"
#include "talweg/core/smoothing/refined_smoother.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg {
namespace {

/// Twice the slack, about what edges are on meshes along whose edges one draws; but enough of them
/// for a curve to look smooth, unless the slack has room for none of its bends.
double longest_edge(const Surface& surface, const SurfaceCurve& drawn) {
  constexpr double kEdges = 200;
  const double slack = default_slack(surface, drawn);
  return std::max(std::min(2 * slack, curve_length(surface, drawn) / kEdges), slack / 4);
}

/// Per-vertex values (k a row) of a mesh at the vertices of its refined part, linear in each face.
std::vector<double> values_on(const RefinedMesh& mesh, const Surface& original,
                              std::span<const double> values, std::size_t components) {
  std::vector<double> result(mesh.lists.points.size() * components);
  for (std::size_t f = 0; f < mesh.face_of.size(); ++f) {
    const auto corners = original.corners(mesh.face_of[f]);
    for (std::size_t j = 0; j < 3; ++j) {
      double* row = result.data() + mesh.lists.triangles[f][j] * components;
      std::fill_n(row, components, 0.0);
      for (std::size_t i = 0; i < 3 * components; ++i) {
        row[i % components] +=
            mesh.corners_of[f][j][i / components] *
            values[corners[i / components].index() * components + i % components];
      }
    }
  }
  return result;
}

}  // namespace

/// The corridor only: the paper's method has the mesh's vertices, and no others.
std::vector<FaceId> CurveSmoother::faces_to_divide() const {
  std::vector<FaceId> faces;
  if (!may_refine_ || curve_options_.method != Method::kCorridor) return faces;
  for (const SurfaceCurve& curve : drawing_.curves()) {
    const double slack = default_slack(mesh_->surface(), curve);
    const std::vector<FaceId> own = too_large_faces(mesh_->mesh(), curve, slack);
    faces.insert(faces.end(), own.begin(), own.end());
  }
  return faces;
}

/// As far around the drawing as a result comes at tau = 1/8 and more.
double CurveSmoother::refined_reach() const {
  double reach = 0;
  for (std::size_t c = 0; c < drawing_.curves().size(); ++c) {
    reach = std::max(reach,
                     corridor_reach(mesh_->mesh(), drawing_.curves()[c], drawing_.edges_near()[c]));
  }
  return reach;
}

std::unique_ptr<CurveSmoother::Refined> CurveSmoother::refined_within(double reach,
                                                                      const Progress& progress) {
  const Stopwatch watch;
  const SurfaceMesh& mesh = mesh_->mesh();
  std::vector<double> longest;
  for (const SurfaceCurve& curve : drawing_.curves())
    longest.push_back(longest_edge(mesh.surface(), curve));
  auto refined = std::make_unique<Refined>();
  refined->mesh =
      refine_along(mesh, drawing_.curves(), faces_to_divide(), longest, reach, progress);
  const auto opened = OpenedMesh::open(refined->mesh.lists);
  refined->smoother = std::make_unique<CurveSmoother>(opened);
  CurveSmoother& smoother = *refined->smoother;
  smoother.may_refine_ = false;
  smoother.warns_if_far_ = false;  // that counts edges of the mesh, not of its pieces
  smoother.cut_ = &refined->mesh.at_cut;
  const std::vector<SurfaceCurve> curves =
      refined->mesh.refined(opened->surface(), drawing_.curves());
  CurveOptions options = curve_options_;
  options.pins = refined_pins(*refined, curves);
  if (!smoother.set_curves(curves, options, progress)) throw Cancelled();
  solve_ms_ += watch.ms();
  return refined;
}

void CurveSmoother::set_refined(const Progress& progress) {
  refined_.push_back(refined_within(refined_reach(), progress));
}

std::vector<SurfacePoint> CurveSmoother::refined_pins(const Refined& refined,
                                                      std::span<const SurfaceCurve> curves) const {
  const std::vector<SurfacePoint>& pins = curve_options_.pins;
  std::vector<SurfacePoint> result;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    for (std::size_t i = 0; i < curves[c].points.size(); ++i) {
      const RefinedMesh::Place& place = refined.mesh.curves[c][i];
      if (place.part > 0) continue;
      const SurfacePoint& drawn = drawing_.curves()[c].points[place.drawn];
      if (std::find(pins.begin(), pins.end(), drawn) == pins.end()) continue;
      result.push_back(curves[c].points[i]);
    }
  }
  return result;
}

bool CurveSmoother::set_refined_pins(const Progress& progress) {
  for (const std::unique_ptr<Refined>& refined : refined_) {
    const auto set = refined->smoother->drawn();
    const std::vector<SurfaceCurve> drawn(set.begin(), set.end());
    if (!refined->smoother->set_pins(refined_pins(*refined, drawn), progress)) return false;
  }
  return true;
}

std::vector<double> CurveSmoother::refined_slack() const {
  return refined_.front()->smoother->slack();
}

/// Whether a result might have gone on beyond what was taken along.
bool CurveSmoother::is_at_cut(const Refined& refined, const SmoothingResult& result) {
  const Surface& fine = refined.smoother->opened().surface();
  const auto cut = [&](VertexId v) { return refined.mesh.at_cut[v.index()]; };
  const auto touches = [&](const SurfacePoint& point) {
    const auto corners = fine.corners(any_face(fine, point));
    return std::any_of(corners.begin(), corners.end(), cut);
  };
  return refined.smoother->at_cut_ ||
         std::any_of(result.curves.begin(), result.curves.end(), [&](const SurfaceCurve& curve) {
           return std::any_of(curve.points.begin(), curve.points.end(), touches);
         });
}

/// Below tau = 1/8 a result may lead anywhere. It is looked for in larger and larger parts of the
/// mesh, always from the first on, until it does not come to where its part was cut off: that costs
/// what it touches, and is what the whole mesh would give. `smooth` is asked for each part.
template <class Smooth>
SmoothingResult CurveSmoother::in_reach(const SmoothingOptions& options, const Smooth& smooth) {
  double reach = refined_reach();
  for (std::size_t k = 0;; ++k, reach *= 2) {
    if (k == refined_.size()) refined_.push_back(refined_within(reach, options.progress));
    const Refined& refined = *refined_[k];
    refined.smoother->last_.reset();  // moves are reported here
    refined.smoother->at_cut_ = false;
    SmoothingOptions lazy = options;
    lazy.prepare_whole_mesh = false;  // what is touched decides
    SmoothingResult result = smooth(refined, lazy);
    if (is_at_cut(refined, result)) continue;
    if (options.prepare_whole_mesh) result = smooth(refined, options);
    return coarse(refined, std::move(result), options);
  }
}

SmoothingResult CurveSmoother::smooth_refined(const SmoothingOptions& options) {
  const auto smooth = [&](const Refined& refined, SmoothingOptions own) {
    for (std::size_t c = 0; c < options.slack_at.size(); ++c) {
      own.slack_at[c] = refined_slack_at(refined, c, options.slack_at[c]);
    }
    CurveSmoother& smoother = *refined.smoother;
    return smoother.drawing_.as_drawn(smoother.smooth_now(smoother.with_ordered_slack(own)));
  };
  if (options.tau < kLeastAnchor) return in_reach(options, smooth);
  const Refined& refined = *refined_.front();
  refined.smoother->last_.reset();
  return coarse(refined, smooth(refined, options), options);
}

SmoothingResult CurveSmoother::smooth_refined(const SmoothingOptions& options,
                                              std::span<const double> potential,
                                              std::size_t components) {
  return in_reach(options, [&](const Refined& refined, const SmoothingOptions& own) {
    CurveSmoother& smoother = *refined.smoother;
    return smoother.drawing_.as_drawn(smoother.smooth_now(
        own, values_on(refined.mesh, mesh_->surface(), potential, components), components));
  });
}

/// Linear between the points of the drawing.
std::vector<double> CurveSmoother::refined_slack_at(const Refined& refined, std::size_t curve,
                                                    const std::vector<double>& drawn) const {
  const std::size_t n = drawing_.curves()[curve].points.size();
  std::vector<double> result;
  for (std::size_t i = 0; i < refined.smoother->drawn()[curve].points.size(); ++i) {
    const RefinedMesh::Place& place = refined.mesh.curves[curve][i];
    const double from = drawn[place.drawn], to = drawn[(place.drawn + 1) % n];
    result.push_back(place.part > 0 ? from + place.part * (to - from) : from);
  }
  return result;
}

/// Back on the mesh, with the reports as if it had been there all the time.
SmoothingResult CurveSmoother::coarse(const Refined& refined, SmoothingResult result,
                                      const SmoothingOptions& options) {
  constexpr double kFar = 4;  // slacks
  const Surface& fine = refined.smoother->opened().surface();
  for (std::size_t c = 0; c < result.curves.size(); ++c) {
    SmoothingReport& report = result.reports[c];
    result.curves[c] = refined.mesh.coarse(fine, mesh_->surface(), result.curves[c]);
    const SmoothingReport fresh = report_on_curve(mesh_->mesh(), drawing_.curves()[c],
                                                  drawing_.measures()[c], result.curves[c]);
    report.engine = "refined";
    report.faces = fresh.faces;
    report.vertices = fresh.vertices;
    report.points_before = fresh.points_before;
    report.edge_length_near = drawing_.edges_near()[c];
    warn_if_far(report, kFar * default_slack(mesh_->surface(), drawing_.curves()[c]),
                options.deviation == DeviationMeasure::kAutomatic);
    const double open = mesh_->open_ms();
    report.time_ms.total += open - report.time_ms.open + solve_ms_ - report.time_ms.solve;
    report.time_ms.open = open;
    report.time_ms.solve = solve_ms_;
  }
  report_moves(options, result);
  result.total = total_of(result.reports);
  return result;
}

}  // namespace talweg
