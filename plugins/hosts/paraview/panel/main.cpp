// talweg-paraview-panel PLUGIN-FOLDER FILE.xml [own-widgets]: writes ParaView's property panels,
// with Talweg's own widgets if the plugin is built with them.
#include <cstdio>
#include <exception>
#include <fstream>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>

#include "server_manager_xml.hpp"
#include "talweg/loader/talweg_loader.h"

namespace {

void write(const std::string& path, const std::string& text) {
  std::ofstream file(path);
  file << text;
  file.close();
  if (!file) throw std::runtime_error(path + " cannot be written.");
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 3 && argc != 4) {
      throw std::runtime_error("usage: talweg-paraview-panel PLUGIN-FOLDER FILE.xml [own-widgets]");
    }
    const std::unique_ptr<talweg_loader, void (*)(talweg_loader*)> loader(
        talweg_loader_open(argv[1]), talweg_loader_close);
    if (!loader) throw std::bad_alloc();
    const auto plugin_named = [&](const char* id) -> const talweg_plugin& {
      const talweg_plugin* plugin = talweg_loader_find(loader.get(), id);
      if (plugin != nullptr) return *plugin;
      throw std::runtime_error(std::string("There is no plugin ") + id + " in " + argv[1] + ".");
    };
    write(argv[2], talweg::paraview::server_manager_xml(plugin_named, argc == 4));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "talweg-paraview-panel: %s\n", error.what());
    return 1;
  }
}
