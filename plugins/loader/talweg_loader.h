/*
 * Finds and loads plugins of talweg_plugin.h; for hosts in C and in languages that can call C.
 *
 * Searched folders, in this order, without their subfolders:
 *   1. the folders of the environment variable TALWEG_PLUGIN_PATH, separated by ':' (not in programs
 *      that run with another user's rights);
 *   2. two folders relative to the program's: ../lib/talweg/plugins and plugins;
 *   3. the folder for installed plugins, fixed when the loader was built.
 * Of plugins with the same id the first is used. Files that end in .so are loaded in the order of
 * their names. Libraries are loaded with RTLD_NOW | RTLD_LOCAL.
 * On Windows ';' separates folders, files end in .dll, a plugin's libraries may lie beside the plugin,
 * and there is no third folder.
 *
 * An unusable file is refused with a reason, and the search continues.
 */
#ifndef TALWEG_LOADER_H
#define TALWEG_LOADER_H

#include <stdint.h>

#include "talweg/plugin/talweg_plugin.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct talweg_loader talweg_loader;

/* [any thread] Loads all plugins. `folders`, separated by ':', are searched instead of the standard
 * folders; null: the standard folders. Returns null only if memory runs out. */
talweg_loader *talweg_loader_open(const char *folders);

/* A module that is linked into the program. Each module is compiled with another name for its
 * entry (-Dtalweg_plugin_entry=talweg_plugin_entry_mine), since a name can occur only once in a
 * program. */
typedef struct talweg_linked_module {
  const char *name; /* stands for the file in talweg_loader_path() and reasons */
  talweg_plugin_entry_function entry;
} talweg_linked_module;

/* [any thread] Loads linked modules, in their order, and then the plugins of `folders`; null: no
 * folder is searched. Otherwise as talweg_loader_open. */
talweg_loader *talweg_loader_open_linked(const talweg_linked_module *modules, uint64_t count,
                                         const char *folders);

/* Unloads all plugins of the loader; null is allowed. All their instances must have been destroyed,
 * and no pointer from them may be used afterwards. */
void talweg_loader_close(talweg_loader *loader);

/* [any thread] The functions below read the result of talweg_loader_open; their results are valid
 * until talweg_loader_close. They return null if there is no such plugin or file. */

uint64_t talweg_loader_count(const talweg_loader *loader);
const talweg_plugin *talweg_loader_plugin(const talweg_loader *loader, uint64_t index);
const talweg_plugin *talweg_loader_find(const talweg_loader *loader, const char *id);
/* The file that the plugin was loaded from. */
const char *talweg_loader_path(const talweg_loader *loader, uint64_t index);

/* Files that were refused, each with a sentence on why. */
uint64_t talweg_loader_refused_count(const talweg_loader *loader);
const char *talweg_loader_refused_path(const talweg_loader *loader, uint64_t index);
const char *talweg_loader_refused_reason(const talweg_loader *loader, uint64_t index);

/* The folders that were searched, separated by ':'. */
const char *talweg_loader_folders(const talweg_loader *loader);

#ifdef __cplusplus
}
#endif

#endif /* TALWEG_LOADER_H */
