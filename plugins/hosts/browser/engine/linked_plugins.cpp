#include "linked_plugins.hpp"

extern "C" {
const talweg_module* talweg_plugin_entry_smooth(std::uint32_t, std::uint32_t);
const talweg_module* talweg_plugin_entry_draw(std::uint32_t, std::uint32_t);
const talweg_module* talweg_plugin_entry_cut(std::uint32_t, std::uint32_t);
const talweg_module* talweg_plugin_entry_offset(std::uint32_t, std::uint32_t);
const talweg_module* talweg_plugin_entry_repair(std::uint32_t, std::uint32_t);
}

namespace talweg::browser {

const editing::Plugins& linked_plugins() {
  static constexpr talweg_linked_module kModules[] = {{"smooth", talweg_plugin_entry_smooth},
                                                      {"draw", talweg_plugin_entry_draw},
                                                      {"cut", talweg_plugin_entry_cut},
                                                      {"offset", talweg_plugin_entry_offset},
                                                      {"repair", talweg_plugin_entry_repair}};
  static const editing::Plugins plugins(kModules);
  return plugins;
}

}  // namespace talweg::browser
