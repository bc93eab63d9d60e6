// CurveSmoother: drawings that cross themselves or each other, on strips of surface of their own.
#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/drawing/crossings.hpp"
#include "talweg/core/measure/result_report.hpp"
#include "talweg/core/smoothing/corridor_scale.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"
#include "talweg/core/smoothing/unrolled_smoother.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg {
/// Which of the embedded curves need a strip of their own; empty where none does.
std::vector<bool> CurveSmoother::tangled() const {
  if (loops_ == Loops::kErase) return {};
  std::vector<bool> tangled =
      path_contacts(straightening_.triangulation(), straightening_.paths()).tangled;
  if (std::find(tangled.begin(), tangled.end(), true) == tangled.end()) tangled.clear();
  return tangled;
}

void CurveSmoother::set_unrolled(const std::vector<bool>& alone, const Progress& progress) {
  const Stopwatch watch;
  auto unrolled = std::make_unique<Unrolled>();
  // Each curve's with itself and those that were drawn after it.
  const std::vector<EdgePath> paths = drawing_.in_drawn_order(straightening_.paths());
  unrolled->crossings = path_contacts(straightening_.triangulation(), paths).crossings;
  straightening_.clear();
  const bool paper = curve_options_.method == Method::kPaper;
  if (paper && !lift_.is_known()) solve_distance(progress);

  const SurfaceMesh& mesh = mesh_->mesh();
  double reach = 0;
  for (std::size_t c = 0; c < drawing_.curves().size(); ++c) {
    if (alone[c])
      reach = std::max(reach, corridor_reach(mesh, drawing_.curves()[c], drawing_.edges_near()[c]));
  }
  unrolled->mesh = unroll(mesh, drawing_.curves(), alone, reach, progress);
  const auto opened = OpenedMesh::open(unrolled->mesh.lists);
  const std::vector<SurfaceCurve> curves =
      unrolled->mesh.unrolled(mesh, opened->surface(), drawing_.curves());
  unrolled->smoother = std::make_unique<CurveSmoother>(opened);
  CurveSmoother& smoother = *unrolled->smoother;
  smoother.loops_ = Loops::kErase;
  smoother.may_refine_ = false;
  smoother.warns_if_far_ = warns_if_far_;
  CurveOptions options = curve_options_;
  options.pins = unrolled_pins(curves, curve_options_.pins);
  bool done = true;
  if (paper) {
    std::vector<double> distance;
    for (const VertexId v : unrolled->mesh.vertex_of)
      distance.push_back(lift_.distance()[v.index()]);
    done = smoother.set_curves(curves, std::move(distance), options, progress);
  } else {
    done = smoother.set_curves(curves, options, progress);
  }
  if (!done) throw Cancelled();
  solve_ms_ += watch.ms();
  unrolled_ = std::move(unrolled);
}

/// Each copy of them.
std::vector<SurfacePoint> CurveSmoother::unrolled_pins(std::span<const SurfaceCurve> curves,
                                                       std::span<const SurfacePoint> pins) const {
  std::vector<SurfacePoint> result;
  for (std::size_t c = 0; c < drawing_.curves().size(); ++c) {
    const std::vector<SurfacePoint>& points = drawing_.curves()[c].points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (std::find(pins.begin(), pins.end(), points[i]) == pins.end()) continue;
      result.push_back(curves[c].points[i]);
    }
  }
  return result;
}

bool CurveSmoother::set_unrolled_pins(const Progress& progress) {
  CurveSmoother& smoother = *unrolled_->smoother;
  const std::vector<SurfaceCurve> drawn(smoother.drawn().begin(), smoother.drawn().end());
  return smoother.set_pins(unrolled_pins(drawn, curve_options_.pins), progress);
}

std::vector<double> CurveSmoother::unrolled_slack() const { return unrolled_->smoother->slack(); }

SmoothingResult CurveSmoother::smooth_unrolled(const SmoothingOptions& options) {
  SmoothingOptions own = options;
  if (curve_options_.method == Method::kPaper) {  // L is that of the whole mesh
    double length = 0;
    for (const SurfaceCurve& curve : drawing_.curves()) {
      const FaceId face = any_face(mesh_->surface(), curve.points.front());
      const VertexId corner = mesh_->surface().corners(face).front();
      length =
          std::max(length, lift_.characteristic_length(options.potential, drawn_length(), corner));
    }
    own.potential.length = PotentialOptions::Length::kGiven;
    own.potential.given_length = length;
  }
  CurveSmoother& smoother = *unrolled_->smoother;
  SmoothingResult result = smoother.smooth_now(smoother.with_ordered_slack(std::move(own)));
  return folded(smoother.drawing_.as_drawn(std::move(result)), options.progress);
}

SmoothingResult CurveSmoother::smooth_unrolled(const SmoothingOptions& options,
                                               std::span<const double> potential,
                                               std::size_t components) {
  std::vector<double> copies;
  for (const VertexId v : unrolled_->mesh.vertex_of) {
    const auto values = potential.subspan(v.index() * components, components);
    copies.insert(copies.end(), values.begin(), values.end());
  }
  CurveSmoother& smoother = *unrolled_->smoother;
  return folded(smoother.drawing_.as_drawn(smoother.smooth_now(options, copies, components)),
                options.progress);
}

/// Pins that no result passes, on spikes and curls that go: one sentence for each.
std::vector<std::string> CurveSmoother::lost_pins(std::span<const SurfaceCurve> results) const {
  const Surface& surface = mesh_->surface();
  std::vector<std::string> sentences;
  for (const SurfacePoint& pin : curve_options_.pins) {
    const auto passes = [&](const SurfacePoint& p) {
      const FaceId face = common_face(surface, pin, p);
      return face.valid() && distance_in_face(surface, coordinates_in(surface, pin, face),
                                              coordinates_in(surface, p, face)) <=
                                 1e-9 * drawing_.edges_near().front();
    };
    if (std::any_of(results.begin(), results.end(), [&](const SurfaceCurve& curve) {
          return std::any_of(curve.points.begin(), curve.points.end(), passes);
        })) {
      continue;
    }
    const Point at = mesh_->mesh().position(pin);
    const auto* v = std::get_if<AtVertex>(&pin.where());
    sentences.push_back(
        fmt::format("The pin {}at ({:.6g}, {:.6g}, {:.6g}) is lost: it lies on a spike or a curl "
                    "of the drawing "
                    "that goes.",
                    v != nullptr ? fmt::format("(vertex {}) ", v->vertex.index()) : "", at.x(),
                    at.y(), at.z()));
  }
  return sentences;
}

/// Back from the strips, with the reports as if they were not.
SmoothingResult CurveSmoother::folded(SmoothingResult result, const Progress& progress) {
  const Surface& copies = unrolled_->smoother->opened().surface();
  for (SurfaceCurve& curve : result.curves) {
    curve = unrolled_->mesh.folded(copies, mesh_->surface(), curve);
  }
  const std::vector<std::size_t> after =
      straightening_.crossings_of(drawing_.in_drawn_order(result.curves), progress);
  const std::vector<std::string> lost = lost_pins(result.curves);
  for (std::size_t c = 0; c < result.curves.size(); ++c) {
    SmoothingReport& report = result.reports[c];
    SmoothingReport fresh = report_on_curve(mesh_->mesh(), drawing_.curves()[c],
                                            drawing_.measures()[c], result.curves[c]);
    report.faces = fresh.faces;
    report.vertices = fresh.vertices;
    report.points_after = fresh.points_after;
    report.curvature_before = fresh.curvature_before;
    report.curvature_after = fresh.curvature_after;
    report.curvature_max_before = fresh.curvature_max_before;
    report.curvature_max_after = fresh.curvature_max_after;
    report.edge_length_near = drawing_.edges_near()[c];
    report.mollification = lift_.mollification();
    report.crossings_before = unrolled_->crossings[drawing_.numbers()[c]];
    report.crossings_after = after[drawing_.numbers()[c]];
    const std::vector<std::string>& own = lift_.warnings();
    report.warnings.insert(report.warnings.end(), own.begin(), own.end());
    report.warnings.insert(report.warnings.end(), lost.begin(), lost.end());
    if (report.crossings_after != report.crossings_before) {
      report.warnings.push_back(
          fmt::format("The drawing crosses itself and others {} times, the "
                      "result {} times.",
                      report.crossings_before, report.crossings_after));
    }
    const double open = mesh_->open_ms() + lift_.open_ms();
    report.time_ms.open += open;
    report.time_ms.solve += solve_ms_;
    report.time_ms.total += open + solve_ms_;
  }
  result.total = total_of(result.reports);
  return result;
}

}  // namespace talweg
