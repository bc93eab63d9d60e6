#include "drawing.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace talweg::editing {
namespace {

bool same(const std::shared_ptr<const Curve>& a, const std::shared_ptr<const Curve>& b) {
  return a == b || *a == *b;
}

void apply(const char* id, const std::optional<double>& value, host::Instance& smooth) {
  if (value) {
    smooth.set(id, *value);
  } else {
    smooth.reset(id);
  }
}

constexpr const char* kEnds[] = {"auto", "closed", "open"};
constexpr const char* kRidges[] = {"both", "convex", "concave"};

}  // namespace

const char* name_of(Ends ends) { return kEnds[static_cast<std::size_t>(ends)]; }

Ends ends_named(const std::string& name) {
  const auto* const found = std::find(std::begin(kEnds), std::end(kEnds), name);
  if (found == std::end(kEnds)) {
    throw Error("Ends must be auto, closed or open, not " + name + ".");
  }
  return static_cast<Ends>(found - std::begin(kEnds));
}

const char* name_of(RidgeKind kind) { return kRidges[static_cast<std::size_t>(kind)]; }

RidgeKind ridges_named(const std::string& name) {
  const auto* const found = std::find(std::begin(kRidges), std::end(kRidges), name);
  if (found == std::end(kRidges)) {
    throw Error("The kind of ridges must be both, convex or concave, not " + name + ".");
  }
  return static_cast<RidgeKind>(found - std::begin(kRidges));
}

Point picked(std::uint32_t face, const std::array<double, 3>& barycentric) {
  Point point{face, barycentric};
  double sum = 0;
  for (double& b : point.barycentric) {
    if (!std::isfinite(b)) throw Error("The point that was picked has no finite coordinates.");
    b = std::max(b, 0.0);
    sum += b;
  }
  if (!(sum > 0)) throw Error("The point that was picked lies outside of its triangle.");
  for (double& b : point.barycentric) b /= sum;
  return point;
}

bool Curve::operator==(const Curve& other) const {
  return points == other.points && closed == other.closed && tau == other.tau &&
         tolerance == other.tolerance && name == other.name;
}

bool Drawing::operator==(const Drawing& other) const {
  return unfinished == other.unfinished && settings == other.settings && offset == other.offset &&
         std::equal(curves.begin(), curves.end(), other.curves.begin(), other.curves.end(), same);
}

namespace {

bool same_place(const std::shared_ptr<const Curve>& a, const std::shared_ptr<const Curve>& b) {
  return a == b ||
         (a->points == b->points && a->closed == b->closed && a->tolerance == b->tolerance);
}

bool same_tau(const std::shared_ptr<const Curve>& a, const std::shared_ptr<const Curve>& b) {
  return a->tau == b->tau;
}

template <class Same>
bool all_same(const Drawing& a, const Drawing& b, Same same) {
  return std::equal(a.curves.begin(), a.curves.end(), b.curves.begin(), b.curves.end(), same);
}

/// The mark of a curve's point as plugins read it: a negative mark, or the tolerance of a
/// way-point, which is 0 at a pin.
double mark_of(const Curve& curve, const Point& point) {
  if (point.exact < 0) return point.exact;
  return point.pinned ? 0 : curve.tolerance.value_or(point.exact);
}

/// The marks of a curve's points; empty if no point has a mark.
std::vector<double> marks_of(const Curve& curve) {
  std::vector<double> marks;
  for (const Point& point : curve.points) marks.push_back(mark_of(curve, point));
  const bool says_nothing =
      std::all_of(marks.begin(), marks.end(), [](double mark) { return mark == TALWEG_MARK_NONE; });
  return says_nothing ? std::vector<double>() : marks;
}

bool can_be_smoothed(const Curve& curve) { return curve.points.size() >= 2; }

/// Sets a parameter with a value for each curve: -1 for a curve without a value of its own.
void apply_per_curve(const char* id, const std::vector<std::optional<double>>& values,
                     host::Instance& smooth) {
  std::vector<double> own;
  own.reserve(values.size());
  for (const std::optional<double>& value : values) own.push_back(value.value_or(-1));
  if (std::all_of(own.begin(), own.end(), [](double value) { return value == -1; })) {
    smooth.reset(id);
  } else {
    smooth.set(id, own);
  }
}

}  // namespace

Stage stage_between(const Drawing& before, const Drawing& after) {
  if (!all_same(before, after, same_place)) return Stage::kCurves;
  const bool same = before.settings == after.settings && all_same(before, after, same_tau);
  return same ? Stage::kNothing : Stage::kRun;
}

bool all_clicked(const Curve& curve) {
  return std::all_of(curve.points.begin(), curve.points.end(),
                     [](const Point& point) { return point.exact >= 0; });
}

std::vector<host::Curve> courses(const std::vector<host::Curve>& curves) {
  std::vector<host::Curve> result;
  for (const host::Curve& curve : curves) {
    host::Curve course;
    course.closed = curve.closed;
    course.faces = curve.faces;
    course.barycentrics = curve.barycentrics;
    result.push_back(std::move(course));
  }
  return result;
}

bool all_clicked(const Drawing& drawing) {
  const auto& curves = drawing.curves;
  return !curves.empty() && std::all_of(curves.begin(), curves.end(),
                                        [](const auto& curve) { return all_clicked(*curve); });
}

std::vector<host::Curve> host_curves(const Drawing& drawing) {
  std::vector<host::Curve> result;
  for (const auto& curve : drawing.curves) {
    if (!can_be_smoothed(*curve)) continue;
    host::Curve out;
    out.closed = curve->closed;
    for (std::size_t k = 0; k < curve->points.size(); ++k) {
      out.faces.push_back(curve->points[k].face);
      out.barycentrics.push_back(curve->points[k].barycentric);
      if (curve->points[k].pinned) out.pins.push_back(static_cast<std::uint32_t>(k));
    }
    out.exact = marks_of(*curve);
    result.push_back(std::move(out));
  }
  return result;
}

void apply(const Drawing& drawing, host::Instance& smooth) {
  const bool paper = drawing.settings.paper;
  smooth.set("tau", drawing.settings.tau);
  smooth.set("potential", paper ? "paper" : "corridor");
  apply("slack", paper ? std::nullopt : drawing.settings.slack, smooth);
  apply("max_deviation", paper ? std::nullopt : drawing.settings.max_deviation, smooth);
  apply("click_distance", drawing.settings.click_distance, smooth);
  smooth.set("ends", name_of(drawing.settings.ends));
  smooth.set("ridges", drawing.settings.ridges);
  smooth.set("ridge_kind", name_of(drawing.settings.ridge_kind));
  smooth.set("border", "snap");  // a hand cannot pick points beyond the border
  std::vector<std::optional<double>> taus, slacks;
  for (const auto& curve : drawing.curves) {
    if (paper || !can_be_smoothed(*curve)) continue;
    taus.push_back(curve->tau);
    slacks.push_back(all_clicked(*curve) ? std::nullopt : curve->tolerance);
  }
  apply_per_curve("taus", taus, smooth);
  apply_per_curve("slacks", slacks, smooth);
}

}  // namespace talweg::editing
