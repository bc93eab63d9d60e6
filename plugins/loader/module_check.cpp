#include "module_check.hpp"

#include <cctype>
#include <cmath>
#include <set>

namespace talweg::loader {
namespace {

std::string version_text(std::uint32_t major, std::uint32_t minor) {
  return std::to_string(major) + "." + std::to_string(minor);
}

bool empty(const char* text) { return text == nullptr || *text == '\0'; }

/// Whether the text has only letters that are safe in command lines, file names and scripts.
bool is_id(const char* text, const char* more) {
  if (empty(text)) return false;
  for (const char* c = text; *c != '\0'; ++c) {
    const bool letter = (*c >= 'a' && *c <= 'z') || (*c >= '0' && *c <= '9');
    if (!letter && std::string(more).find(*c) == std::string::npos) return false;
  }
  return true;
}

bool holds_number(std::uint32_t type) {
  return type == TALWEG_NUMBER || type == TALWEG_INTEGER || type == TALWEG_BOOLEAN;
}

std::string objection_to_choice(const talweg_parameter& p) {
  if (p.choice_count == 0 || p.choices == nullptr || p.choice_labels == nullptr) {
    return "has no choices";
  }
  bool has_default = false;
  for (std::uint32_t k = 0; k < p.choice_count; ++k) {
    if (empty(p.choices[k]) || p.choice_labels[k] == nullptr) return "has an empty choice";
    has_default = has_default || std::string(p.choices[k]) == std::string(p.default_choice);
  }
  return has_default ? "" : "has a default that is none of its choices";
}

std::string objection_to(const talweg_parameter& p) {
  if (p.type < TALWEG_NUMBER) return "is of no known type";
  if (p.stage < TALWEG_STAGE_MESH || p.stage > TALWEG_STAGE_RUN) return "is of no known stage";
  if (p.label == nullptr || p.unit == nullptr || p.doc == nullptr) return "is not described";
  if (p.type == TALWEG_CHOICE) {
    return p.default_choice == nullptr ? "has no default" : objection_to_choice(p);
  }
  if (!holds_number(p.type)) return "";
  if (!(p.minimum <= p.maximum)) return "has an empty range";
  const bool optional = (p.flags & TALWEG_OPTIONAL) != 0;
  if (!optional && !(p.default_number >= p.minimum && p.default_number <= p.maximum)) {
    return "has a default out of its range";
  }
  if (!std::isfinite(p.soft_minimum) || !std::isfinite(p.soft_maximum)) {
    return "has an infinite range for sliders";
  }
  return "";
}

std::string objection_to_parameters(const talweg_plugin& plugin) {
  if (plugin.parameter_count > 0 && plugin.parameters == nullptr) return "has no parameter list";
  std::set<std::string> ids;
  for (std::uint32_t k = 0; k < plugin.parameter_count; ++k) {
    const talweg_parameter* p = plugin.parameters[k];
    if (p == nullptr || p->size < sizeof *p) return "has a parameter that is too small";
    if (!is_id(p->id, "_")) return "has a parameter without a proper id";
    if (!ids.insert(p->id).second) return std::string("has two parameters ") + p->id;
    const std::string why = objection_to(*p);
    if (!why.empty()) return std::string("has a parameter ") + p->id + " that " + why;
  }
  return "";
}

std::string objection_to_outputs(const talweg_plugin& plugin) {
  if (plugin.output_count > 0 && plugin.outputs == nullptr) return "has no output list";
  for (std::uint32_t k = 0; k < plugin.output_count; ++k) {
    const talweg_output* o = plugin.outputs[k];
    if (o == nullptr || o->size < sizeof *o) return "has an output that is too small";
    if (empty(o->name) || o->label == nullptr || o->unit == nullptr || o->doc == nullptr) {
      return "has an output that is not described";
    }
  }
  return "";
}

std::string objection_to(const talweg_plugin& plugin) {
  if (plugin.label == nullptr || plugin.version == nullptr || plugin.doc == nullptr) {
    return "is not described";
  }
  const bool whole = plugin.create != nullptr && plugin.destroy != nullptr &&
                     plugin.set_mesh != nullptr && plugin.share_mesh != nullptr &&
                     plugin.set_curves != nullptr && plugin.set_number != nullptr &&
                     plugin.set_choice != nullptr && plugin.set_array != nullptr &&
                     plugin.reset != nullptr && plugin.run != nullptr && plugin.cancel != nullptr &&
                     plugin.last_error != nullptr && plugin.get_extension != nullptr;
  if (!whole) return "lacks a function";
  const std::string why = objection_to_parameters(plugin);
  return why.empty() ? objection_to_outputs(plugin) : why;
}

std::string objection_to_version(const talweg_module& module, std::uint32_t host_major,
                                 std::uint32_t host_minor) {
  if (module.interface_major != host_major) {
    return "It is made for the plugin interface " +
           version_text(module.interface_major, module.interface_minor) + ", but this host has " +
           version_text(host_major, host_minor) + ".";
  }
  if (module.needs_minor > host_minor) {
    return "It needs the plugin interface " + version_text(host_major, module.needs_minor) +
           ", but this host has " + version_text(host_major, host_minor) + ".";
  }
  return "";
}

}  // namespace

std::string objection(const talweg_module* module, std::uint32_t host_major,
                      std::uint32_t host_minor) {
  if (module == nullptr) {
    return "It does not work with hosts of the plugin interface " +
           version_text(host_major, host_minor) + ".";
  }
  // The versions come first in every version of the struct.
  if (module->size < 3 * sizeof(std::uint32_t)) return "Its module is too small.";
  const std::string why = objection_to_version(*module, host_major, host_minor);
  if (!why.empty()) return why;
  if (module->size < sizeof *module) return "Its module is too small.";
  if (module->plugin_count == 0 || module->plugins == nullptr) return "It has no plugins.";
  std::set<std::string> ids;
  for (std::uint64_t k = 0; k < module->plugin_count; ++k) {
    const talweg_plugin* plugin = module->plugins[k];
    if (plugin == nullptr || plugin->size < sizeof *plugin) {
      return "It has a plugin that is too small.";
    }
    if (!is_id(plugin->id, "_.-")) return "It has a plugin without a proper id.";
    const std::string name = std::string("Its plugin ") + plugin->id + " ";
    if (!ids.insert(plugin->id).second) return name + "is listed twice.";
    const std::string what = objection_to(*plugin);
    if (!what.empty()) return name + what + ".";
  }
  return "";
}

}  // namespace talweg::loader
