#include "DrawnCurves.hh"

#include <algorithm>
#include <utility>

#include "CurveColours.hh"
#include "HostMesh.hh"

namespace talweg::openflipper {
namespace {

const ACG::Vec4f kPoint(1.0f, 0.75f, 0.1f, 1.0f), kPinned(0.9f, 0.1f, 0.1f, 1.0f);
const ACG::Vec4f kFirst(0.2f, 0.5f, 1.0f, 1.0f);

LineLook look_of(const host::Curve& line, const ACG::Vec4f& colour) {
  LineLook look;
  look.closed = line.closed;
  look.colour = colour;
  look.points.reserve(line.positions.size());
  for (const auto& p : line.positions) look.points.emplace_back(p[0], p[1], p[2]);
  return look;
}

}  // namespace

void DrawnCurves::show(const editing::Drawing& drawing, const editing::MeshArrays& arrays) {
  if (nodes_ == nullptr) return;
  nodes_->show_points(point_looks(drawing, arrays));
  nodes_->show_lines(line_looks(drawing));
  if (!drawing.unfinished) hide_leg();
}

std::vector<PointLook> DrawnCurves::point_looks(const editing::Drawing& drawing,
                                                const editing::MeshArrays& arrays) const {
  std::vector<PointLook> looks;
  for (std::size_t c = 0; c < drawing.curves.size(); ++c) {
    const auto& points = drawing.curves[c]->points;
    for (std::size_t p = 0; p < points.size(); ++p) {
      if (!shows_point(drawing, c, p)) continue;
      const bool first = p == 0 && drawing.unfinished && c + 1 == drawing.curves.size();
      looks.push_back({vector_at(arrays, points[p]), points[p].pinned ? kPinned
                                                     : first          ? kFirst
                                                                      : kPoint});
    }
  }
  return looks;
}

bool DrawnCurves::shows_point(const editing::Drawing& drawing, std::size_t curve,
                              std::size_t point) const {
  const bool drawn_now = drawing.unfinished && curve + 1 == drawing.curves.size();
  return with_points_ || (drawn_now && point == 0);
}

std::vector<LineLook> DrawnCurves::line_looks(const editing::Drawing& drawing) const {
  std::vector<LineLook> looks;
  for (const auto& curve : drawing.curves) {
    if (const host::Curve* line = line_of(curve->number)) {
      looks.push_back(look_of(*line, colour_of_drawn(curve->number)));
    }
  }
  return looks;
}

const host::Curve* DrawnCurves::line_of(std::uint32_t number) const {
  const auto drawn = lines_.find(number);
  return drawn == lines_.end() ? nullptr : &drawn->second;
}

void DrawnCurves::take(std::vector<host::Curve> lines, const std::vector<std::uint32_t>& numbers,
                       const editing::Drawing& drawing) {
  lines_.clear();
  for (std::size_t c = 0; c < std::min(numbers.size(), lines.size()); ++c) {
    lines_[numbers[c]] = std::move(lines[c]);
  }
  hide_leg();
  if (nodes_ != nullptr) nodes_->show_lines(line_looks(drawing));
}

void DrawnCurves::show_leg(const host::Curve& leg, std::uint32_t number) {
  if (nodes_ != nullptr) nodes_->show_leg(look_of(leg, colour_of_curve(number)));
}

void DrawnCurves::hide_leg() {
  if (nodes_ != nullptr) nodes_->show_leg({});
}

}  // namespace talweg::openflipper
