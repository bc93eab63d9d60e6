#include "ResultLines.hh"

#include <algorithm>
#include <utility>

#include <OpenFlipper/BasePlugin/PluginFunctions.hh>

#include "CurveColours.hh"
#include "CurveTickets.hh"
#include "HostMesh.hh"

namespace talweg::openflipper {
namespace {

constexpr float kWidth = 3.0f, kSelected = 5.0f;  // pixels

const host::Field* deviation_of(const host::Curve& curve) {
  const auto at = std::find_if(curve.fields.begin(), curve.fields.end(),
                               [](const host::Field& field) { return field.name == "deviation"; });
  return at == curve.fields.end() ? nullptr : &*at;
}

}  // namespace

void ResultLines::show(const TriMesh& mesh, const std::vector<host::Curve>& curves,
                       const std::vector<std::uint32_t>& numbers, const editing::Drawing& drawing) {
  keep(numbers, drawing);
  largest_deviation_ = 0;
  for (const host::Curve& curve : curves) {
    const host::Field* deviation = deviation_of(curve);
    if (deviation == nullptr) continue;
    largest_deviation_ = std::max(largest_deviation_, largest_of(deviation->values));
  }
  for (std::size_t c = 0; c < curves.size(); ++c) {
    PolyLineObject* object = PluginFunctions::polyLineObject(lines_[c].id);
    if (object == nullptr) continue;
    fill(*object->line(), mesh, curves[c]);
    if (const host::Field* deviation = deviation_of(curves[c])) {
      colour(*object->line(), deviation->values, largest_deviation_);
    }
    host_.show_line(lines_[c].id);
  }
}

void ResultLines::keep(const std::vector<std::uint32_t>& numbers, const editing::Drawing& drawing) {
  std::vector<Line> before = std::exchange(lines_, {});
  for (const std::uint32_t number : numbers) {
    const QString name = name_of(number, drawing);
    const auto old = std::find_if(before.begin(), before.end(),
                                  [number](const Line& line) { return line.number == number; });
    if (old == before.end()) {
      lines_.push_back({add(name, number), number, name});
      continue;
    }
    PolyLineObject* object = PluginFunctions::polyLineObject(old->id);
    if (object != nullptr && name != old->name) object->setName(name);
    lines_.push_back({old->id, number, name});
    before.erase(old);
  }
  for (const Line& line : before) host_.remove_object(line.id);
  show_widths();
}

QString ResultLines::name_of(std::uint32_t number, const editing::Drawing& drawing) const {
  const auto at = index_of(drawing, number);
  const bool named = at && !drawing.curves[*at]->name.empty();
  return QString("%1 smoothed %2")
      .arg(mesh_name_,
           named ? QString::fromStdString(drawing.curves[*at]->name) : QString::number(number));
}

int ResultLines::add(const QString& name, std::uint32_t number) {
  const int id = host_.add_line(name);
  if (PolyLineObject* made = PluginFunctions::polyLineObject(id)) {
    const ACG::Vec4f colour = colour_of_curve(number);
    made->materialNode()->set_color(colour);
    // The host draws lines in the sum of these two colours.
    made->materialNode()->set_ambient_color(colour * 0.5f);
    made->materialNode()->set_diffuse_color(colour * 0.5f);
    made->materialNode()->set_point_size(1.0f);
    look(*made);
  }
  return id;
}

void ResultLines::look(PolyLineObject& line) const {
  line.setObjectDrawMode(with_deviations_ ? ACG::SceneGraph::DrawModes::EDGES_COLORED
                                          : ACG::SceneGraph::DrawModes::WIREFRAME);
}

void ResultLines::show_deviations(bool with) {
  with_deviations_ = with;
  for (const Line& line : lines_) {
    if (PolyLineObject* object = PluginFunctions::polyLineObject(line.id)) look(*object);
  }
}

void ResultLines::select(std::uint32_t number) {
  selected_ = number;
  show_widths();
}

void ResultLines::show_widths() const {
  for (const Line& line : lines_) {
    if (PolyLineObject* object = PluginFunctions::polyLineObject(line.id)) {
      object->materialNode()->set_line_width(line.number == selected_ ? kSelected : kWidth);
    }
  }
}

std::vector<int> ResultLines::ids() const {
  std::vector<int> ids;
  for (const Line& line : lines_) ids.push_back(line.id);
  return ids;
}

bool ResultLines::has(int id) const {
  return std::any_of(lines_.begin(), lines_.end(),
                     [id](const Line& line) { return line.id == id; });
}

std::optional<std::uint32_t> ResultLines::was_deleted(int id) {
  const auto at =
      std::find_if(lines_.begin(), lines_.end(), [id](const Line& line) { return line.id == id; });
  if (at == lines_.end()) return std::nullopt;
  const std::uint32_t number = at->number;
  lines_.erase(at);
  return number;
}

}  // namespace talweg::openflipper
