#include "talweg/core/smoothing/unrolled_sheet.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "talweg/core/drawing/crossings.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/core/smoothing/corridor_width.hpp"
#include "talweg/core/smoothing/joined_curves.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg {

UnrolledSheet::UnrolledSheet(SmoothingMemory& memory, const OrderedDrawing& drawing,
                             CurveOptions options, const std::vector<bool>& alone,
                             std::optional<std::vector<double>> distance, const Progress& progress)
    : memory_(&memory),
      drawing_(&drawing),
      options_(std::move(options)),
      lift_(memory.opened(), memory.straightening()) {
  const Stopwatch watch;
  // Crossings of each curve with itself and with those drawn after it.
  Straightening& straightening = memory.straightening();
  const std::vector<EdgePath> paths = drawing.in_drawn_order(straightening.paths());
  crossings_ = path_contacts(straightening.triangulation(), paths).crossings;
  const bool paper = options_.method == Method::kPaper;
  if (distance) lift_.set(*std::move(distance), drawing.curves().size() > 1);
  straightening.clear();
  if (paper && !lift_.is_known()) {
    lift_.solve(capped_curves(memory.surface(), drawing.curves(), options_), options_, progress);
  }
  close_rings();
  mesh_ = unroll(memory.mesh(), curves_, alone, reach(alone), progress);
  strips_ = std::make_unique<SmoothingMemory>(OpenedMesh::open(mesh_.lists));
  const std::vector<SurfaceCurve> curves =
      mesh_.unrolled(memory.mesh(), strips_->surface(), curves_);
  const CurveOptions own = options_on(curves);
  on_strips_ = checked_drawing(strips_->mesh(), curves, own, progress);
  sheet_ = std::make_unique<WholeSheet>(*strips_, on_strips_, own,
                                        EmbeddedDrawing::Ground{Loops::kErase, nullptr}, progress);
  if (paper) {
    sheet_->set_distance(copies_of({lift_.distance(), 1}));
  } else {
    sheet_->solve(progress);
  }
  solve_ms_ = watch.ms() - lift_.open_ms();
}

void UnrolledSheet::close_rings() {
  curves_ = drawing_->curves();
  is_ring_.assign(curves_.size(), false);
  if (options_.method != Method::kCorridor || !options_.join_ends) return;
  const auto with_itself = [](std::size_t a, std::size_t b) { return a == b; };
  for (const JoinedCurves& group :
       joined_curves(memory_->surface(), drawing_->curves(), options_.corners, with_itself)) {
    const std::size_t c = group.parts.front().curve;
    if (!group.is_ring || curves_[c].points.size() < 4) continue;
    is_ring_[c] = true;
    curves_[c].closed = true;
    curves_[c].points.pop_back();
  }
}

CurveOptions UnrolledSheet::options_on(std::span<const SurfaceCurve> curves) const {
  CurveOptions there = options_there(
      options_, [&](std::span<const SurfacePoint> points) { return copies_on(curves, points); });
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (is_ring_[c]) there.pins.push_back(curves[c].points.front());
  }
  return there;
}

SmoothingOptions UnrolledSheet::options_on(SmoothingOptions options) const {
  for (std::size_t c = 0; c < options.slack_at.size(); ++c) {
    if (is_ring_[c]) options.slack_at[c].pop_back();
  }
  return on_strips_.ordered(std::move(options));
}

/// Results on the strips in the order of the drawing; rings are open again.
Smoothed UnrolledSheet::opened(Smoothed smoothed) const {
  for (std::size_t c = 0; c < smoothed.curves.size(); ++c) {
    if (!is_ring_[c]) continue;
    SurfaceCurve& curve = smoothed.curves[c].curve;
    const SurfacePoint& end = on_strips_.drawn()[c].points.front();
    std::rotate(curve.points.begin(), std::find(curve.points.begin(), curve.points.end(), end),
                curve.points.end());
    curve.points.push_back(curve.points.front());
    curve.closed = false;
  }
  return smoothed;
}

double UnrolledSheet::reach(const std::vector<bool>& alone) const {
  double reach = 0;
  for (std::size_t c = 0; c < drawing_->curves().size(); ++c) {
    if (!alone[c]) continue;
    reach = std::max(
        reach, corridor_reach(memory_->mesh(), drawing_->curves()[c], drawing_->edges_near()[c]));
  }
  return reach;
}

std::vector<double> UnrolledSheet::copies_of(const GivenPotential& given) const {
  std::vector<double> copies;
  for (const VertexId v : mesh_.vertex_of) {
    const auto values = given.values.subspan(v.index() * given.components, given.components);
    copies.insert(copies.end(), values.begin(), values.end());
  }
  return copies;
}

/// The copies on the strips of these points of the drawing.
std::vector<SurfacePoint> UnrolledSheet::copies_on(std::span<const SurfaceCurve> curves,
                                                   std::span<const SurfacePoint> points) const {
  std::vector<SurfacePoint> result;
  for (std::size_t c = 0; c < curves_.size(); ++c) {
    const std::vector<SurfacePoint>& drawn = curves_[c].points;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      if (std::find(points.begin(), points.end(), drawn[i]) == points.end()) continue;
      result.push_back(curves[c].points[i]);
    }
  }
  return result;
}

void UnrolledSheet::set_pins(std::span<const SurfacePoint> pins, const Progress& progress) {
  options_.pins.assign(pins.begin(), pins.end());
  sheet_->set_pins(options_on(on_strips_.drawn()).pins, progress);
}

std::vector<double> UnrolledSheet::slack() const {
  const std::vector<double> slack = sheet_->slack();
  return slack.empty() ? slack : on_strips_.in_drawn_order(slack);
}

Smoothed UnrolledSheet::smooth(const SmoothingOptions& options, const GivenPotential* given,
                               const Progress& progress) {
  if (given != nullptr) {
    const std::vector<double> values = copies_of(*given);
    const GivenPotential there{values, given->components};
    return folded(opened(as_drawn(on_strips_, sheet_->smooth(options, &there, progress))),
                  progress);
  }
  const SmoothingOptions own =
      options_.method == Method::kPaper ? with_length_of_mesh(options) : options_on(options);
  return folded(opened(as_drawn(on_strips_, sheet_->smooth(own, nullptr, progress))), progress);
}

/// Sets L to its value on the whole mesh.
SmoothingOptions UnrolledSheet::with_length_of_mesh(const SmoothingOptions& options) const {
  double drawn_length = 0;
  for (const CurveMeasures& m : drawing_->measures()) drawn_length += m.length;
  double length = 0;
  for (const SurfaceCurve& curve : drawing_->curves()) {
    const FaceId face = any_face(memory_->surface(), curve.points.front());
    const VertexId corner = memory_->surface().corners(face).front();
    length = std::max(length, lift_.characteristic_length(options.potential, drawn_length, corner));
  }
  SmoothingOptions own = options;
  own.potential.length = PotentialOptions::Length::kGiven;
  own.potential.given_length = length;
  return own;
}

/// One sentence for each pin that no result passes because it lies on a spike or a curl that was
/// removed.
std::vector<std::string> UnrolledSheet::lost_pins(const Smoothed& smoothed) const {
  const Surface& surface = memory_->surface();
  std::vector<std::string> sentences;
  std::vector<SurfacePoint> pins = options_.pins;
  pins.insert(pins.end(), options_.corners.begin(), options_.corners.end());
  for (const SurfacePoint& pin : pins) {
    const auto passes = [&](const SurfacePoint& p) {
      const FaceId face = common_face(surface, pin, p);
      return face.valid() && distance_in_face(surface, coordinates_in(surface, pin, face),
                                              coordinates_in(surface, p, face)) <=
                                 1e-9 * drawing_->edges_near().front();
    };
    if (std::any_of(smoothed.curves.begin(), smoothed.curves.end(), [&](const SmoothedCurve& c) {
          return std::any_of(c.curve.points.begin(), c.curve.points.end(), passes);
        })) {
      continue;
    }
    const Point at = memory_->mesh().position(pin);
    const auto* v = std::get_if<AtVertex>(&pin.where());
    sentences.push_back(
        fmt::format("The pin {}at ({:.6g}, {:.6g}, {:.6g}) is lost: it lies on a spike or a curl "
                    "of the drawing that goes.",
                    v != nullptr ? fmt::format("(vertex {}) ", v->vertex.index()) : "", at.x(),
                    at.y(), at.z()));
  }
  return sentences;
}

/// Moves results from the strips back to the mesh.
Smoothed UnrolledSheet::folded(Smoothed smoothed, const Progress& progress) {
  std::vector<SurfaceCurve> curves;
  for (SmoothedCurve& curve : smoothed.curves) {
    curve.curve = mesh_.folded(strips_->surface(), memory_->surface(), curve.curve);
    curves.push_back(curve.curve);
  }
  const std::vector<std::size_t> after =
      memory_->straightening().crossings_of(drawing_->in_drawn_order(curves), progress);
  for (std::size_t c = 0; c < curves.size(); ++c) {
    smoothed.curves[c].crossings_before = crossings_[drawing_->numbers()[c]];
    smoothed.curves[c].crossings_after = after[drawing_->numbers()[c]];
  }
  smoothed.mollification = lift_.mollification();
  smoothed.warnings = lift_.warnings();
  const std::vector<std::string> lost = lost_pins(smoothed);
  smoothed.warnings.insert(smoothed.warnings.end(), lost.begin(), lost.end());
  smoothed.time_ms.open = lift_.open_ms();
  smoothed.time_ms.solve = solve_ms_;
  return smoothed;
}

}  // namespace talweg
