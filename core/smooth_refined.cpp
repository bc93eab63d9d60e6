// CurveSmoother: drawings that are finer than the mesh, on faces as fine as they are.
#include <algorithm>
#include <limits>
#include <utility>

#include "talweg/core/corridor_scale.hpp"
#include "talweg/core/curve_smoother.hpp"
#include "talweg/core/drawn_curves.hpp"
#include "talweg/core/refined_smoother.hpp"
#include "talweg/core/result_report.hpp"
#include "talweg/core/stopwatch.hpp"

namespace talweg {
namespace {

/// Twice the slack, about what edges are on meshes along whose edges one draws; but enough of them
/// for a curve to look smooth, unless the slack has room for none of its bends.
double longest_edge(const Surface& surface, const SurfaceCurve& drawn) {
  constexpr double kEdges = 200;
  const double slack = default_slack(surface, drawn);
  return std::max(std::min(2 * slack, curve_length(surface, drawn) / kEdges), slack / 4);
}

}  // namespace

/// The corridor only: the paper's method has the mesh's vertices, and no others.
std::vector<FaceId> CurveSmoother::faces_to_divide() const {
  std::vector<FaceId> faces;
  if (!may_refine_ || curve_options_.method != Method::kCorridor) return faces;
  for (const SurfaceCurve& curve : ordered_) {
    const double slack = default_slack(mesh_->surface(), curve);
    const std::vector<FaceId> own = too_large_faces(mesh_->mesh(), curve, slack);
    faces.insert(faces.end(), own.begin(), own.end());
  }
  return faces;
}

bool CurveSmoother::set_refined(bool whole, const Progress& progress) {
  const Stopwatch watch;
  const SurfaceMesh& mesh = mesh_->mesh();
  double reach = 0;
  std::vector<double> longest;
  for (std::size_t c = 0; c < ordered_.size(); ++c) {
    reach = std::max(reach, corridor_reach(mesh, ordered_[c], edges_near_[c]));
    longest.push_back(longest_edge(mesh.surface(), ordered_[c]));
  }
  if (whole) reach = std::numeric_limits<double>::infinity();
  auto refined = std::make_unique<Refined>();
  refined->mesh = refine_along(mesh, ordered_, faces_to_divide(), longest, reach);
  const auto opened = OpenedMesh::open(refined->mesh.lists);
  refined->smoother = std::make_unique<CurveSmoother>(opened);
  CurveSmoother& smoother = *refined->smoother;
  smoother.may_refine_ = false;
  smoother.warns_if_far_ = false;  // that counts edges of the mesh, not of its pieces
  const std::vector<SurfaceCurve> curves = refined->mesh.refined(opened->surface(), ordered_);
  CurveOptions options = curve_options_;
  options.pins = refined_pins(*refined, curves);
  if (!smoother.set_curves(curves, options, progress)) return false;
  solve_ms_ += watch.ms();
  (whole ? refined_whole_ : refined_) = std::move(refined);
  return true;
}

std::vector<SurfacePoint> CurveSmoother::refined_pins(const Refined& refined,
                                                      std::span<const SurfaceCurve> curves) const {
  const std::vector<SurfacePoint>& pins = curve_options_.pins;
  std::vector<SurfacePoint> result;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    for (std::size_t i = 0; i < curves[c].points.size(); ++i) {
      const RefinedMesh::Place& place = refined.mesh.curves[c][i];
      if (place.part > 0) continue;
      const SurfacePoint& drawn = ordered_[c].points[place.drawn];
      if (std::find(pins.begin(), pins.end(), drawn) == pins.end()) continue;
      result.push_back(curves[c].points[i]);
    }
  }
  return result;
}

void CurveSmoother::set_refined_pins() {
  for (const Refined* refined : {refined_.get(), refined_whole_.get()}) {
    if (refined == nullptr) continue;
    const auto set = refined->smoother->drawn();
    const std::vector<SurfaceCurve> drawn(set.begin(), set.end());
    refined->smoother->set_pins(refined_pins(*refined, drawn));
  }
}

std::vector<double> CurveSmoother::refined_slack() const { return refined_->smoother->slack(); }

const CurveSmoother::Refined& CurveSmoother::refined_for(bool whole) {
  if (whole && !refined_whole_) set_refined(true, {});
  return whole ? *refined_whole_ : *refined_;
}

SmoothingResult CurveSmoother::smooth_refined(const SmoothingOptions& options) {
  constexpr double kLeastTau = 1.0 / 8;  // of corridor_reach()
  const Refined& refined = refined_for(options.tau < kLeastTau);
  SmoothingOptions own = options;
  for (std::size_t c = 0; c < options.slack_at.size(); ++c) {
    own.slack_at[c] = refined_slack_at(refined, c, options.slack_at[c]);
  }
  refined.smoother->last_.reset();  // moves are reported here
  return coarse(refined, refined.smoother->smooth(own), options);
}

SmoothingResult CurveSmoother::smooth_refined(const SmoothingOptions& options,
                                              std::span<const double> potential,
                                              std::size_t components) {
  const Refined& refined = refined_for(true);
  const RefinedMesh& mesh = refined.mesh;
  std::vector<double> own(mesh.lists.points.size() * components);
  for (std::size_t f = 0; f < mesh.face_of.size(); ++f) {
    const auto corners = mesh_->surface().corners(mesh.face_of[f]);
    for (std::size_t j = 0; j < 3; ++j) {
      double* values = own.data() + mesh.lists.triangles[f][j] * components;
      std::fill_n(values, components, 0.0);
      for (std::size_t i = 0; i < 3 * components; ++i) {
        values[i % components] +=
            mesh.corners_of[f][j][i / components] *
            potential[corners[i / components].index() * components + i % components];
      }
    }
  }
  refined.smoother->last_.reset();
  return coarse(refined, refined.smoother->smooth(options, own, components), options);
}

/// Linear between the points of the drawing.
std::vector<double> CurveSmoother::refined_slack_at(const Refined& refined, std::size_t curve,
                                                    const std::vector<double>& drawn) const {
  const std::size_t n = ordered_[curve].points.size();
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
    const SmoothingReport fresh =
        report_on_curve(mesh_->mesh(), ordered_[c], drawn_measures_[c], result.curves[c]);
    report.engine = "refined";
    report.faces = fresh.faces;
    report.vertices = fresh.vertices;
    report.points_before = fresh.points_before;
    report.edge_length_near = edges_near_[c];
    warn_if_far(report, kFar * default_slack(mesh_->surface(), ordered_[c]));
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
