#include "session.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <vtkPointData.h>
#include <vtkVersionMacros.h>

#include "number_list.hpp"
#include "talweg_plugins.hpp"

namespace talweg::paraview {
namespace {

const talweg_parameter& parameter_named(const talweg_plugin& plugin, const std::string& id) {
  for (std::uint32_t k = 0; k < plugin.parameter_count; ++k) {
    if (plugin.parameters[k]->id == id) return *plugin.parameters[k];
  }
  throw std::runtime_error(std::string(plugin.id) + " " + plugin.version + " has no parameter " +
                           id + "; the panel was made for another version.");
}

/// Where the vertices of `points` are in the path through them.
std::vector<std::uint32_t> places(const host::Curve& given, const host::Curve& path) {
  std::vector<std::uint32_t> result;
  for (const std::uint32_t pin : given.pins) {
    const auto at = std::find(path.vertices.begin(), path.vertices.end(), given.vertices.at(pin));
    result.push_back(static_cast<std::uint32_t>(at - path.vertices.begin()));
  }
  return result;
}

}  // namespace

Session::Session(host::Services::Progress progress, host::Services::Log log)
    : services_("ParaView", "VTK " VTK_VERSION, std::move(progress), std::move(log)) {}

host::Instance& Session::smooth() {
  if (!smooth_) {
    smooth_ = std::make_unique<host::Instance>(plugin_named("talweg.smooth"), services_);
  }
  return *smooth_;
}

bool Session::set(const std::string& id, Setting value) {
  const auto known = settings_.find(id);
  if (known != settings_.end() && known->second == value) return false;
  settings_[id] = std::move(value);
  return true;
}

void Session::take_mesh(vtkDataSet& input) {
  const bool same = !mesh_.update(input);
  if (same && has_mesh_) return;
  has_mesh_ = has_curves_ = has_distance_ = false;
  draw_.reset();
  smooth().set_mesh(mesh_.positions(), mesh_.triangles());
  has_mesh_ = true;
  ++meshes_opened_;
}

void Session::take_curves(const Origin& origin,
                          const std::function<std::vector<host::Curve>()>& make) {
  if (has_curves_ && origin == origin_) return;
  has_curves_ = has_distance_ = false;
  smooth().set_curves(drawn(make()));
  origin_ = origin;
  has_curves_ = true;
  ++curves_set_;
}

std::vector<host::Curve> Session::drawn(std::vector<host::Curve> curves) {
  const auto of_vertices = [](const host::Curve& curve) { return !curve.vertices.empty(); };
  if (std::none_of(curves.begin(), curves.end(), of_vertices)) return curves;
  if (!draw_) {
    draw_ = std::make_unique<host::Instance>(plugin_named("talweg.draw"), services_);
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

host::Results Session::run(bool with_distance) {
  apply_settings();
  host::Results results =
      smooth().run({.point_fields = true, .vertex_fields = with_distance && !has_distance_});
  if (!results.fields.empty()) {
    distance_ = std::move(results.fields.front().values);
    has_distance_ = true;
  }
  ++runs_;
  return results;
}

void Session::apply_settings() {
  for (const auto& [id, setting] : settings_) {
    const Setting value = current(setting);
    const auto known = applied_.find(id);
    if (known != applied_.end() && known->second == value) continue;
    const talweg_parameter& parameter = parameter_named(smooth().plugin(), id);
    apply(parameter, value);
    applied_[id] = value;
    if (parameter.stage != TALWEG_STAGE_RUN) has_distance_ = false;
  }
}

/// A field changes when its array does.
Setting Session::current(Setting value) {
  if (auto* field = std::get_if<FieldName>(&value); field != nullptr && !field->name.empty()) {
    vtkDataArray* array = mesh_.arrays().GetArray(field->name.c_str());
    field->time = array == nullptr ? 0 : array->GetMTime();
  }
  return value;
}

void Session::apply(const talweg_parameter& parameter, const Setting& value) {
  if (const auto* number = std::get_if<double>(&value)) return apply_number(parameter, *number);
  if (const auto* choice = std::get_if<Choice>(&value))
    return smooth().set(parameter.id, choice->id);
  if (const auto* list = std::get_if<VertexList>(&value)) {
    return smooth().set(parameter.id, vertex_numbers(list->numbers, parameter.label));
  }
  if (const auto* list = std::get_if<CurveNumbers>(&value)) {
    return apply_curve_numbers(parameter, list->numbers);
  }
  apply_field(parameter.id, std::get<FieldName>(value).name);
}

/// Below 0 an optional number is not given.
void Session::apply_number(const talweg_parameter& parameter, double value) {
  if ((parameter.flags & TALWEG_OPTIONAL) != 0 && value < 0) return smooth().reset(parameter.id);
  smooth().set(parameter.id, value);
}

void Session::apply_curve_numbers(const talweg_parameter& parameter, const std::string& text) {
  const std::vector<double> values = numbers(text, parameter.label);
  if (values.empty()) return smooth().reset(parameter.id);
  smooth().set(parameter.id, values);
}

void Session::apply_field(const char* id, const std::string& name) {
  if (name.empty()) return smooth().reset(id);
  vtkDataArray* array = mesh_.arrays().GetArray(name.c_str());
  if (array == nullptr || array->GetNumberOfComponents() != 1) {
    throw std::runtime_error("The mesh has no point array " + name + " of one component.");
  }
  std::vector<double> values(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t k = 0; k < values.size(); ++k) {
    values[k] = array->GetTuple1(static_cast<vtkIdType>(k));
  }
  smooth().set(id, values);
}

}  // namespace talweg::paraview
