#include "session.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkVersionMacros.h>

#include "curve_input.hpp"
#include "number_list.hpp"
#include "panel_names.hpp"
#include "talweg_plugins.hpp"

namespace talweg::paraview {
namespace {

const talweg_parameter* find_parameter(const talweg_plugin& plugin, std::string_view id) {
  for (std::uint32_t k = 0; k < plugin.parameter_count; ++k) {
    if (plugin.parameters[k]->id == id) return plugin.parameters[k];
  }
  return nullptr;
}

const talweg_parameter& parameter_named(const talweg_plugin& plugin, const std::string& id) {
  const talweg_parameter* parameter = find_parameter(plugin, id);
  if (parameter != nullptr) return *parameter;
  throw std::runtime_error(std::string(plugin.id) + " " + plugin.version + " has no parameter " +
                           id + "; the panel was made for another version.");
}

/// The indices, in the path, of the vertices of `points`.
std::vector<std::uint32_t> places(const host::Curve& given, const host::Curve& path) {
  std::vector<std::uint32_t> result;
  for (const std::uint32_t pin : given.pins) {
    const auto at = std::find(path.vertices.begin(), path.vertices.end(), given.vertices.at(pin));
    result.push_back(static_cast<std::uint32_t>(at - path.vertices.begin()));
  }
  return result;
}

/// Sets the parameters about the mesh on another plugin, if it has them.
void copy_settings_of_meshes(const talweg_plugin& from,
                             const std::map<std::string, Setting>& values, host::Instance& to) {
  for (std::uint32_t k = 0; k < from.parameter_count; ++k) {
    const talweg_parameter& parameter = *from.parameters[k];
    const auto value = values.find(parameter.id);
    if (parameter.stage != TALWEG_STAGE_MESH || value == values.end()) continue;
    if (find_parameter(to.plugin(), parameter.id) == nullptr) continue;
    if (const auto* number = std::get_if<double>(&value->second)) to.set(parameter.id, *number);
  }
}

}  // namespace

Origin origin_of(vtkDataObject* curves, vtkDataObject* others) {
  const auto time = [](vtkDataObject* data) {
    std::uint64_t latest = data == nullptr ? 0 : data->GetMTime();
    if (data == nullptr) return latest;
    for (vtkDataSet* block : data_sets_of(*data)) {
      latest = std::max<std::uint64_t>(latest, block->GetMTime());
    }
    return latest;
  };
  return {curves, time(curves), others, time(others), 0};
}

Session::Session(const char* plugin, host::Services::Progress progress, host::Services::Log log)
    : id_(plugin), services_("ParaView", "VTK " VTK_VERSION, std::move(progress), std::move(log)) {}

const talweg_plugin& Session::plugin() const { return plugin_named(id_.c_str()); }

host::Instance& Session::instance() {
  if (!instance_) instance_ = std::make_unique<host::Instance>(plugin(), services_);
  return *instance_;
}

void Session::use(const std::string& plugin) {
  id_ = plugin;
  instance_.reset();
  draw_.reset();
  settings_.clear();
  applied_.clear();
  has_mesh_ = has_curves_ = false;
}

bool Session::set(const std::string& id, Setting value) {
  const auto known = settings_.find(id);
  if (known != settings_.end() && known->second == value) return false;
  settings_[id] = std::move(value);
  return true;
}

double Session::number(const std::string& id, double otherwise) const {
  const auto known = settings_.find(id);
  const auto* value = known == settings_.end() ? nullptr : std::get_if<double>(&known->second);
  return value == nullptr ? otherwise : *value;
}

bool Session::take_mesh(vtkDataSet& input) {
  const bool same = !mesh_.update(input);
  apply_settings_of_meshes();
  if (same && has_mesh_) return false;
  has_mesh_ = has_curves_ = false;
  draw_.reset();
  std::erase_if(applied_,
                [](const auto& value) { return std::holds_alternative<FieldName>(value.second); });
  instance().set_mesh(mesh_.positions(), mesh_.triangles());
  has_mesh_ = true;
  ++state_;
  ++meshes_opened_;
  return true;
}

bool Session::take_curves(const Origin& origin,
                          const std::function<std::vector<host::Curve>()>& make) {
  if (has_curves_ && origin == origin_) return false;
  has_curves_ = false;
  instance().set_curves(make());
  origin_ = origin;
  has_curves_ = true;
  ++state_;
  ++curves_set_;
  return true;
}

std::vector<host::Curve> Session::along_edges(std::vector<host::Curve> curves) {
  const auto of_vertices = [](const host::Curve& curve) { return !curve.vertices.empty(); };
  if (std::none_of(curves.begin(), curves.end(), of_vertices)) return curves;
  if (!draw_) {
    draw_ = std::make_unique<host::Instance>(plugin_named("talweg.draw"), services_);
    copy_settings_of_meshes(instance().plugin(), settings_, *draw_);
    draw_->set("way", "edges");
    draw_->set_mesh(mesh_.positions(), mesh_.triangles());
  }
  draw_->set_curves(curves);
  const host::Results paths = draw_->run();
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const host::Curve& path = paths.curves.at(c);
    host::Curve& curve = curves[c];
    const std::vector<std::uint32_t> pins = places(curve, path);
    curve.vertices = path.vertices;
    curve.pins = pins;
    if (!curve.exact.empty()) curve.exact = path.exact;
  }
  return curves;
}

host::Results Session::run(const host::Wanted& wanted) {
  apply_settings();
  host::Results results = instance().run(wanted);
  ++runs_;
  return results;
}

bool Session::can_be_repaired() {
  host::Instance inspection(plugin_named("talweg.repair"), services_);
  inspection.set("repair", 0.0);
  inspection.set_mesh(mesh_.positions(), mesh_.triangles());
  return inspection.run().text("verdict") == "repairable";
}

void Session::apply_settings() {
  for (const auto& [id, setting] : settings_) {
    apply_if_new(parameter_named(instance().plugin(), id), setting);
  }
}

/// Applies parameters about the mesh before the mesh is set, since a mesh that is not a surface is
/// refused without its repair. A change opens the mesh again, and sets the curves again, since
/// edges may have changed.
void Session::apply_settings_of_meshes() {
  for (const auto& [id, setting] : settings_) {
    const talweg_parameter& parameter = parameter_named(instance().plugin(), id);
    if (parameter.stage != TALWEG_STAGE_MESH) continue;
    const auto known = applied_.find(id);
    if (known != applied_.end() && known->second == setting) continue;
    has_mesh_ = false;
    apply_if_new(parameter, setting);
  }
}

void Session::apply_if_new(const talweg_parameter& parameter, const Setting& setting) {
  const Setting value = current(setting);
  const auto known = applied_.find(parameter.id);
  if (known != applied_.end() && known->second == value) return;
  apply(parameter, value);
  applied_[parameter.id] = value;
  if (parameter.stage != TALWEG_STAGE_RUN) ++state_;
}

vtkDataArray* Session::array(const FieldName& field) const {
  return field.of_cells ? mesh_.cell_arrays().GetArray(field.name.c_str())
                        : mesh_.arrays().GetArray(field.name.c_str());
}

vtkDataArray* Session::array_of(const std::string& id) const {
  const auto known = settings_.find(id);
  const auto* field = known == settings_.end() ? nullptr : std::get_if<FieldName>(&known->second);
  return field == nullptr || field->name.empty() ? nullptr : array(*field);
}

void Session::check_is_one_number_each(const FieldName& field) const {
  const std::string kind = field.of_cells ? "cell" : "point";
  vtkFieldData& arrays = field.of_cells ? static_cast<vtkFieldData&>(mesh_.cell_arrays())
                                        : static_cast<vtkFieldData&>(mesh_.arrays());
  vtkAbstractArray* found = arrays.GetAbstractArray(field.name.c_str());
  if (found == nullptr)
    throw std::runtime_error("The mesh has no " + kind + " array " + field.name + ".");
  const std::string subject = "The " + kind + " array " + field.name + " of the mesh has ";
  if (vtkDataArray::SafeDownCast(found) == nullptr) {
    throw std::runtime_error(subject + "texts; numbers are needed.");
  }
  const int components = found->GetNumberOfComponents();
  if (components == 1) return;
  throw std::runtime_error(subject + std::to_string(components) + " components; one is needed.");
}

/// The setting with the state of its array, so that a change of the array counts as a change.
Setting Session::current(Setting value) const {
  if (auto* field = std::get_if<FieldName>(&value); field != nullptr && !field->name.empty()) {
    vtkDataArray* values = array(*field);
    field->time = values == nullptr ? 0 : values->GetMTime();
  }
  return value;
}

void Session::apply(const talweg_parameter& parameter, const Setting& value) {
  if (const auto* number = std::get_if<double>(&value)) return apply_number(parameter, *number);
  if (const auto* choice = std::get_if<Choice>(&value))
    return instance().set(parameter.id, choice->id);
  if (const auto* list = std::get_if<VertexList>(&value)) {
    return instance().set(parameter.id, vertex_numbers(list->numbers, panel_name(parameter.id)));
  }
  if (const auto* list = std::get_if<CurveNumbers>(&value)) {
    return apply_curve_numbers(parameter, list->numbers);
  }
  apply_field(parameter.id, std::get<FieldName>(value));
}

/// Sets a number; a value below 0 resets an optional number.
void Session::apply_number(const talweg_parameter& parameter, double value) {
  if ((parameter.flags & TALWEG_OPTIONAL) != 0 && value < 0) return instance().reset(parameter.id);
  instance().set(parameter.id, value);
}

void Session::apply_curve_numbers(const talweg_parameter& parameter, const std::string& text) {
  const std::vector<double> values = numbers(text, panel_name(parameter.id));
  if (values.empty()) return instance().reset(parameter.id);
  instance().set(parameter.id, values);
}

/// Sets a field; all triangles of a polygon have the polygon's value.
void Session::apply_field(const char* id, const FieldName& field) {
  if (field.name.empty()) return instance().reset(id);
  vtkDataArray* values = array(field);
  check_is_one_number_each(field);
  std::vector<double> numbers;
  if (field.of_cells) {
    for (const vtkIdType cell : mesh_.cells()) numbers.push_back(values->GetTuple1(cell));
  } else {
    for (vtkIdType k = 0; k < values->GetNumberOfTuples(); ++k) {
      numbers.push_back(values->GetTuple1(k));
    }
  }
  instance().set(id, numbers);
}

}  // namespace talweg::paraview
