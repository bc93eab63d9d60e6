#include "plugin_options.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "field_file.hpp"
#include "talweg/core/repair/mesh_repair.hpp"

namespace talweg::driver {
namespace {

std::string range_of(const talweg_parameter& p) {
  const char* open = (p.flags & TALWEG_OPEN_MINIMUM) != 0 ? "(" : "[";
  return fmt::format("{}{:g}, {:g}{}", open, p.minimum, p.maximum,
                     std::isfinite(p.maximum) ? "]" : ")");
}

}  // namespace

std::string option_text(const talweg_parameter& p) {
  std::string text = p.doc;
  if (p.type == TALWEG_NUMBER || p.type == TALWEG_INTEGER) text += " In " + range_of(p);
  if (*p.unit != '\0') text += std::string(text.ends_with(".") ? " In " : ", ") + p.unit;
  if (!text.ends_with(".")) text += ".";
  if (p.type == TALWEG_FIELD) text += " A file, one number per vertex.";
  if (p.type == TALWEG_TRIANGLE_FIELD) text += " A file, one number per triangle.";
  return text;
}

CLI::Option* add_choice(CLI::App& app, const talweg_parameter& p, std::string& value) {
  return app.add_option(option_name(p.id), value, option_text(p))
      ->check(CLI::IsMember(std::vector<std::string>(p.choices, p.choices + p.choice_count)))
      ->default_str(p.default_choice);
}

std::string option_name(const std::string& id) {
  std::string name = "--" + id;
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

bool has_parameter(const talweg_plugin& plugin, std::string_view id) {
  for (std::uint32_t k = 0; k < plugin.parameter_count; ++k) {
    if (plugin.parameters[k]->id == id) return true;
  }
  return false;
}

PluginOptions::PluginOptions(CLI::App& app, const talweg_plugin& plugin) {
  repairs_ = has_parameter(plugin, "repair");
  for (std::uint32_t k = 0; k < plugin.parameter_count; ++k) {
    // The option --repair[=LIST] sets these parameters.
    if (repairs_ && std::string_view(plugin.parameters[k]->id).starts_with("repair")) continue;
    values_.push_back(std::make_unique<Value>());
    values_.back()->parameter = plugin.parameters[k];
    add(app, *values_.back());
  }
}

void PluginOptions::add(CLI::App& app, Value& value) {
  const talweg_parameter& p = *value.parameter;
  const std::string name = option_name(p.id), text = option_text(p);
  const bool optional = (p.flags & TALWEG_OPTIONAL) != 0;
  switch (p.type) {
    case TALWEG_NUMBER:
    case TALWEG_INTEGER:
      value.option = app.add_option(name, value.number, text);
      if (p.type == TALWEG_INTEGER) value.option->type_name("INT");
      if (!optional) value.option->default_str(fmt::format("{:g}", p.default_number));
      break;
    case TALWEG_BOOLEAN:
      value.option = app.add_flag(p.default_number != 0 ? name + ",!--no-" + name.substr(2) : name,
                                  value.flag, text);
      break;
    case TALWEG_CHOICE:
      value.option = add_choice(app, p, value.text);
      break;
    case TALWEG_VERTICES:
      value.option = app.add_option(name, value.vertices, text)->delimiter(',');
      break;
    case TALWEG_FIELD:
    case TALWEG_TRIANGLE_FIELD:
      value.option = app.add_option(name, value.text, text);
      break;
    case TALWEG_PER_CURVE:
      value.option = app.add_option(name, value.numbers, text)->delimiter(',');
      value.option->allow_extra_args(false);
      break;
    default:  // a parameter with a type of a newer interface keeps its default
      return;
  }
  if ((p.flags & TALWEG_ADVANCED) != 0) value.option->group("Advanced");
}

std::vector<std::pair<std::string, std::string>> PluginOptions::files() const {
  std::vector<std::pair<std::string, std::string>> files;
  for (const auto& value : values_) {
    const std::uint32_t type = value->parameter->type;
    if (type != TALWEG_FIELD && type != TALWEG_TRIANGLE_FIELD) continue;
    if (value->text.empty()) continue;
    files.emplace_back(option_name(value->parameter->id), value->text);
  }
  return files;
}

void set_repair(host::Instance& instance, const std::string& list) {
  if (list.empty()) return;
  const RepairSteps steps = repair_steps(list);
  instance.set("repair", 1.0);
  instance.set("repair_weld", steps.weld ? 1.0 : 0.0);
  instance.set("repair_drop", steps.drop ? 1.0 : 0.0);
  instance.set("repair_orient", steps.orient ? 1.0 : 0.0);
  instance.set("repair_split", steps.split ? 1.0 : 0.0);
  if (steps.weld_tolerance > 0) instance.set("repair_weld_tolerance", steps.weld_tolerance);
}

void PluginOptions::apply(host::Instance& instance) const {
  for (const auto& value : values_) {
    if (value->option == nullptr || value->option->count() == 0) continue;
    const char* id = value->parameter->id;
    switch (value->parameter->type) {
      case TALWEG_BOOLEAN:
        instance.set(id, value->flag ? 1.0 : 0.0);
        break;
      case TALWEG_CHOICE:
        instance.set(id, value->text);
        break;
      case TALWEG_VERTICES:
        instance.set(id, value->vertices);
        break;
      case TALWEG_FIELD:
      case TALWEG_TRIANGLE_FIELD:
        instance.set(id, read_field(value->text));
        break;
      case TALWEG_PER_CURVE:
        instance.set(id, value->numbers);
        break;
      default:
        instance.set(id, value->number);
    }
  }
}

}  // namespace talweg::driver
