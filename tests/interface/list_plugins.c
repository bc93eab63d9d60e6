/* Makes an instance of every plugin and lists the plugins; refused files go to stderr. */
#include <stdio.h>

#include "talweg/loader/talweg_loader.h"

int main(void) {
  talweg_loader* loader = talweg_loader_open(NULL);
  uint64_t k;
  for (k = 0; k < talweg_loader_count(loader); ++k) {
    const talweg_plugin* plugin = talweg_loader_plugin(loader, k);
    talweg_instance* instance = NULL;
    if (plugin->create(NULL, &instance) != TALWEG_OK) return 1;
    plugin->destroy(instance);
    printf("%s\n", plugin->id);
  }
  for (k = 0; k < talweg_loader_refused_count(loader); ++k) {
    fprintf(stderr, "%s: %s\n", talweg_loader_refused_path(loader, k),
            talweg_loader_refused_reason(loader, k));
  }
  talweg_loader_close(loader);
  return 0;
}
