// Results of a session become lines of the host, and colours.
#include <algorithm>
#include <cmath>
#include <utility>

#include <OpenFlipper/BasePlugin/PluginFunctions.hh>

#include "CurveColours.hh"
#include "Session.hh"

namespace talweg::openflipper {
namespace {

constexpr float kWidth = 3.0f, kSelected = 5.0f;  // pixels

const host::Field* field_of(const host::Curve& curve, const char* name) {
  const auto at = std::find_if(curve.fields.begin(), curve.fields.end(),
                               [name](const host::Field& field) { return field.name == name; });
  return at == curve.fields.end() ? nullptr : &*at;
}

double largest_of(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::isfinite(value) ? value : 0);
  return largest;
}

double largest_deviation(const std::vector<host::Curve>& curves) {
  double largest = 0;
  for (const host::Curve& curve : curves) {
    const host::Field* deviation = field_of(curve, "deviation");
    if (deviation != nullptr) largest = std::max(largest, largest_of(deviation->values));
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
  keep_lines(numbers);
  line_largest_ = largest_deviation(results_.curves);
  for (std::size_t c = 0; c < results_.curves.size(); ++c) {
    PolyLineObject* object = PluginFunctions::polyLineObject(lines_[c].id);
    if (object == nullptr) continue;
    fill(*object->line(), mesh(), results_.curves[c]);
    if (const host::Field* deviation = field_of(results_.curves[c], "deviation")) {
      colour(*object->line(), deviation->values, line_largest_);
    }
    host_.show_line(lines_[c].id);
  }
  measure_combs();
  show_combs();
  find_mark();
  if (newest && !in_gesture() && log_next_ && !results_.curves.empty()) {
    log_next_ = false;
    host_.say(short_report(*this));
    if (on_mesh(colour_by_)) thread_->distance(editor_.drawing());
  }
  host_.changed();
}

/// Each curve keeps its line, whichever others come and go.
void Session::keep_lines(const std::vector<std::uint32_t>& numbers) {
  std::vector<ResultLine> before = std::exchange(lines_, {});
  for (const std::uint32_t number : numbers) {
    const QString name = name_of_line(number);
    const auto old = std::find_if(before.begin(), before.end(), [number](const ResultLine& line) {
      return line.number == number;
    });
    if (old == before.end()) {
      lines_.push_back({add_result_line(name, number), number, name});
      continue;
    }
    PolyLineObject* object = PluginFunctions::polyLineObject(old->id);
    if (object != nullptr && name != old->name) object->setName(name);
    lines_.push_back({old->id, number, name});
    before.erase(old);
  }
  for (const ResultLine& line : before) host_.remove_object(line.id);
  show_widths();
}

QString Session::name_of_line(std::uint32_t number) const {
  const auto& curves = editor_.drawing().curves;
  const auto at = index_of(editor_.drawing(), number);
  const bool named = at && !curves[*at]->name.empty();
  return QString("%1 smoothed %2")
      .arg(name_, named ? QString::fromStdString(curves[*at]->name) : QString::number(number));
}

int Session::add_result_line(const QString& name, std::uint32_t number) {
  const int id = host_.add_line(name);
  if (PolyLineObject* made = PluginFunctions::polyLineObject(id)) {
    const ACG::Vec4f colour = colour_of_curve(number);
    made->materialNode()->set_color(colour);
    // The host draws lines in the sum of these two.
    made->materialNode()->set_ambient_color(colour * 0.5f);
    made->materialNode()->set_diffuse_color(colour * 0.5f);
    made->materialNode()->set_point_size(1.0f);
    look_like(*made, colour_by_);
  }
  return id;
}

void Session::show_widths() const {
  for (const ResultLine& line : lines_) {
    if (PolyLineObject* object = PluginFunctions::polyLineObject(line.id)) {
      object->materialNode()->set_line_width(line.number == selected_ ? kSelected : kWidth);
    }
  }
}

std::vector<int> Session::lines() const {
  std::vector<int> ids;
  for (const ResultLine& line : lines_) ids.push_back(line.id);
  return ids;
}

std::optional<std::size_t> Session::result_of(std::uint32_t number) const {
  for (std::size_t c = 0; c < std::min(lines_.size(), results_.curves.size()); ++c) {
    if (lines_[c].number == number) return c;
  }
  return std::nullopt;
}

std::optional<std::size_t> Session::selected() const {
  return index_of(editor_.drawing(), selected_);
}

void Session::select(std::optional<std::size_t> curve) {
  const std::uint32_t before = selected_;
  selected_ = curve ? editor_.drawing().curves.at(*curve)->number : 0;
  if (selected_ == before) return;
  show_widths();
  host_.changed();
}

void Session::show_mesh_colours(const host::Results& results) {
  const char* wanted = colour_by_ == ColourBy::kPotential ? "potential" : "distance";
  for (const host::Field& field : results.fields) {
    if (field.name != wanted) continue;
    mesh_largest_ = largest_of(field.values);
    colour(mesh(), field.values);
    object_.setObjectDrawMode(ACG::SceneGraph::DrawModes::SOLID_POINTS_COLORED_SHADED);
    host_.show_colours(mesh_id_);
  }
  host_.changed();
}

void Session::colour_by(ColourBy by) {
  const ColourBy before = std::exchange(colour_by_, by);
  if (before == by) return;
  if (on_mesh(before) && !on_mesh(by)) {
    object_.setObjectDrawMode(ACG::SceneGraph::DrawModes::SOLID_SMOOTH_SHADED);
    host_.show_colours(mesh_id_);
  }
  for (const ResultLine& line : lines_) {
    if (PolyLineObject* object = PluginFunctions::polyLineObject(line.id)) look_like(*object, by);
  }
  if (host_curves(editor_.drawing()).empty()) return;
  if (on_mesh(by)) thread_->distance(editor_.drawing());
  if (by == ColourBy::kDeviation) ask_again();
  host_.changed();
}

}  // namespace talweg::openflipper
