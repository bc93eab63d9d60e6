#include "editor.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace talweg::editing {
namespace {

std::size_t least_points(bool closed) { return closed ? 3 : 2; }

void require_points(const Curve& curve) {
  if (curve.points.size() >= least_points(curve.closed)) return;
  throw Error(curve.closed ? "A closed curve needs three points in different places."
                           : "A curve needs two points in different places.");
}

/// Removes points at the place of the point before, and last points of a closed curve at the place
/// of its first point.
void merge(Curve& curve) {
  std::vector<Point> points;
  for (const Point& point : curve.points) {
    if (points.empty() || !points.back().same_place(point)) points.push_back(point);
  }
  while (curve.closed && points.size() > 1 && points.back().same_place(points.front())) {
    points.pop_back();
  }
  curve.points = std::move(points);
}

bool has_way_points(const Curve& curve) {
  return std::any_of(curve.points.begin(), curve.points.end(),
                     [](const Point& point) { return point.exact >= 0; });
}

void require_bound(double value, bool zero, const char* what) {
  if (std::isfinite(value) && (zero ? value >= 0 : value > 0)) return;
  throw Error(std::string(what) + (zero ? " must be 0 or more." : " must be more than 0."));
}

void require(const Settings& settings) {
  require_bound(settings.tau, true, "Tau");
  if (settings.slack) require_bound(*settings.slack, true, "The slack");
  if (settings.click_distance) require_bound(*settings.click_distance, true, "The click distance");
  if (!(settings.ridges >= 0 && settings.ridges <= 1)) {
    throw Error("The strength of ridges must be from 0 to 1.");
  }
  if (settings.max_deviation) {
    require_bound(*settings.max_deviation, false, "The largest deviation");
  }
}

}  // namespace

Editor::Editor(const Settings& settings) : Editor(Drawing{{}, false, settings}) {}

Editor::Editor(Drawing drawing) {
  require(drawing.settings);
  history_ = History(std::move(drawing));
}

const Curve& Editor::curve_at(std::size_t curve) const {
  if (curve < drawing().curves.size()) return *drawing().curves[curve];
  throw Error("There is no curve " + std::to_string(curve) + "; the drawing has " +
              std::to_string(drawing().curves.size()) + ".");
}

const Curve& Editor::curve_at(std::size_t curve, std::size_t point) const {
  const Curve& there = curve_at(curve);
  if (point < there.points.size()) return there;
  throw Error("Curve " + std::to_string(curve) + " has no point " + std::to_string(point) +
              "; it has " + std::to_string(there.points.size()) + ".");
}

const Curve& Editor::unfinished() const {
  if (!is_drawing()) throw Error("No curve is being drawn.");
  return *drawing().curves.back();
}

void Editor::not_while_drawing() const {
  if (is_drawing()) throw Error("First end the curve that is being drawn.");
}

std::uint32_t Editor::next_number() const {
  std::uint32_t largest = 0;
  for (const auto& curve : drawing().curves) largest = std::max(largest, curve->number);
  return largest + 1;
}

/// Replaces a curve, or adds a curve if `curve` is the number of curves.
void Editor::replace(const std::string& name, std::size_t curve, Curve by, bool unfinished) {
  Drawing next = drawing();
  if (curve == next.curves.size()) {
    next.curves.emplace_back();
    by.number = next_number();
  }
  next.curves[curve] = std::make_shared<const Curve>(std::move(by));
  next.unfinished = unfinished;
  history_.add(name, std::move(next));
}

void Editor::erase(const std::string& name, std::size_t curve) {
  Drawing next = drawing();
  if (curve + 1 == next.curves.size()) next.unfinished = false;
  next.curves.erase(next.curves.begin() + static_cast<std::ptrdiff_t>(curve));
  history_.add(name, std::move(next));
}

void Editor::add_point(const Point& point) { append(point, 0); }
void Editor::paint_point(const Point& point) { append(point, TALWEG_MARK_PAINTED); }

void Editor::append(Point point, double mark) {
  if (point.exact == TALWEG_MARK_NONE) point.exact = mark;
  Curve curve;
  if (is_drawing()) curve = unfinished();
  if (!curve.points.empty() && curve.points.back().same_place(point)) return;
  if (mark == TALWEG_MARK_PAINTED && curve.points.size() == 1) curve.points[0].exact = mark;
  curve.points.push_back(point);
  const std::size_t last = drawing().curves.size() - (is_drawing() ? 1 : 0);
  replace("Add point", last, std::move(curve), true);
}

void Editor::take_back_point() {
  Curve curve = unfinished();
  curve.points.pop_back();
  const std::size_t last = drawing().curves.size() - 1;
  if (curve.points.empty()) {
    erase("Take back point", last);
  } else {
    replace("Take back point", last, std::move(curve), true);
  }
}

void Editor::finish_curve() {
  Curve curve = unfinished();
  require_points(curve);
  replace("Finish curve", drawing().curves.size() - 1, std::move(curve), false);
}

void Editor::close_curve() {
  Curve curve = unfinished();
  curve.closed = true;
  merge(curve);
  require_points(curve);
  replace("Close curve", drawing().curves.size() - 1, std::move(curve), false);
}

void Editor::drop_curve() {
  unfinished();
  erase("Drop curve", drawing().curves.size() - 1);
}

void Editor::add_curve(Curve curve) {
  not_while_drawing();
  merge(curve);
  require_points(curve);
  replace("Add curve", drawing().curves.size(), std::move(curve), false);
}

void Editor::remove_curve(std::size_t curve) {
  curve_at(curve);
  erase("Remove curve", curve);
}

void Editor::set_closed(std::size_t curve, bool closed) {
  not_while_drawing();
  Curve changed = curve_at(curve);
  changed.closed = closed;
  merge(changed);
  require_points(changed);
  replace(closed ? "Close curve" : "Open curve", curve, std::move(changed), false);
}

void Editor::reverse_curve(std::size_t curve) {
  not_while_drawing();
  Curve changed = curve_at(curve);
  std::reverse(changed.points.begin(), changed.points.end());
  replace("Reverse curve", curve, std::move(changed), false);
}

void Editor::clear() {
  Drawing next;
  next.settings = drawing().settings;
  next.offset = drawing().offset;
  next.offset.of.reset();
  history_.add("Remove all curves", std::move(next));
}

void Editor::move_point(std::size_t curve, std::size_t point, const Point& to) {
  Curve changed = curve_at(curve, point);
  Point& moved = changed.points[point];
  moved.face = to.face;
  moved.barycentric = to.barycentric;
  replace("Move point", curve, std::move(changed), is_drawing());
}

void Editor::insert_point(std::size_t curve, std::size_t before, const Point& point) {
  Curve changed = curve_at(curve);
  if (before > changed.points.size()) curve_at(curve, before);
  Point inserted = point;
  if (inserted.exact == TALWEG_MARK_NONE && has_way_points(changed)) inserted.exact = 0;
  changed.points.insert(changed.points.begin() + static_cast<std::ptrdiff_t>(before), inserted);
  replace("Insert point", curve, std::move(changed), is_drawing());
}

void Editor::remove_point(std::size_t curve, std::size_t point) {
  Curve changed = curve_at(curve, point);
  changed.points.erase(changed.points.begin() + static_cast<std::ptrdiff_t>(point));
  const bool drawn_now = is_drawing() && curve + 1 == drawing().curves.size();
  const std::size_t least = drawn_now ? 1 : least_points(changed.closed);
  if (changed.points.size() < least) {
    erase("Remove point", curve);
  } else {
    replace("Remove point", curve, std::move(changed), is_drawing());
  }
}

void Editor::set_pinned(std::size_t curve, std::size_t point, bool pinned) {
  Curve changed = curve_at(curve, point);
  changed.points[point].pinned = pinned;
  replace(pinned ? "Pin point" : "Unpin point", curve, std::move(changed), is_drawing());
}

void Editor::continue_curve(std::size_t curve) {
  not_while_drawing();
  if (curve_at(curve).closed) throw Error("A closed curve has no end to go on at; open it first.");
  Drawing next = drawing();
  const auto at = next.curves.begin() + static_cast<std::ptrdiff_t>(curve);
  std::rotate(at, at + 1, next.curves.end());
  next.unfinished = true;
  history_.add("Continue curve", std::move(next));
}

void Editor::rename_curve(std::size_t curve, const std::string& name) {
  Curve changed = curve_at(curve);
  changed.name = name;
  replace("Rename curve", curve, std::move(changed), is_drawing());
}

void Editor::set_curve_tau(std::size_t curve, std::optional<double> tau) {
  Curve changed = curve_at(curve);
  if (tau) require_bound(*tau, true, "Tau");
  changed.tau = tau;
  replace("Tau of curve", curve, std::move(changed), is_drawing());
}

void Editor::set_curve_tolerance(std::size_t curve, std::optional<double> tolerance) {
  Curve changed = curve_at(curve);
  if (tolerance) require_bound(*tolerance, true, "The tolerance");
  changed.tolerance = tolerance;
  replace("Tolerance of curve", curve, std::move(changed), is_drawing());
}

void Editor::pin_curve(std::size_t curve, bool pinned) {
  Curve changed = curve_at(curve);
  for (Point& point : changed.points) point.pinned = pinned;
  replace(pinned ? "Pin curve" : "Unpin curve", curve, std::move(changed), is_drawing());
}

void Editor::set(const std::string& name, const Settings& settings) {
  require(settings);
  Drawing next = drawing();
  next.settings = settings;
  history_.add(name, std::move(next));
}

void Editor::set_tau(double tau) {
  Settings settings = drawing().settings;
  settings.tau = tau;
  set("Tau", settings);
}

void Editor::set_slack(std::optional<double> slack) {
  Settings settings = drawing().settings;
  settings.slack = slack;
  set("Slack", settings);
}

void Editor::set_max_deviation(std::optional<double> bound) {
  Settings settings = drawing().settings;
  settings.max_deviation = bound;
  set("Largest deviation", settings);
}

void Editor::set_paper(bool paper) {
  Settings settings = drawing().settings;
  settings.paper = paper;
  set("Method", settings);
}

void Editor::set_ends(Ends ends) {
  Settings settings = drawing().settings;
  settings.ends = ends;
  set("Ends", settings);
}

void Editor::set_click_distance(std::optional<double> distance) {
  Settings settings = drawing().settings;
  settings.click_distance = distance;
  set("Click distance", settings);
}

void Editor::set_ridges(double strength) {
  Settings settings = drawing().settings;
  settings.ridges = strength;
  set("Snap to ridges", settings);
}

void Editor::set_ridge_kind(RidgeKind kind) {
  Settings settings = drawing().settings;
  settings.ridge_kind = kind;
  set("Kind of ridges", settings);
}

void Editor::set_offset(const Offset& offset) {
  if (offset.on) require_bound(offset.distance, false, "The distance of the offset");
  Drawing next = drawing();
  next.offset = offset;
  history_.add("Offset", std::move(next));
}

}  // namespace talweg::editing
