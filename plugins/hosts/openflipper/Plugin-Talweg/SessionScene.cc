// What the scene shows of a drawing: its points, the drawn lines as they lie on the mesh, the leg
// to the mouse.
#include <algorithm>

#include <OpenFlipper/BasePlugin/PluginFunctions.hh>

#include "CurveColours.hh"
#include "Session.hh"

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

void Session::show_drawing() {
  leg_ticket_ = 0;
  fill_drawing_line();
  show_nodes();
}

/// The host's line of the drawing has its history and the points of the last curve, for files and
/// scripts. The scene does not show it: between points that is a chord through the body.
void Session::fill_drawing_line() {
  const auto& curves = editor_.drawing().curves;
  if (drawing_id_ < 0) {
    if (curves.empty()) return;
    drawing_id_ = host_.add_line(QString("%1 drawing").arg(name_));
    if (PolyLineObject* made = PluginFunctions::polyLineObject(drawing_id_)) {
      made->setObjectDrawMode(ACG::SceneGraph::DrawModes::NONE, true);
      made->enablePicking(false);
    }
  }
  PolyLineObject* object = PluginFunctions::polyLineObject(drawing_id_);
  if (object == nullptr) return;
  if (curves.empty()) {
    object->line()->clear();
  } else {
    fill(*object->line(), mesh(), *arrays_, *curves.back());
  }
  host_.show_line(drawing_id_);
}

void Session::show_nodes() {
  if (!nodes_) return;
  BaseObjectData* line = nullptr;
  const bool hidden = drawing_id_ >= 0 && PluginFunctions::getObject(drawing_id_, line) &&
                      line != nullptr && !line->visible();
  nodes_->set_visible(object_.visible() && !hidden);
  nodes_->show_points(point_looks());
  nodes_->show_lines(line_looks());
  if (!editor_.is_drawing()) nodes_->show_leg({});
}

/// Hidden points are not there for the mouse either, but the one that closes a curve.
std::vector<PointLook> Session::point_looks() const {
  std::vector<PointLook> looks;
  const editing::Drawing& now = editor_.drawing();
  for (std::size_t c = 0; c < now.curves.size(); ++c) {
    const auto& points = now.curves[c]->points;
    for (std::size_t p = 0; p < points.size(); ++p) {
      if (!shows_point(c, p)) continue;
      const bool first = p == 0 && now.unfinished && c + 1 == now.curves.size();
      looks.push_back({vector_at(*arrays_, points[p]), points[p].pinned ? kPinned
                                                       : first          ? kFirst
                                                                        : kPoint});
    }
  }
  return looks;
}

bool Session::shows_point(std::size_t curve, std::size_t point) const {
  const bool drawn_now = editor_.is_drawing() && curve + 1 == editor_.drawing().curves.size();
  return with_points_ || (drawn_now && point == 0);
}

void Session::show_points(bool with) {
  with_points_ = with;
  show_nodes();
}

/// A curve that has changed keeps its line until the thread has the new one.
std::vector<LineLook> Session::line_looks() const {
  std::vector<LineLook> looks;
  for (const auto& curve : editor_.drawing().curves) {
    const auto drawn = drawn_.find(curve->number);
    if (drawn == drawn_.end()) continue;
    looks.push_back(look_of(drawn->second, colour_of_drawn(curve->number)));
  }
  return looks;
}

std::vector<const host::Curve*> Session::lines_of(std::size_t curve) const {
  std::vector<const host::Curve*> lines;
  const std::uint32_t number = editor_.drawing().curves.at(curve)->number;
  if (const auto result = result_of(number)) lines.push_back(&results_.curves[*result]);
  const auto drawn = drawn_.find(number);
  if (drawn != drawn_.end()) lines.push_back(&drawn->second);
  return lines;
}

void Session::ask_for_lines() {
  const editing::Drawing& now = editor_.drawing();
  if (!nodes_ || now.curves == lines_asked_) return;
  lines_asked_ = now.curves;
  tickets_.asked(thread_->draw(now), now);
}

void Session::take_drawn(editing::Outcome& outcome) {
  const std::vector<std::uint32_t> numbers = tickets_.take(outcome.ticket);
  drawn_.clear();
  auto& curves = outcome.results.curves;
  for (std::size_t c = 0; c < std::min(numbers.size(), curves.size()); ++c) {
    drawn_[numbers[c]] = std::move(curves[c]);
  }
  nodes_->show_leg({});
  nodes_->show_lines(line_looks());
  host_.redraw();
}

void Session::reach_for(const std::optional<editing::Point>& to) {
  if (!nodes_) return;
  if (!editor_.is_drawing() || !to) {
    leg_ticket_ = 0;
    nodes_->show_leg({});
    host_.redraw();
    return;
  }
  const editing::Point& from = editor_.drawing().curves.back()->points.back();
  if (!from.same_place(*to)) leg_ticket_ = thread_->leg(from, *to);
}

void Session::take_leg(const editing::Outcome& outcome) {
  if (outcome.ticket > leg_ticket_ || leg_ticket_ == 0 || outcome.results.curves.empty()) return;
  const std::uint32_t number = editor_.drawing().curves.back()->number;
  nodes_->show_leg(look_of(outcome.results.curves[0], colour_of_curve(number)));
  host_.redraw();
}

}  // namespace talweg::openflipper
