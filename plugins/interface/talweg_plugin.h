/*
 * The plugin interface of Talweg, version 1.2: curves on triangle meshes, in C11, without
 * dependencies. docs/plugins.md explains it with a host and a plugin.
 *
 * A plugin is a shared library with one exported symbol, talweg_plugin_entry. A host loads it (or
 * lets the loader of talweg_loader.h do that), creates instances, gives each a mesh, curves and
 * values of its parameters, and runs it; results come through a sink of the host's.
 *
 * Rules that hold everywhere
 *
 * - Structs never change after a release. Those that cross the boundary begin with their size, which
 *   the side that fills them sets to sizeof; the other side refuses a smaller one. What is new comes
 *   as an extension, asked for by its name (get_extension), or as a new value of an enumeration.
 * - Nothing is freed across the boundary. What a pointer given to a function points to is only
 *   looked at until the function returns. Strings are UTF-8 and end with 0.
 * - No exception and no longjmp crosses the boundary, either way.
 * - Vertices, triangles, curves and points are counted from 0, in the order in which they came.
 * - Lengths are in mesh units, angles in radians, times in milliseconds, memory in MiB.
 * - A call that fails changes nothing but the text of last_error, and the instance stays usable.
 *
 * Threads, as noted in brackets at every function
 *
 * - [any thread]  at any time, also while another call runs.
 * - [instance]    on any thread, but one call at a time for each instance; different instances
 *                 run at the same time. A second call meanwhile, be it from a callback, is refused
 *                 with TALWEG_BAD_USAGE and does nothing.
 * - [caller]      a function of the host's, called by the plugin on the thread of the call that it
 *                 serves, before that call returns.
 *
 * Licence: MIT, as all of Talweg.
 */
#ifndef TALWEG_PLUGIN_H
#define TALWEG_PLUGIN_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The version of this header. Same major: they work together (see talweg_module). */
#define TALWEG_INTERFACE_MAJOR 1
#define TALWEG_INTERFACE_MINOR 2

/* The name of the one symbol, for dlsym(). */
#define TALWEG_PLUGIN_ENTRY "talweg_plugin_entry"

#if defined(_WIN32)
#define TALWEG_PLUGIN_EXPORT __declspec(dllexport)
#elif defined(__GNUC__)
#define TALWEG_PLUGIN_EXPORT __attribute__((visibility("default")))
#else
#define TALWEG_PLUGIN_EXPORT
#endif

/* ---- What a call came to ---------------------------------------------------------------------- */

typedef uint32_t talweg_status;
enum {
  TALWEG_OK = 0,
  TALWEG_BAD_USAGE = 1,     /* an argument, a parameter, or the order of calls */
  TALWEG_BAD_MESH = 2,      /* the mesh is not a surface that can be worked on */
  TALWEG_BAD_CURVE = 3,     /* a curve does not lie on the mesh, or not properly */
  TALWEG_BAD_FILE = 4,      /* a file cannot be opened, read or written */
  TALWEG_NUMERICAL = 5,     /* a factorization or solve failed */
  TALWEG_OUT_OF_MEMORY = 6, /* memory ran out */
  TALWEG_CANCELLED = 7,     /* the host asked for it; there is no result */
  TALWEG_HOST_FAILED = 8,   /* a function of the host's sink failed; no more was given to it */
  TALWEG_UNSUPPORTED = 9,   /* the plugin does not do that */
  TALWEG_INTERNAL = 10      /* the plugin's own fault */
};

/* ---- Views of arrays -------------------------------------------------------------------------- */

enum {
  TALWEG_FLOAT64 = 1,
  TALWEG_FLOAT32 = 2,
  TALWEG_INT32 = 3,
  TALWEG_UINT32 = 4,
  TALWEG_INT64 = 5,
  TALWEG_UINT64 = 6,
  /* Since 1.2; a plugin that is older refuses them. */
  TALWEG_INT8 = 7,
  TALWEG_UINT8 = 8,
  TALWEG_INT16 = 9,
  TALWEG_UINT16 = 10
};

/*
 * `rows` rows of `columns` numbers of one type, each row's numbers side by side, rows `stride` bytes
 * apart (0: side by side, too). An array that is absent has rows = 0; its other members are not
 * looked at then. Where real numbers are expected integers will do; where indices are, only integers.
 * What plugins give is always dense, real numbers FLOAT64, indices UINT32 (attributes of meshes have
 * the type that came in, see talweg_meshes.h).
 * Fixed for good, hence without a size: 32 bytes on machines with 64-bit pointers.
 */
typedef struct talweg_array {
  const void *data;
  uint64_t rows;
  uint64_t stride;
  uint32_t columns;
  uint32_t type;
} talweg_array;

/* A named array: values per vertex or triangle of the mesh, or per point of a curve. */
typedef struct talweg_field {
  uint32_t size;
  const char *name; /* e.g. "distance" */
  const char *unit; /* e.g. "mesh units"; "" for a pure number */
  talweg_array values;
} talweg_field;

/* ---- Meshes and curves, in and out ------------------------------------------------------------ */

typedef struct talweg_mesh {
  uint32_t size;
  uint32_t field_count;    /* 0 in what a host gives */
  talweg_array positions;  /* one row of 3 per vertex */
  talweg_array triangles;  /* one row of 3 vertices per triangle, counterclockwise from outside */
  const talweg_field *const *fields; /* per vertex */
} talweg_mesh;

/* In `vertices`: the point lies at no vertex. */
#define TALWEG_NO_VERTEX UINT32_MAX

/*
 * A curve on the mesh. A closed one does not repeat its first point.
 *
 * As input its points are the first of these that is there: `vertices`; `faces` with
 * `barycentrics`; `positions`, which are moved to the nearest points of the mesh. A plugin's
 * description says what becomes of points that are not neighbours.
 *
 * As output each point and the next lie in one triangle, and that is the one in `faces` (of several
 * the first; for an open curve's last point that of the point before). `barycentrics` are in the
 * order of that triangle's vertices; `positions` are the points in space; `vertices` says which
 * vertex a point lies at, or TALWEG_NO_VERTEX.
 */
typedef struct talweg_curve {
  uint32_t size;
  uint32_t closed;           /* 0 or 1 */
  talweg_array vertices;     /* 1 column */
  talweg_array faces;        /* 1 column: triangles of the mesh */
  talweg_array barycentrics; /* 3 columns: each row >= 0 with sum 1 */
  talweg_array positions;    /* 3 columns */
  talweg_array pins;         /* in: 1 column, indices of points that shall stay; out: none */
  uint32_t field_count;      /* out: values per point; in: 0, or see talweg_way_points.h */
  const talweg_field *const *fields;
} talweg_curve;

/* ---- Parameters ------------------------------------------------------------------------------- */

enum {
  TALWEG_NUMBER = 1,   /* set_number: finite, within the range */
  TALWEG_INTEGER = 2,  /* set_number: a whole number within the range */
  TALWEG_BOOLEAN = 3,  /* set_number: 0 or 1 */
  TALWEG_CHOICE = 4,   /* set_choice: one of `choices` */
  TALWEG_VERTICES = 5, /* set_array: 1 column, vertices of the mesh; empty by default */
  TALWEG_FIELD = 6,    /* set_array: 1 column, one number per vertex of the mesh; none by default */
  TALWEG_PER_CURVE = 7, /* since 1.1; set_array: 1 column, one number per curve; none by default */
  TALWEG_TRIANGLE_FIELD = 8 /* since 1.2; set_array: 1 column, one number per triangle of the mesh;
                               none by default */
};

/* What a change of a parameter, of the curves or of the mesh makes the next run() repeat: that stage
 * and those behind it, never one before it. */
enum {
  TALWEG_STAGE_MESH = 1,   /* everything, as a new mesh does */
  TALWEG_STAGE_CURVES = 2, /* what depends on the curves, as new curves do */
  TALWEG_STAGE_RUN = 3     /* only what every run() does: made for a slider */
};

enum {
  TALWEG_OPTIONAL = 1 << 0,       /* has no value by default, as after reset(); `doc` says what then */
  TALWEG_OPEN_MINIMUM = 1 << 1,   /* `minimum` itself is not allowed */
  TALWEG_LOGARITHMIC = 1 << 2,    /* a slider for it is better logarithmic */
  TALWEG_ADVANCED = 1 << 3        /* a panel may hide it at first */
};

typedef struct talweg_parameter {
  uint32_t size;
  uint32_t type;      /* TALWEG_NUMBER, ... */
  uint32_t stage;     /* TALWEG_STAGE_... */
  uint32_t flags;     /* TALWEG_OPTIONAL, ... */
  const char *id;     /* stable: small letters, digits and _ , e.g. "max_deviation" */
  const char *label;  /* for people, e.g. "Largest deviation" */
  const char *unit;   /* "mesh units", "radians", ... ; "" for a pure number */
  const char *doc;    /* one or two sentences */
  double default_number; /* NUMBER, INTEGER, BOOLEAN; not looked at where OPTIONAL */
  double minimum;        /* NUMBER, INTEGER; may be -infinity */
  double maximum;        /* may be +infinity */
  double soft_minimum;   /* what a slider should offer, within the range above; finite */
  double soft_maximum;
  const char *default_choice; /* CHOICE, else null */
  uint32_t choice_count;      /* CHOICE, else 0 */
  const char *const *choices;       /* ids, e.g. "corridor" */
  const char *const *choice_labels; /* for people, as many */
} talweg_parameter;

/* ---- Outputs ---------------------------------------------------------------------------------- */

enum {
  TALWEG_OUTPUT_CURVES = 1,      /* a number of curves */
  TALWEG_OUTPUT_POINT_FIELD = 2, /* values per point of each of these curves */
  TALWEG_OUTPUT_VERTEX_FIELD = 3,/* values per vertex of the mesh */
  TALWEG_OUTPUT_REPORT = 4,      /* keys and values */
  TALWEG_OUTPUT_MESH = 5,        /* a number of meshes; see talweg_meshes.h */
  TALWEG_OUTPUT_TRIANGLE_FIELD = 6 /* since 1.2; values per triangle of the mesh */
};

/* What a plugin can give. */
typedef struct talweg_output {
  uint32_t size;
  uint32_t kind;     /* TALWEG_OUTPUT_... */
  const char *name;  /* of a field: its name; else an id */
  const char *label; /* for people */
  const char *unit;  /* of a field's values; else "" */
  const char *doc;
} talweg_output;

enum {
  TALWEG_VALUE_NUMBER = 1,  /* may be infinite: without bound, or not measured */
  TALWEG_VALUE_INTEGER = 2, /* whole, below 2^53 */
  TALWEG_VALUE_BOOLEAN = 3, /* 0 or 1 */
  TALWEG_VALUE_TEXT = 4
};

/*
 * One line of a report: a value, or a list of values, under a key. Dots in a key say that it belongs
 * to a group ("time_ms.trace"); a number between them, from 0, is the place in a list of groups
 * ("regions.0.label"), which has an empty list under its own key ("regions") if there are none. Names and units of ours: docs/driver.md, "The report".
 */
typedef struct talweg_report_entry {
  uint32_t size;
  uint32_t type;    /* TALWEG_VALUE_... */
  int64_t curve;    /* which curve it is about; -1: all together, or none */
  const char *key;  /* small letters, digits, _ and . */
  uint32_t is_list; /* 0: exactly one value; 1: `count` of them, maybe none */
  uint32_t count;
  const double *numbers;    /* NUMBER, INTEGER and BOOLEAN */
  const char *const *texts; /* TEXT */
} talweg_report_entry;

/* Sink: also give the point fields with the curves, which may cost more than the curves. */
#define TALWEG_WANT_POINT_FIELDS 1u

/*
 * Where results go. A null function means that such results are not wanted; what they alone need is
 * not computed then. Functions return TALWEG_OK, or anything else to end the run with
 * TALWEG_HOST_FAILED. Order: the report's entries for all, then for each curve the curve and its
 * entries; then fields; then meshes. Nothing is given unless the run has succeeded.
 */
typedef struct talweg_sink {
  uint32_t size;
  uint32_t wants; /* TALWEG_WANT_... */
  void *context;
  talweg_status (*curve)(void *context, const talweg_curve *curve);               /* [caller] */
  talweg_status (*field)(void *context, const talweg_field *field);               /* [caller] */
  talweg_status (*report)(void *context, const talweg_report_entry *entry);       /* [caller] */
  talweg_status (*mesh)(void *context, const talweg_mesh *mesh);                  /* [caller] */
} talweg_sink;

/* ---- The host and its services ---------------------------------------------------------------- */

/* Stays where it is, unchanged, as long as an instance made with it lives. */
typedef struct talweg_host {
  uint32_t size;
  uint32_t interface_major; /* TALWEG_INTERFACE_MAJOR */
  uint32_t interface_minor; /* TALWEG_INTERFACE_MINOR */
  const char *name;         /* e.g. "ParaView" */
  const char *version;
  void *context; /* the host's own */
  /* [any thread] A service by its id, which lives as long as the host struct; null: not offered. The
   * member may be null: no services. */
  const void *(*get_extension)(const struct talweg_host *host, const char *id);
} talweg_host;

#define TALWEG_HOST_LOG "talweg.log/1"
enum { TALWEG_LOG_DEBUG = 1, TALWEG_LOG_INFO = 2, TALWEG_LOG_WARNING = 3, TALWEG_LOG_ERROR = 4 };
typedef struct talweg_host_log {
  uint32_t size;
  /* [caller] One sentence, without a line's end. */
  void (*log)(const talweg_host *host, uint32_t severity, const char *message);
} talweg_host_log;

#define TALWEG_HOST_PROGRESS "talweg.progress/1"
typedef struct talweg_host_progress {
  uint32_t size;
  /* [caller] From time to time while set_mesh or run works: the stage's name, and how much of it is
   * done, in [0, 1]. Returns 1 to go on, 0 to cancel: the call ends with TALWEG_CANCELLED. */
  uint32_t (*progress)(const talweg_host *host, const char *stage, double fraction);
} talweg_host_progress;

/* ---- The plugin ------------------------------------------------------------------------------- */

/* One workspace: a mesh, curves on it, values of parameters. */
typedef struct talweg_instance talweg_instance;

enum {
  TALWEG_TAKES_CURVES = 1 << 0 /* run() needs set_curves() first */
};

/* Constant, and there as long as the module is loaded. */
typedef struct talweg_plugin {
  uint32_t size;
  uint32_t flags;      /* TALWEG_TAKES_CURVES */
  const char *id;      /* stable and unique, e.g. "talweg.smooth" */
  const char *label;   /* for people, e.g. "Smooth curves" */
  const char *version; /* of the plugin, e.g. "0.1.0" */
  const char *doc;     /* what it does, and what it makes of the curves that it is given */
  uint32_t parameter_count;
  uint32_t output_count;
  const talweg_parameter *const *parameters; /* in the order of a panel */
  const talweg_output *const *outputs;

  /* [any thread] Makes an instance with default values. `host` may be null: no services. On failure
   * *instance is null, and the status is all there is to know. */
  talweg_status (*create)(const talweg_host *host, talweg_instance **instance);

  /* [instance] Frees everything; null is allowed. Not while a call on the instance runs. */
  void (*destroy)(talweg_instance *instance);

  /* [instance] Copies the mesh, once, and checks it. Curves that were set are forgotten.
   * TALWEG_BAD_MESH: last_error says what is wrong, and where; the last mesh stays. */
  talweg_status (*set_mesh)(talweg_instance *instance, const talweg_mesh *mesh);

  /* [instance] Takes the mesh of another instance of the same plugin: nothing is copied, and the two
   * may then run on different threads. `other` must have a mesh, and no set_mesh or share_mesh on it
   * may run meanwhile; any other call may. */
  talweg_status (*share_mesh)(talweg_instance *instance, const talweg_instance *other);

  /* [instance] Copies the curves and puts them on the mesh, which must be there. They replace those
   * that were set. TALWEG_BAD_CURVE: the ones before stay. Curves that a drawing cannot have (it
   * crosses itself, for example) may also be refused by run(). TALWEG_UNSUPPORTED without the flag
   * TALWEG_TAKES_CURVES. */
  talweg_status (*set_curves)(talweg_instance *instance, const talweg_curve *const *curves,
                              uint64_t count);

  /* [instance] New values of parameters. TALWEG_BAD_USAGE for an id that the plugin does not have,
   * a parameter of another type, or a value out of its range; the old value stays then. Whether an
   * array fits the mesh and the curves is told by run(). */
  talweg_status (*set_number)(talweg_instance *instance, const char *id, double value);
  talweg_status (*set_choice)(talweg_instance *instance, const char *id, const char *value);
  talweg_status (*set_array)(talweg_instance *instance, const char *id, const talweg_array *values);
  /* [instance] Back to the default, or as it was: the parameter's stage is repeated either way. */
  talweg_status (*reset)(talweg_instance *instance, const char *id);

  /* [instance] Does what is not up to date yet, and gives the results to `sink`. Same input and
   * values: the same results, bit for bit, but for times and memory in the report. */
  talweg_status (*run)(talweg_instance *instance, const talweg_sink *sink);

  /* [any thread] A call that runs on the instance ends with TALWEG_CANCELLED at its next progress;
   * where none runs nothing happens, and a later call is not touched. Not during destroy. */
  void (*cancel)(talweg_instance *instance);

  /* [instance] One sentence on why the last call failed, fit for people; "" if it did not. There
   * until the next call on the instance. Never null. */
  const char *(*last_error)(const talweg_instance *instance);

  /* [any thread] An extension of the plugin by its id, a constant as the plugin itself; null: not
   * offered. */
  const void *(*get_extension)(const char *id);
} talweg_plugin;

/* ---- The entry -------------------------------------------------------------------------------- */

/*
 * What a shared library offers. Versions meet as follows. The majors must be the same. A host of an
 * older minor takes a plugin of a newer one unless that `needs_minor` more; a host of a newer minor
 * takes every older plugin. Both may use what the other's version is sure to have, and ask by
 * get_extension for everything else.
 */
typedef struct talweg_module {
  uint32_t size;
  uint32_t interface_major; /* TALWEG_INTERFACE_MAJOR of its header */
  uint32_t interface_minor; /* TALWEG_INTERFACE_MINOR of its header */
  uint32_t needs_minor;     /* the least minor of a host that it works with; mostly 0 */
  uint64_t plugin_count;
  const talweg_plugin *const *plugins;
} talweg_module;

/*
 * [any thread] The one exported symbol. Tells the plugin the host's version; answers with a constant
 * that is there as long as the library is loaded, or null: it does not work with such a host.
 */
typedef const talweg_module *(*talweg_plugin_entry_function)(uint32_t host_major,
                                                             uint32_t host_minor);
TALWEG_PLUGIN_EXPORT const talweg_module *talweg_plugin_entry(uint32_t host_major,
                                                              uint32_t host_minor);

#ifdef __cplusplus
}
#endif

#endif /* TALWEG_PLUGIN_H */
