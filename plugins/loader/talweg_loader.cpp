#include "talweg_loader.h"

#include <algorithm>
#include <cstring>
#include <exception>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "module_check.hpp"
#include "search_path.hpp"
#include "shared_library.hpp"
#include "system.hpp"

/// The result of a search.
struct talweg_loader {
  struct Plugin {
    const talweg_plugin* plugin;
    std::string path;
  };
  struct Refused {
    std::string path, reason;
  };

  void look_through(const std::string& folder);
  void look_at(const std::string& path);
  bool take(talweg_plugin_entry_function entry, const std::string& path);

  std::string folders;
  std::vector<talweg::loader::SharedLibrary> libraries;
  std::vector<Plugin> plugins;
  std::vector<Refused> refused;
};

void talweg_loader::look_through(const std::string& folder) {
  std::vector<std::string> paths;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (entry->path().extension() == talweg::loader::kPluginEnding)
      paths.push_back(entry->path().string());
  }
  std::sort(paths.begin(), paths.end());
  for (const std::string& path : paths) {
    try {
      look_at(path);
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& why) {
      refused.push_back({path, why.what()});
    }
  }
}

void talweg_loader::look_at(const std::string& path) {
  talweg::loader::SharedLibrary library(path);
  void* symbol = library.symbol(TALWEG_PLUGIN_ENTRY);
  if (symbol == nullptr) {
    refused.push_back({path, "It is not a plugin: it has no symbol " TALWEG_PLUGIN_ENTRY "."});
    return;
  }
  talweg_plugin_entry_function entry = nullptr;
  std::memcpy(&entry, &symbol, sizeof entry);  // POSIX returns a data pointer
  if (take(entry, path)) libraries.push_back(std::move(library));
}

/// Whether the loader uses a plugin of the module.
bool talweg_loader::take(talweg_plugin_entry_function entry, const std::string& path) {
  const talweg_module* module = entry(TALWEG_INTERFACE_MAJOR, TALWEG_INTERFACE_MINOR);
  const std::string why =
      talweg::loader::objection(module, TALWEG_INTERFACE_MAJOR, TALWEG_INTERFACE_MINOR);
  if (!why.empty()) {
    refused.push_back({path, why});
    return false;
  }
  bool used = false;
  for (std::uint64_t k = 0; k < module->plugin_count; ++k) {
    const talweg_plugin* plugin = module->plugins[k];
    const auto known = std::find_if(plugins.begin(), plugins.end(), [&](const Plugin& other) {
      return std::strcmp(other.plugin->id, plugin->id) == 0;
    });
    if (known != plugins.end()) {
      refused.push_back({path, std::string("Its plugin ") + plugin->id +
                                   " has been found already, in " + known->path + "."});
      continue;
    }
    plugins.push_back({plugin, path});
    used = true;
  }
  return used;
}

namespace {

/// `folders` is a function that returns the list, since making the list may run out of memory, too.
template <class Folders>
talweg_loader* opened(const talweg_linked_module* modules, std::uint64_t count, Folders folders) {
  try {
    auto loader = std::make_unique<talweg_loader>();
    for (std::uint64_t k = 0; k < count; ++k) loader->take(modules[k].entry, modules[k].name);
    for (const std::string& folder : folders()) {
      if (!loader->folders.empty()) loader->folders += talweg::loader::kBetweenFolders;
      loader->folders += folder;
      loader->look_through(folder);
    }
    return loader.release();
  } catch (...) {
    return nullptr;
  }
}

}  // namespace

talweg_loader* talweg_loader_open(const char* folders) {
  return opened(nullptr, 0, [&] {
    return folders == nullptr ? talweg::loader::standard_folders() : talweg::loader::split(folders);
  });
}

talweg_loader* talweg_loader_open_linked(const talweg_linked_module* modules, uint64_t count,
                                         const char* folders) {
  return opened(modules, count,
                [&] { return talweg::loader::split(folders == nullptr ? "" : folders); });
}

void talweg_loader_close(talweg_loader* loader) { delete loader; }

uint64_t talweg_loader_count(const talweg_loader* loader) {
  return loader == nullptr ? 0 : loader->plugins.size();
}

const talweg_plugin* talweg_loader_plugin(const talweg_loader* loader, uint64_t index) {
  return index < talweg_loader_count(loader) ? loader->plugins[index].plugin : nullptr;
}

const talweg_plugin* talweg_loader_find(const talweg_loader* loader, const char* id) {
  for (uint64_t k = 0; id != nullptr && k < talweg_loader_count(loader); ++k) {
    if (std::strcmp(loader->plugins[k].plugin->id, id) == 0) return loader->plugins[k].plugin;
  }
  return nullptr;
}

const char* talweg_loader_path(const talweg_loader* loader, uint64_t index) {
  return index < talweg_loader_count(loader) ? loader->plugins[index].path.c_str() : nullptr;
}

uint64_t talweg_loader_refused_count(const talweg_loader* loader) {
  return loader == nullptr ? 0 : loader->refused.size();
}

const char* talweg_loader_refused_path(const talweg_loader* loader, uint64_t index) {
  return index < talweg_loader_refused_count(loader) ? loader->refused[index].path.c_str()
                                                     : nullptr;
}

const char* talweg_loader_refused_reason(const talweg_loader* loader, uint64_t index) {
  return index < talweg_loader_refused_count(loader) ? loader->refused[index].reason.c_str()
                                                     : nullptr;
}

const char* talweg_loader_folders(const talweg_loader* loader) {
  return loader == nullptr ? nullptr : loader->folders.c_str();
}
