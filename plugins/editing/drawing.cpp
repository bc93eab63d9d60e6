#include "drawing.hpp"

#include <algorithm>
#include <cmath>

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

}  // namespace

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

bool Drawing::operator==(const Drawing& other) const {
  return unfinished == other.unfinished && settings == other.settings &&
         std::equal(curves.begin(), curves.end(), other.curves.begin(), other.curves.end(), same);
}

Stage stage_between(const Drawing& before, const Drawing& after) {
  if (!std::equal(before.curves.begin(), before.curves.end(), after.curves.begin(),
                  after.curves.end(), same)) {
    return Stage::kCurves;
  }
  return before.settings == after.settings ? Stage::kNothing : Stage::kRun;
}

namespace {

/// The marks of the points; none if nothing is said of any.
std::vector<double> marks_of(const Curve& curve) {
  std::vector<double> marks;
  for (const Point& point : curve.points) marks.push_back(point.exact);
  const bool says_nothing =
      std::all_of(marks.begin(), marks.end(), [](double mark) { return mark == TALWEG_MARK_NONE; });
  return says_nothing ? std::vector<double>() : marks;
}

}  // namespace

bool all_clicked(const Drawing& drawing) {
  const auto clicked = [](const Point& point) { return point.exact >= 0; };
  const auto& curves = drawing.curves;
  return !curves.empty() && std::all_of(curves.begin(), curves.end(), [&](const auto& curve) {
    return std::all_of(curve->points.begin(), curve->points.end(), clicked);
  });
}

std::vector<host::Curve> host_curves(const Drawing& drawing) {
  std::vector<host::Curve> result;
  for (const auto& curve : drawing.curves) {
    if (curve->points.size() < 2) continue;
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

void apply(const Settings& settings, host::Instance& smooth) {
  smooth.set("tau", settings.tau);
  apply("slack", settings.slack, smooth);
  apply("max_deviation", settings.max_deviation, smooth);
}

}  // namespace talweg::editing
