/* host FOLDER...: runs every plugin of these folders as a host of the interface 1.0, with default
 * values, on a small mesh and a curve, and prints the results. Built with the header of 1.0 in this
 * folder, it must print the same as with the present header. */
#include <stdio.h>
#include <string.h>
#ifdef _WIN32
#include <windows.h>
#else
#include <dlfcn.h>
#endif

#include "talweg/plugin/talweg_plugin.h"

enum { SIDE = 8, VERTICES = SIDE * SIDE, TRIANGLES = 2 * (SIDE - 1) * (SIDE - 1) };

static double positions[VERTICES][3];
static uint32_t triangles[TRIANGLES][3];

static void make_hill(void) {
  uint32_t t = 0;
  for (uint32_t y = 0; y < SIDE; ++y) {
    for (uint32_t x = 0; x < SIDE; ++x) {
      double* p = positions[y * SIDE + x];
      p[0] = x;
      p[1] = y;
      p[2] = 0.02 * (x * (SIDE - 1.0 - x)) * (y * (SIDE - 1.0 - y)) / SIDE;
      if (x + 1 == SIDE || y + 1 == SIDE) continue;
      const uint32_t a = y * SIDE + x, b = a + 1, c = a + SIDE + 1, d = a + SIDE;
      const uint32_t two[2][3] = {{a, b, c}, {a, c, d}};
      memcpy(triangles[t], two, sizeof two);
      t += 2;
    }
  }
}

static talweg_array array_of(const void* data, uint64_t rows, uint32_t columns, uint32_t type) {
  const talweg_array array = {data, rows, 0, columns, type};
  return array;
}

static void print_numbers(const char* name, const talweg_array* array) {
  const uint64_t count = array->rows * array->columns;
  printf("    %s %llu", name, (unsigned long long)array->rows);
  for (uint64_t k = 0; k < count; ++k) {
    if (array->type == TALWEG_FLOAT64) {
      printf(" %.17g", ((const double*)array->data)[k]);
    } else {
      printf(" %u", ((const uint32_t*)array->data)[k]);
    }
  }
  printf("\n");
}

static void print_field(const talweg_field* field) {
  print_numbers(field->name, &field->values);
}

static talweg_status on_curve(void* context, const talweg_curve* curve) {
  (void)context;
  printf("  curve closed %u\n", curve->closed);
  print_numbers("faces", &curve->faces);
  print_numbers("barycentrics", &curve->barycentrics);
  for (uint32_t k = 0; k < curve->field_count; ++k) print_field(curve->fields[k]);
  return TALWEG_OK;
}

static talweg_status on_field(void* context, const talweg_field* field) {
  (void)context;
  printf("  field\n");
  print_field(field);
  return TALWEG_OK;
}

static talweg_status on_report(void* context, const talweg_report_entry* entry) {
  (void)context;
  printf("  report %lld %s %u %u\n", (long long)entry->curve, entry->key, entry->type, entry->count);
  return TALWEG_OK;
}

static talweg_status on_mesh(void* context, const talweg_mesh* mesh) {
  (void)context;
  printf("  mesh\n");
  print_numbers("positions", &mesh->positions);
  print_numbers("triangles", &mesh->triangles);
  return TALWEG_OK;
}

static void run(const talweg_plugin* plugin) {
  talweg_instance* instance = NULL;
  const talweg_host host = {sizeof host, TALWEG_INTERFACE_MAJOR, 0, "host 1.0", "1", NULL, NULL};
  const talweg_mesh mesh = {sizeof mesh, 0, array_of(positions, VERTICES, 3, TALWEG_FLOAT64),
                            array_of(triangles, TRIANGLES, 3, TALWEG_UINT32), NULL};
  const uint32_t ids[] = {3 * SIDE,     3 * SIDE + 1, 4 * SIDE + 2, 4 * SIDE + 3,
                          4 * SIDE + 4, 4 * SIDE + 5, 5 * SIDE + 6, 5 * SIDE + 7};
  talweg_curve curve;
  const talweg_curve* curves[1];
  const talweg_sink sink = {sizeof sink, TALWEG_WANT_POINT_FIELDS, NULL,
                            on_curve,    on_field,                 on_report,
                            on_mesh};
  talweg_status status;
  memset(&curve, 0, sizeof curve);
  curve.size = sizeof curve;
  curve.vertices = array_of(ids, sizeof ids / sizeof *ids, 1, TALWEG_UINT32);
  curves[0] = &curve;

  printf("%s, %u parameters, %u outputs\n", plugin->id, plugin->parameter_count,
         plugin->output_count);
  status = plugin->create(&host, &instance);
  if (status == TALWEG_OK) status = plugin->set_mesh(instance, &mesh);
  if (status == TALWEG_OK && (plugin->flags & TALWEG_TAKES_CURVES) != 0) {
    status = plugin->set_curves(instance, curves, 1);
  }
  if (status == TALWEG_OK) status = plugin->run(instance, &sink);
  printf("  status %u %s\n", status, instance == NULL ? "" : plugin->last_error(instance));
  plugin->destroy(instance);
}

/* The function that a module exports, NULL where there is none. */
static talweg_plugin_entry_function entry_of(const char* path) {
  talweg_plugin_entry_function entry = NULL;
#ifdef _WIN32
  HMODULE library = LoadLibraryExA(path, NULL, LOAD_WITH_ALTERED_SEARCH_PATH);
  if (library == NULL) return fprintf(stderr, "%s: error %lu\n", path, GetLastError()), entry;
  *(FARPROC*)&entry = GetProcAddress(library, TALWEG_PLUGIN_ENTRY);
#else
  void* library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  if (library == NULL) return fprintf(stderr, "%s\n", dlerror()), entry;
  *(void**)&entry = dlsym(library, TALWEG_PLUGIN_ENTRY);
#endif
  return entry;
}

static int load(const char* path) {
  const talweg_plugin_entry_function entry = entry_of(path);
  const talweg_module* module;
  module = entry == NULL ? NULL : entry(TALWEG_INTERFACE_MAJOR, 0);
  if (module == NULL || module->size < sizeof *module || module->needs_minor > 0) {
    return fprintf(stderr, "%s: not for a host of 1.0\n", path), 1;
  }
  for (uint64_t k = 0; k < module->plugin_count; ++k) run(module->plugins[k]);
  return 0;
}

int main(int argc, char** argv) {
  make_hill();
  for (int k = 1; k < argc; ++k) {
    if (load(argv[k]) != 0) return 1;
  }
  return argc > 1 ? 0 : 1;
}
