/*
 * Finds and loads plugins of talweg_plugin.h; for hosts in C and whatever can call C.
 *
 * Looked through, in this order and not below:
 *   1. the folders of the environment variable TALWEG_PLUGIN_PATH, separated by ':' (not in programs
 *      that run with another user's rights);
 *   2. where plugins lie as seen from the program: ../lib/talweg/plugins, and plugins beside it;
 *   3. the folder that plugins were installed in when the loader was built.
 * Of plugins with the same id the first one counts. Files that end in .so are looked at, in the
 * order of their names. Libraries are loaded with RTLD_NOW | RTLD_LOCAL.
 * On Windows ';' separates folders, files end in .dll, libraries that a plugin needs may lie beside it,
 * and there is no third place.
 *
 * A file that cannot be used is refused with a reason, and the search goes on.
 */
#ifndef TALWEG_LOADER_H
#define TALWEG_LOADER_H

#include <stdint.h>

#include "talweg/plugin/talweg_plugin.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct talweg_loader talweg_loader;

/* [any thread] Loads every plugin there is. `folders` are looked through instead of those above,
 * separated by ':'; null: those above. Null when memory runs out, and only then. */
talweg_loader *talweg_loader_open(const char *folders);

/* A module that is linked into the program. Each was compiled with a name of its own for the entry
 * (-Dtalweg_plugin_entry=talweg_plugin_entry_mine), since one program has room for one. */
typedef struct talweg_linked_module {
  const char *name; /* takes the place of the file in talweg_loader_path() and reasons */
  talweg_plugin_entry_function entry;
} talweg_linked_module;

/* [any thread] The same for programs without plugins in files, or with some beside them: modules come
 * first, in their order, then `folders`; null: no folder is looked through. */
talweg_loader *talweg_loader_open_linked(const talweg_linked_module *modules, uint64_t count,
                                         const char *folders);

/* Unloads all plugins of the loader; null is allowed. No instance of them may be left, and no pointer
 * that came from them may be used any more. */
void talweg_loader_close(talweg_loader *loader);

/* [any thread] The functions below only look at what talweg_loader_open has found; what they return
 * is there until talweg_loader_close. Null where there is no such plugin or file. */

uint64_t talweg_loader_count(const talweg_loader *loader);
const talweg_plugin *talweg_loader_plugin(const talweg_loader *loader, uint64_t index);
const talweg_plugin *talweg_loader_find(const talweg_loader *loader, const char *id);
/* The file that the plugin was loaded from. */
const char *talweg_loader_path(const talweg_loader *loader, uint64_t index);

/* Files that were refused, and one sentence each that says why. */
uint64_t talweg_loader_refused_count(const talweg_loader *loader);
const char *talweg_loader_refused_path(const talweg_loader *loader, uint64_t index);
const char *talweg_loader_refused_reason(const talweg_loader *loader, uint64_t index);

/* The folders that were looked through, separated by ':'. */
const char *talweg_loader_folders(const talweg_loader *loader);

#ifdef __cplusplus
}
#endif

#endif /* TALWEG_LOADER_H */
