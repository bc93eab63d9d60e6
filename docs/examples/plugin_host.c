/*
 * A host in pure C: smooths a drawn curve for one tau or several, through the plugin interface
 * only.
 *
 *   plugin_host MESH.obj CURVE.txt RESULT.json TAU...
 *
 * MESH.obj: triangles ("v x y z", "f a b c"). CURVE.txt: vertex numbers from 0. RESULT.json: the
 * curve for the last tau, as talweg writes it.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <talweg/loader/talweg_loader.h>
#include <talweg/plugin/talweg_plugin.h>

static void fail(const char* what, const char* why) {
  fprintf(stderr, "plugin_host: %s: %s\n", what, why);
  exit(1);
}

/* ---- Files ------------------------------------------------------------------------------------
 */

struct numbers {
  void* data;
  size_t count, room;
};

static void* append(struct numbers* list, size_t bytes, size_t more) {
  if (list->count + more > list->room) {
    list->room = 2 * list->room + more;
    list->data = realloc(list->data, list->room * bytes);
    if (list->data == NULL) fail("memory", "there is not enough");
  }
  list->count += more;
  return (char*)list->data + (list->count - more) * bytes;
}

static FILE* open_file(const char* path, const char* mode) {
  FILE* file = fopen(path, mode);
  if (file == NULL) fail(path, "cannot be opened");
  return file;
}

static void read_mesh(const char* path, struct numbers* xyz, struct numbers* triangles) {
  FILE* file = open_file(path, "r");
  char line[256];
  while (fgets(line, sizeof line, file) != NULL) {
    double x[3];
    unsigned v[3];
    if (sscanf(line, "v %lf %lf %lf", &x[0], &x[1], &x[2]) == 3) {
      memcpy(append(xyz, sizeof(double), 3), x, sizeof x);
    } else if (sscanf(line, "f %u%*[/0-9] %u%*[/0-9] %u", &v[0], &v[1], &v[2]) == 3 ||
               sscanf(line, "f %u %u %u", &v[0], &v[1], &v[2]) == 3) {
      uint32_t* t = append(triangles, sizeof(uint32_t), 3);
      for (int k = 0; k < 3; ++k) t[k] = v[k] - 1;
    }
  }
  fclose(file);
}

static void read_curve(const char* path, struct numbers* vertices) {
  FILE* file = open_file(path, "r");
  unsigned v;
  while (fscanf(file, "%u", &v) == 1) *(uint32_t*)append(vertices, sizeof(uint32_t), 1) = v;
  fclose(file);
}

/* ---- What the host gives and takes ------------------------------------------------------------
 */

static uint32_t on_progress(const talweg_host* host, const char* stage, double fraction) {
  (void)host, (void)stage, (void)fraction;
  return 1; /* 0 would cancel */
}

static const void* get_extension(const talweg_host* host, const char* id) {
  static const talweg_host_progress progress = {sizeof progress, on_progress};
  (void)host;
  return strcmp(id, TALWEG_HOST_PROGRESS) == 0 ? &progress : NULL;
}

/* Writes the curve to the file that `context` is. */
static talweg_status on_curve(void* context, const talweg_curve* curve) {
  FILE* file = context;
  const uint32_t* face = curve->faces.data;
  const double *b = curve->barycentrics.data, *p = curve->positions.data;
  rewind(file);
  fprintf(file, "{\"format\": \"talweg-curves\", \"version\": 1, \"curves\": [");
  fprintf(file, "\n{\"closed\": %s, \"points\": [", curve->closed ? "true" : "false");
  for (uint64_t k = 0; k < curve->faces.rows; ++k, b += 3, p += 3) {
    fprintf(file, "%s\n  {\"face\": %u, \"barycentric\": [%.17g, %.17g, %.17g], ", k ? "," : "",
            face[k], b[0], b[1], b[2]);
    fprintf(file, "\"xyz\": [%.17g, %.17g, %.17g]}", p[0], p[1], p[2]);
  }
  fprintf(file, "\n]}\n]}\n");
  return ferror(file) ? TALWEG_BAD_FILE : TALWEG_OK;
}

static talweg_status on_report(void* context, const talweg_report_entry* entry) {
  (void)context;
  if (entry->curve >= 0) return TALWEG_OK; /* only the totals */
  if (strcmp(entry->key, "termination") == 0) printf("%s: %s\n", entry->key, entry->texts[0]);
  if (strcmp(entry->key, "curvature_after") == 0 || strcmp(entry->key, "length_after") == 0) {
    printf("%s: %g\n", entry->key, entry->numbers[0]);
  }
  return TALWEG_OK;
}

/* ---- The way through the interface ------------------------------------------------------------
 */

static const talweg_plugin* plugin;
static talweg_instance* instance;

static void check(const char* what, talweg_status status) {
  if (status != TALWEG_OK) fail(what, plugin->last_error(instance));
}

int main(int argc, char** argv) {
  struct numbers xyz = {0}, triangles = {0}, vertices = {0};
  talweg_host host = {
      sizeof host, TALWEG_INTERFACE_MAJOR, TALWEG_INTERFACE_MINOR, "plugin_host", "1.0",
      NULL,        get_extension};
  if (argc < 5) fail("usage", "plugin_host MESH.obj CURVE.txt RESULT.json TAU...");
  read_mesh(argv[1], &xyz, &triangles);
  read_curve(argv[2], &vertices);

  /* Find the plugin and make a workspace. */
  talweg_loader* loader = talweg_loader_open(NULL);
  plugin = talweg_loader_find(loader, "talweg.smooth");
  if (plugin == NULL) fail("there is no talweg.smooth in", talweg_loader_folders(loader));
  if (plugin->create(&host, &instance) != TALWEG_OK) fail(plugin->id, "no instance");

  /* Once per mesh. */
  talweg_mesh mesh = {0};
  mesh.size = sizeof mesh;
  mesh.positions = (talweg_array){xyz.data, xyz.count / 3, 0, 3, TALWEG_FLOAT64};
  mesh.triangles = (talweg_array){triangles.data, triangles.count / 3, 0, 3, TALWEG_UINT32};
  check(argv[1], plugin->set_mesh(instance, &mesh));

  /* Once per drawing. */
  talweg_curve curve = {0};
  curve.size = sizeof curve;
  curve.vertices = (talweg_array){vertices.data, vertices.count, 0, 1, TALWEG_UINT32};
  const talweg_curve* curves[] = {&curve};
  check(argv[2], plugin->set_curves(instance, curves, 1));

  /* Once per move of the slider. */
  FILE* result = open_file(argv[3], "w");
  talweg_sink sink = {0};
  sink.size = sizeof sink;
  sink.context = result;
  sink.report = on_report;
  for (int k = 4; k < argc; ++k) {
    printf("tau: %s\n", argv[k]);
    check(argv[k], plugin->set_number(instance, "tau", atof(argv[k])));
    sink.curve = k + 1 == argc ? on_curve : NULL; /* what is not wanted is not made */
    check(argv[k], plugin->run(instance, &sink));
  }
  if (fclose(result) != 0) fail(argv[3], "cannot be written");

  plugin->destroy(instance);
  talweg_loader_close(loader);
  free(xyz.data);
  free(triangles.data);
  free(vertices.data);
  return 0;
}
