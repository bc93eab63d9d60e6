#include "linked_plugins.hpp"

#include "methods/plugins.hpp"
#include "talweg/plugin/talweg_plugin.hpp"

namespace talweg::plugins {

TALWEG_PLUGIN_MODULE(smooth_plugin, draw_plugin, cut_plugin, offset_plugin, repair_plugin)

}  // namespace talweg::plugins

namespace talweg::browser {

const editing::Plugins& linked_plugins() {
  static constexpr talweg_linked_module kModules[] = {{"talweg", talweg_plugin_entry}};
  static const editing::Plugins plugins(kModules);
  return plugins;
}

}  // namespace talweg::browser
