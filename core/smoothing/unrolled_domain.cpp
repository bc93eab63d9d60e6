#include "talweg/core/smoothing/unrolled_domain.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "talweg/core/drawing/crossings.hpp"
#include "talweg/core/drawing/drawn_legs.hpp"
#include "talweg/core/fairing/joined_curves.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/core/smoothing/corridor_width.hpp"
#include "talweg/core/space/message_numbers.hpp"
#include "talweg/intrinsic/stopwatch.hpp"
#include "talweg/intrinsic/surface/point_lookup.hpp"

namespace talweg {
namespace {

constexpr std::size_t kFewFaces = 200'000;  // of strips: exact distances then take about a second

std::string limited_to(double distance) {
  return fmt::format(
      "The drawing meets itself, so only results within {} of the drawing were considered.",
      mesh_units_text(distance));
}

}  // namespace

UnrolledDomain::UnrolledDomain(SmoothingMemory& memory, const OrderedDrawing& drawing,
                               CurveOptions options, const std::vector<bool>& alone,
                               std::optional<std::vector<double>> distance,
                               const Progress& progress)
    : memory_(&memory),
      drawing_(&drawing),
      options_(std::move(options)),
      alone_(alone),
      lift_(memory.opened(), memory.straightening()) {
  const Stopwatch watch;
  // The crossings of each curve with itself and with later curves, in drawn order.
  Straightening& straightening = memory.straightening();
  const std::vector<EdgePath> paths = drawing.in_drawn_order(straightening.paths());
  crossings_ = path_contacts(straightening.triangulation(), paths).crossings;
  const bool paper = options_.method == Method::kPaper;
  if (distance) lift_.set(*std::move(distance), drawing.curves().size() > 1);
  straightening.clear();
  if (paper && !lift_.is_known()) {
    lift_.solve(capped_curves(memory.surface(), drawing.curves(), options_), options_.heat(),
                progress);
  }
  close_rings();
  solve_ms_ = watch.ms() - lift_.open_ms();
  set_reach();
  add_strips(progress);
}

/// Sets the reach of the first strips, which contains most results, and the largest number of
/// faces. Later strips have twice the reach each, until a result stays inside. For tau < 1/8 a
/// result may be anywhere, and exact distances cost far more than the strips, so the number of
/// faces is limited; the limit is larger if all curves are legs, which need no distances.
void UnrolledDomain::set_reach() {
  constexpr double kOfSlack = 2, kOfEdge = 6;
  const Surface& surface = memory_->surface();
  bool all_free = true;
  for (std::size_t c = 0; c < drawing_->curves().size(); ++c) {
    if (!alone_[c]) continue;
    const SurfaceCurve& curve = drawing_->curves()[c];
    const bool free = legs_of(curve, options_.pins, options_.way_points, options_.painted).all();
    all_free = all_free && free;
    const double slack = free ? 0 : drawing_->slacks()[c].slack;
    reach_ = std::max(reach_, kOfSlack * slack + kOfEdge * drawing_->edges_near()[c]);
  }
  most_faces_ = std::max(kFewFaces, surface.face_count() / (all_free ? 1 : 8));
}

std::unique_ptr<UnrolledDomain::Strips> UnrolledDomain::laid_strips(
    const std::vector<SurfaceCurve>& drawn, const std::vector<bool>& is_ring,
    const Progress& progress) const {
  auto strips = std::make_unique<Strips>();
  strips->drawn = drawn;
  strips->is_ring = is_ring;
  strips->mesh = unroll(memory_->mesh(), drawn, alone_, reach_, progress);
  strips->memory = std::make_unique<SmoothingMemory>(OpenedMesh::open(strips->mesh.lists));
  const std::vector<SurfaceCurve> curves =
      strips->mesh.unrolled(memory_->mesh(), strips->memory->surface(), drawn);
  const CurveOptions own = options_on(*strips, curves);
  strips->drawing =
      checked_drawing(strips->memory->mesh(), curves, drawing_->slacks(), own, progress);
  strips->domain = std::make_unique<MeshDomain>(
      *strips->memory, strips->drawing, own,
      EmbeddedDrawing::Ground{Loops::kErase, &strips->mesh.at_cut}, progress);
  return strips;
}

/// Opens the rings whose ends were on a spike that has been erased. Tells whether there are any.
bool UnrolledDomain::open_lost_rings(Strips& strips) const {
  const Straightening& straightening = strips.memory->straightening();
  bool any = false;
  for (std::size_t c = 0; c < strips.is_ring.size(); ++c) {
    if (!strips.is_ring[c]) continue;
    const auto path = straightening.paths()[strips.drawing.place_of(c)].halfedges();
    const SurfacePoint& end = strips.drawing.drawn()[c].points.front();
    if (std::any_of(path.begin(), path.end(), [&](HalfedgeId h) {
          const SignpostTriangulation& triangulation = straightening.triangulation();
          return triangulation.location(triangulation.tail(h)) == end;
        })) {
      continue;
    }
    any = true;
    strips.is_ring[c] = false;
    strips.drawn[c] = drawing_->curves()[c];
  }
  return any;
}

void UnrolledDomain::add_strips(const Progress& progress) {
  const Stopwatch watch;
  auto strips = laid_strips(curves_, is_ring_, progress);
  if (open_lost_rings(*strips)) strips = laid_strips(strips->drawn, strips->is_ring, progress);
  if (options_.method == Method::kPaper) {
    strips->domain->set_distance(copies_of(*strips, {lift_.distance(), 1}));
  } else {
    strips->domain->solve(progress);
  }
  strips_.push_back(std::move(strips));
  reach_ *= 2;
  solve_ms_ += watch.ms();
}

void UnrolledDomain::close_rings() {
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

CurveOptions UnrolledDomain::options_on(const Strips& strips,
                                        std::span<const SurfaceCurve> curves) const {
  CurveOptions there = options_there(options_, copies_on(strips, curves));
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (strips.is_ring[c]) there.pins.push_back(curves[c].points.front());
  }
  return there;
}

SmoothingOptions UnrolledDomain::options_on(const Strips& strips, SmoothingOptions options) const {
  if (options_.method == Method::kPaper) return with_length_of_mesh(options);
  for (std::size_t c = 0; c < options.slack_at.size(); ++c) {
    if (strips.is_ring[c]) options.slack_at[c].pop_back();
  }
  return strips.drawing.ordered(std::move(options));
}

/// Results on the strips with rings opened again at their ends.
DomainResult UnrolledDomain::opened(const Strips& strips, DomainResult smoothed) {
  for (std::size_t c = 0; c < smoothed.curves.size(); ++c) {
    if (!strips.is_ring[c]) continue;
    SurfaceCurve& curve = smoothed.curves[c].curve;
    const SurfacePoint& end = strips.drawing.drawn()[c].points.front();
    std::rotate(curve.points.begin(), std::find(curve.points.begin(), curve.points.end(), end),
                curve.points.end());
    curve.points.push_back(curve.points.front());
    curve.closed = false;
  }
  return smoothed;
}

std::vector<double> UnrolledDomain::copies_of(const Strips& strips, const GivenPotential& given) {
  std::vector<double> copies;
  for (const VertexId v : strips.mesh.vertex_of) {
    const auto values = given.values.subspan(v.index() * given.components, given.components);
    copies.insert(copies.end(), values.begin(), values.end());
  }
  return copies;
}

/// The copies of the drawing's points on the strips.
PointCopies UnrolledDomain::copies_on(const Strips& strips, std::span<const SurfaceCurve> curves) {
  PointCopies copies;
  for (std::size_t c = 0; c < strips.drawn.size(); ++c) {
    const std::vector<SurfacePoint>& drawn = strips.drawn[c].points;
    for (std::size_t i = 0; i < drawn.size(); ++i) copies.add(drawn[i], curves[c].points[i]);
  }
  return copies;
}

void UnrolledDomain::set_pins(std::span<const SurfacePoint> pins, const Progress& progress) {
  options_.pins.assign(pins.begin(), pins.end());
  for (const std::unique_ptr<Strips>& strips : strips_) {
    strips->domain->set_pins(options_on(*strips, strips->drawing.drawn()).pins, progress);
  }
}

std::vector<double> UnrolledDomain::slack() const {
  const std::vector<double> slack = strips_.front()->domain->slack();
  return slack.empty() ? slack : strips_.front()->drawing.in_drawn_order(slack);
}

DomainResult UnrolledDomain::smooth(const SmoothingOptions& options, const GivenPotential* given,
                                    const Progress& progress) {
  for (std::size_t k = 0;; ++k) {
    if (k == strips_.size()) add_strips(progress);
    const Strips& strips = *strips_[k];
    SmoothingOptions own = options_on(strips, options);
    own.prepare_whole_mesh = false;  // only touched faces matter
    DomainResult result = curves_on(strips, own, given, progress);
    const bool leaves = may_leave(strips.mesh.at_cut, strips.memory->surface(), result);
    const auto may_grow_to = [&](std::size_t faces) {
      return strips.mesh.may_grow && strips.mesh.faces_of_strips <= faces;
    };
    if (leaves && may_grow_to(most_faces_)) continue;
    if (options.prepare_whole_mesh) {
      own.prepare_whole_mesh = true;
      result = curves_on(strips, own, given, progress);
    }
    strips.domain->measure(own, result, progress);
    if (bound_deviation(strips, result) && may_grow_to(kFewFaces)) continue;
    if (leaves) result.warnings.push_back(limited_to(strips.mesh.near));
    return folded(strips, as_drawn(strips.drawing, std::move(result)), progress);
  }
}

/// The result on the strips, without its deviation.
DomainResult UnrolledDomain::curves_on(const Strips& strips, const SmoothingOptions& options,
                                       const GivenPotential* given, const Progress& progress) {
  if (given == nullptr) return strips.domain->curves(options, nullptr, progress);
  const std::vector<double> values = copies_of(strips, *given);
  const GivenPotential there{values, given->components};
  return strips.domain->curves(options, &there, progress);
}

/// Replaces a deviation beyond UnrolledMesh::near by bounds: the distance could be shorter on
/// strips with a longer reach. Tells whether there is any.
bool UnrolledDomain::bound_deviation(const Strips& strips, DomainResult& result) {
  bool any = false;
  for (CurveResult& curve : result.curves) {
    MeasuredDeviation& deviation = curve.deviation;
    if (deviation.measure != DeviationMeasure::kAlongSurface) continue;
    if (!(deviation.from_drawn_max > strips.mesh.near)) continue;
    any = true;
    deviation.spared = deviation.spared || deviation.exact;
    deviation.exact = false;
    deviation.at_least = std::min(deviation.at_least, strips.mesh.near);
  }
  return any;
}

/// Options of the paper's method with L of the whole mesh.
SmoothingOptions UnrolledDomain::with_length_of_mesh(const SmoothingOptions& options) const {
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

/// A sentence for each pin that no result passes, because it is on a spike or loop that was erased.
std::vector<std::string> UnrolledDomain::lost_pins(const DomainResult& smoothed) const {
  const Surface& surface = memory_->surface();
  std::vector<std::string> sentences;
  std::vector<SurfacePoint> pins = options_.pins;
  pins.insert(pins.end(), options_.corners.begin(), options_.corners.end());
  PointLookup passed;
  for (const CurveResult& curve : smoothed.curves) passed.add_all(curve.curve.points);
  for (const SurfacePoint& pin : pins) {
    if (passed.contains(pin)) continue;  // nearly all pins
    const auto passes = [&](const SurfacePoint& p) {
      const FaceId face = common_face(surface, pin, p);
      return face.valid() && distance_in_face(surface, coordinates_in(surface, pin, face),
                                              coordinates_in(surface, p, face)) <=
                                 1e-9 * drawing_->edges_near().front();
    };
    if (std::any_of(smoothed.curves.begin(), smoothed.curves.end(), [&](const CurveResult& c) {
          return std::any_of(c.curve.points.begin(), c.curve.points.end(), passes);
        })) {
      continue;
    }
    const Point at = memory_->mesh().position(pin);
    const auto* v = std::get_if<AtVertex>(&pin.where());
    sentences.push_back(
        fmt::format("The result misses the pin {}at {}: the pin lies on a "
                    "spike or a small loop of the drawing that smoothing removes.",
                    v != nullptr ? fmt::format("(vertex {}) ", v->vertex.index()) : "",
                    position_text(at, drawing_->edges_near().front())));
  }
  return sentences;
}

/// Converts results from the strips to the mesh.
DomainResult UnrolledDomain::folded(const Strips& strips, DomainResult smoothed,
                                    const Progress& progress) {
  smoothed = opened(strips, std::move(smoothed));
  std::vector<SurfaceCurve> curves;
  for (CurveResult& curve : smoothed.curves) {
    curve.curve = strips.mesh.folded(strips.memory->surface(), memory_->surface(), curve.curve);
    curves.push_back(curve.curve);
  }
  const std::vector<std::size_t> after =
      memory_->straightening().crossings_of(drawing_->in_drawn_order(curves), progress);
  for (std::size_t c = 0; c < curves.size(); ++c) {
    smoothed.curves[c].crossings_before = crossings_[drawing_->numbers()[c]];
    smoothed.curves[c].crossings_after = after[drawing_->numbers()[c]];
  }
  smoothed.at_fence = false;  // no larger strips follow
  smoothed.mollification = lift_.mollification();
  const std::vector<std::string> of_lift = lift_.warnings();
  smoothed.warnings.insert(smoothed.warnings.end(), of_lift.begin(), of_lift.end());
  const std::vector<std::string> lost = lost_pins(smoothed);
  smoothed.warnings.insert(smoothed.warnings.end(), lost.begin(), lost.end());
  smoothed.time_ms.open = lift_.open_ms();
  smoothed.time_ms.solve = solve_ms_;
  return smoothed;
}

}  // namespace talweg
