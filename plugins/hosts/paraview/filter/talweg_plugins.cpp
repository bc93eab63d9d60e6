#include "talweg_plugins.hpp"

#include <cstdlib>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include <dlfcn.h>

#include "talweg/loader/talweg_loader.h"

namespace talweg::paraview {
namespace {

const talweg_loader* open(const char* folders) {
  const talweg_loader* loader = talweg_loader_open(folders);
  if (loader == nullptr) throw std::bad_alloc();
  return loader;
}

/// lib/talweg/plugins for lib/paraview-5.11/plugins/Talweg/Talweg.so.
std::string folder_beside_this_library() {
  Dl_info info = {};
  if (dladdr(reinterpret_cast<const void*>(&folder_beside_this_library), &info) == 0) return "";
  std::error_code error;
  const auto library = std::filesystem::weakly_canonical(info.dli_fname, error);
  return (library.parent_path() / "../../../talweg/plugins").lexically_normal().string();
}

/// The loaders are never closed: filters may live until the program ends.
std::vector<const talweg_loader*> open_all() {
  std::vector<const talweg_loader*> loaders;
  if (std::getenv("TALWEG_PLUGIN_PATH") == nullptr) {
    loaders.push_back(open(folder_beside_this_library().c_str()));
  }
  loaders.push_back(open(nullptr));
  return loaders;
}

}  // namespace

const talweg_plugin& plugin_named(const char* id) {
  static const std::vector<const talweg_loader*> loaders = open_all();
  std::string looked;
  std::string refused;
  for (const talweg_loader* loader : loaders) {
    const talweg_plugin* plugin = talweg_loader_find(loader, id);
    if (plugin != nullptr) return *plugin;
    if (!looked.empty()) looked += ':';
    looked += talweg_loader_folders(loader);
    for (std::uint64_t k = 0; k < talweg_loader_refused_count(loader); ++k) {
      refused += std::string(" ") + talweg_loader_refused_path(loader, k) + ": " +
                 talweg_loader_refused_reason(loader, k);
    }
  }
  throw std::runtime_error(std::string("There is no plugin ") + id + " in " + looked +
                           " (TALWEG_PLUGIN_PATH names other folders)." + refused);
}

}  // namespace talweg::paraview
