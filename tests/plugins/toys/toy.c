/*
 * A plugin in pure C that counts vertices. It is built several times, with other versions of the
 * interface and with faults that a loader must detect.
 */
#include <stdlib.h>

#include "talweg/plugin/talweg_plugin.h"

#ifndef TOY_ID
#define TOY_ID "toy.count"
#endif
#ifndef TOY_MAJOR
#define TOY_MAJOR TALWEG_INTERFACE_MAJOR
#endif
#ifndef TOY_MINOR
#define TOY_MINOR TALWEG_INTERFACE_MINOR
#endif
#ifndef TOY_NEEDS
#define TOY_NEEDS 0
#endif
#ifndef TOY_DEFAULT
#define TOY_DEFAULT 1
#endif

struct talweg_instance {
  const talweg_host* host;
  double vertices;
};

static talweg_status toy_create(const talweg_host* host, talweg_instance** instance) {
  *instance = calloc(1, sizeof **instance);
  if (*instance == NULL) return TALWEG_OUT_OF_MEMORY;
  (*instance)->host = host;
  return TALWEG_OK;
}
static void toy_destroy(talweg_instance* instance) { free(instance); }
static talweg_status toy_set_mesh(talweg_instance* instance, const talweg_mesh* mesh) {
  instance->vertices = (double)mesh->positions.rows;
  return TALWEG_OK;
}
static talweg_status toy_share(talweg_instance* instance, const talweg_instance* other) {
  instance->vertices = other->vertices;
  return TALWEG_OK;
}
static talweg_status toy_set_curves(talweg_instance* instance, const talweg_curve* const* curves,
                                    uint64_t count) {
  (void)instance, (void)curves, (void)count;
  return TALWEG_UNSUPPORTED;
}
static talweg_status toy_set_number(talweg_instance* instance, const char* id, double value) {
  (void)instance, (void)id, (void)value;
  return TALWEG_OK;
}
static talweg_status toy_set_choice(talweg_instance* instance, const char* id, const char* value) {
  (void)instance, (void)id, (void)value;
  return TALWEG_BAD_USAGE;
}
static talweg_status toy_set_array(talweg_instance* instance, const char* id,
                                   const talweg_array* values) {
  (void)instance, (void)id, (void)values;
  return TALWEG_BAD_USAGE;
}
static talweg_status toy_reset(talweg_instance* instance, const char* id) {
  (void)instance, (void)id;
  return TALWEG_OK;
}
static talweg_status toy_run(talweg_instance* instance, const talweg_sink* sink) {
  double minor = -1;
  talweg_report_entry entry = {0};
  entry.size = sizeof entry;
  entry.type = TALWEG_VALUE_INTEGER;
  entry.curve = -1;
  entry.key = "vertices";
  entry.count = 1;
  entry.numbers = &instance->vertices;
  if (sink->report == NULL) return TALWEG_OK;
  if (sink->report(sink->context, &entry) != TALWEG_OK) return TALWEG_HOST_FAILED;
  if (instance->host != NULL && instance->host->interface_minor >= 7) {
    /* An extension of newer hosts is asked for, but not needed. */
    minor = instance->host->get_extension(instance->host, "talweg.of-tomorrow/1") != NULL;
  }
  entry.key = "of_tomorrow";
  entry.type = TALWEG_VALUE_NUMBER;
  entry.numbers = &minor;
  return sink->report(sink->context, &entry) == TALWEG_OK ? TALWEG_OK : TALWEG_HOST_FAILED;
}
static void toy_cancel(talweg_instance* instance) { (void)instance; }
static const char* toy_last_error(const talweg_instance* instance) {
  (void)instance;
  return "";
}
static const void* toy_extension(const char* id) {
  (void)id;
  return NULL;
}

static const talweg_parameter toy_parameter = {.size = sizeof(talweg_parameter),
                                               .type = TALWEG_NUMBER,
                                               .stage = TALWEG_STAGE_RUN,
                                               .id = "weight",
                                               .label = "Weight",
                                               .unit = "",
                                               .doc = "Of nothing.",
                                               .default_number = TOY_DEFAULT,
                                               .minimum = 0,
                                               .maximum = 2,
                                               .soft_maximum = 2};
static const talweg_parameter* const toy_parameters[] = {&toy_parameter};

static const talweg_plugin toy_plugin = {.size = sizeof(talweg_plugin),
                                         .id = TOY_ID,
                                         .label = "Count vertices",
                                         .version = "1",
                                         .doc = "Counts the vertices of a mesh.",
                                         .parameter_count = 1,
                                         .parameters = toy_parameters,
                                         .create = toy_create,
                                         .destroy = toy_destroy,
                                         .set_mesh = toy_set_mesh,
                                         .share_mesh = toy_share,
                                         .set_curves = toy_set_curves,
                                         .set_number = toy_set_number,
                                         .set_choice = toy_set_choice,
                                         .set_array = toy_set_array,
                                         .reset = toy_reset,
                                         .run = toy_run,
                                         .cancel = toy_cancel,
#ifndef TOY_WITHOUT_LAST_ERROR
                                         .last_error = toy_last_error,
#endif
                                         .get_extension = toy_extension};
static const talweg_plugin* const toy_plugins[] = {&toy_plugin, &toy_plugin};

#ifndef TOY_SIZE
#define TOY_SIZE sizeof(talweg_module)
#endif
#ifndef TOY_COUNT
#define TOY_COUNT 1
#endif
static const talweg_module toy_module = {TOY_SIZE,  TOY_MAJOR, TOY_MINOR,
                                         TOY_NEEDS, TOY_COUNT, toy_plugins};

#ifdef TOY_FOREIGN
TALWEG_PLUGIN_EXPORT int some_other_entry(void);
int some_other_entry(void) { return toy_module.size != 0 && toy_last_error(NULL) != NULL; }
#else
const talweg_module* talweg_plugin_entry(uint32_t host_major, uint32_t host_minor) {
  (void)toy_last_error;
#ifdef TOY_NEEDS_HOST
  if (host_minor < TOY_NEEDS_HOST) return NULL;
#endif
  (void)host_major, (void)host_minor;
  return &toy_module;
}
#endif
