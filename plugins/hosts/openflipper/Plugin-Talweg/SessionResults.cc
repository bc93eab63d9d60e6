// Results of a session become lines of the host, and colours.
#include <algorithm>
#include <cmath>
#include <utility>

#include <OpenFlipper/BasePlugin/PluginFunctions.hh>

#include "CurveColours.hh"
#include "Session.hh"

namespace talweg::openflipper {
namespace {

constexpr float kWidth = 4.0f;

const host::Field* field_of(const host::Curve& curve, const char* name) {
  const auto at = std::find_if(curve.fields.begin(), curve.fields.end(),
                               [name](const host::Field& field) { return field.name == name; });
  return at == curve.fields.end() ? nullptr : &*at;
}

double largest_deviation(const std::vector<host::Curve>& curves) {
  double largest = 0;
  for (const host::Curve& curve : curves) {
    const host::Field* deviation = field_of(curve, "deviation");
    if (deviation == nullptr) continue;
    for (const double d : deviation->values) largest = std::max(largest, std::isfinite(d) ? d : 0);
  }
  return largest;
}

bool on_mesh(ColourBy by) { return by == ColourBy::kDistance || by == ColourBy::kPotential; }

void look_like(PolyLineObject& line, ColourBy by) {
  line.setObjectDrawMode(by == ColourBy::kDeviation ? ACG::SceneGraph::DrawModes::EDGES_COLORED
                                                    : ACG::SceneGraph::DrawModes::WIREFRAME);
}

}  // namespace

void Session::show_results(host::Results results, std::vector<std::uint32_t> numbers, bool newest) {
  results_ = std::move(results);
  numbers.resize(results_.curves.size());
  keep_lines(std::move(numbers));
  const double largest = largest_deviation(results_.curves);
  for (std::size_t c = 0; c < results_.curves.size(); ++c) {
    PolyLineObject* object = PluginFunctions::polyLineObject(lines_[c]);
    if (object == nullptr) continue;
    fill(*object->line(), mesh(), results_.curves[c]);
    if (const host::Field* deviation = field_of(results_.curves[c], "deviation")) {
      colour(*object->line(), deviation->values, largest);
    }
    host_.show_line(lines_[c]);
  }
  if (newest && !in_gesture() && log_next_ && !results_.curves.empty()) {
    log_next_ = false;
    host_.say(short_report(*this));
    if (on_mesh(colour_by_)) thread_->distance(editor_.drawing());
  }
  host_.changed();
}

/// Each curve keeps its line, whichever others come and go.
void Session::keep_lines(std::vector<std::uint32_t> numbers) {
  std::vector<int> before = std::exchange(lines_, {});
  const std::vector<std::uint32_t> numbers_before =
      std::exchange(line_numbers_, std::move(numbers));
  for (const std::uint32_t number : line_numbers_) {
    const auto at = std::find(numbers_before.begin(), numbers_before.end(), number);
    const auto k = static_cast<std::size_t>(at - numbers_before.begin());
    const bool there = k < before.size() && before[k] >= 0;
    lines_.push_back(there ? std::exchange(before[k], -1) : add_result_line(number));
  }
  for (const int id : before) {
    if (id >= 0) host_.remove_object(id);
  }
}

int Session::add_result_line(std::uint32_t number) {
  const int id = host_.add_line(QString("%1 smoothed %2").arg(name_).arg(number));
  if (PolyLineObject* made = PluginFunctions::polyLineObject(id)) {
    made->materialNode()->set_color(colour_of_curve(number));
    made->materialNode()->set_line_width(kWidth);
    made->materialNode()->set_point_size(1.0f);
    look_like(*made, colour_by_);
  }
  return id;
}

void Session::show_mesh_colours(const host::Results& results) {
  const char* wanted = colour_by_ == ColourBy::kPotential ? "potential" : "distance";
  for (const host::Field& field : results.fields) {
    if (field.name != wanted) continue;
    colour(mesh(), field.values);
    object_.setObjectDrawMode(ACG::SceneGraph::DrawModes::SOLID_POINTS_COLORED_SHADED);
    host_.show_colours(mesh_id_);
  }
}

void Session::colour_by(ColourBy by) {
  const ColourBy before = std::exchange(colour_by_, by);
  if (before == by) return;
  if (on_mesh(before) && !on_mesh(by)) {
    object_.setObjectDrawMode(ACG::SceneGraph::DrawModes::SOLID_SMOOTH_SHADED);
    host_.show_colours(mesh_id_);
  }
  for (const int id : lines_) {
    if (PolyLineObject* line = PluginFunctions::polyLineObject(id)) look_like(*line, by);
  }
  if (host_curves(editor_.drawing()).empty()) return;
  if (on_mesh(by)) thread_->distance(editor_.drawing());
  if (by == ColourBy::kDeviation) {
    asked_ = {};
    ask();
  }
  host_.changed();
}

}  // namespace talweg::openflipper
