#include "talweg/core/smoothing/embedded_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "talweg/core/drawing/drawn_curves.hpp"
#include "talweg/core/lifting/lifted_lengths.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/intrinsic/flips/signpost_triangulation.hpp"

namespace talweg {

std::vector<SurfaceCurve> capped_curves(const Surface& surface,
                                        std::span<const SurfaceCurve> curves,
                                        const CurveOptions& options) {
  std::vector<SurfaceCurve> capped(curves.begin(), curves.end());
  if (!options.cap_corners) return capped;
  for (SurfaceCurve& curve : capped) curve = capped_curve(surface, curve, options.pins);
  return capped;
}

EmbeddedDrawing::EmbeddedDrawing(SmoothingMemory& memory, const OrderedDrawing& drawing,
                                 CurveOptions options, Ground ground, const Progress& progress)
    : memory_(&memory), drawing_(&drawing), options_(std::move(options)), ground_(ground) {
  embed(progress);
}

void EmbeddedDrawing::set_pins(std::vector<SurfacePoint> pins, const Progress& progress) {
  options_.pins = std::move(pins);
  embed(progress);
}

void EmbeddedDrawing::embed(const Progress& progress) {
  CurveOptions own = options_;
  own.pins.insert(own.pins.end(), options_.corners.begin(), options_.corners.end());
  const std::vector<SurfacePoint> pins = own.pins;
  for (const WayPoint& way_point : options_.way_points) own.pins.push_back(way_point.point);
  legs_.clear();
  for (const SurfaceCurve& curve : drawing_->curves()) {
    legs_.push_back(legs_of(curve, pins, options_.way_points, options_.painted));
  }
  capped_ = capped_curves(surface(), drawing_->curves(), own);
  fixed_ = std::move(own.pins);
  flat_.reset();
  embed_curves(progress);
}

void EmbeddedDrawing::embed_curves(const Progress& progress) {
  memory_->straightening().embed(capped_, fixed_, ground_.loops, drawing_->numbers(), progress);
  is_embedded_ = true;
}

bool EmbeddedDrawing::any_legs() const {
  return std::any_of(legs_.begin(), legs_.end(), [](const DrawnLegs& legs) { return legs.any(); });
}

bool EmbeddedDrawing::all_legs() const {
  return std::all_of(legs_.begin(), legs_.end(), [](const DrawnLegs& legs) { return legs.all(); });
}

double EmbeddedDrawing::drawn_length() const {
  double length = 0;
  for (const CurveMeasures& m : drawing_->measures()) length += m.length;
  return length;
}

/// The option, or by default three mean segments of the drawn loop, but at most half of its length.
double EmbeddedDrawing::length_floor(const SmoothingOptions& options) const {
  if (options.length_floor) return *options.length_floor;
  double floor = HUGE_VAL;
  for (const SurfaceCurve& curve : capped_) {
    if (!curve.closed) continue;
    const double length = curve_length(surface(), curve);
    const double mean = length / static_cast<double>(curve.points.size());
    floor = std::min({floor, 3 * mean, length / 2});
  }
  return std::isfinite(floor) ? floor : 0;
}

Straightening::Options EmbeddedDrawing::straightening_options(
    const SmoothingOptions& options) const {
  Straightening::Options own;
  own.flip_out.max_iterations = options.max_iterations;
  own.flip_out.min_relative_length = options.min_relative_length;
  own.flip_out.length_floor = length_floor(options);
  own.prepare_whole_mesh = options.prepare_whole_mesh;
  if (may_cross_) {  // legs must be straightened completely
    own.flip_out.max_iterations.reset();
    own.flip_out.min_relative_length = 0;
  }
  return own;
}

bool EmbeddedDrawing::let_legs_cross(std::size_t crossings, const Progress& progress) {
  if (!all_legs()) return false;
  crossings_ = crossings;
  may_cross_ = true;
  may_cross_ = straighten_legs({}, progress).has_value();
  return may_cross_;
}

/// Legs cannot be straightened one by one with a limit of FlipOut, which is for all curves
/// together.
bool EmbeddedDrawing::may_straighten_legs(const Straightening::Options& options) const {
  return ground_.loops == Loops::kKeep && ground_.fence == nullptr &&
         !options.flip_out.max_iterations && options.flip_out.min_relative_length == 0;
}

std::optional<Straightened> EmbeddedDrawing::straighten_legs(const SmoothingOptions& options,
                                                             const Progress& progress) {
  const Straightening::Options own = straightening_options(options);
  if (!may_straighten_legs(own)) return std::nullopt;
  is_embedded_ = false;
  return memory_->straight_legs().straightened(memory_->mesh(), memory_->straightening(), capped_,
                                               legs_, own, progress);
}

Straightened EmbeddedDrawing::straighten_flat(const SmoothingOptions& options,
                                              const Progress& progress) {
  const Straightening::Options own = straightening_options(options);
  if (flat_ && flat_->options == own) return flat_->straight;
  flat_.reset();
  std::optional<Straightened> result;
  if (all_legs()) result = straighten_legs(options, progress);
  if (result && !may_cross_ && legs_meet(surface(), result->curves, legs_)) result.reset();
  if (!result) result = straighten(options, unlifted_length, progress);
  flat_ = Flat{own, *result};
  flat_->straight.time_ms = {};
  return *std::move(result);
}

Straightened EmbeddedDrawing::straighten(const SmoothingOptions& options,
                                         SignpostTriangulation::Metric metric,
                                         const Progress& progress) {
  if (!is_embedded_) embed_curves(progress);
  Straightened result =
      memory_->straightening().run(std::move(metric), straightening_options(options), progress);
  if (ground_.fence == nullptr) return result;
  const std::vector<bool>& fence = *ground_.fence;
  result.at_fence = std::any_of(result.touched.begin(), result.touched.end(), [&](VertexId v) {
    return v.index() < fence.size() && fence[v.index()];
  });
  return result;
}

}  // namespace talweg
