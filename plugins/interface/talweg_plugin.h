/*
 * The plugin interface of Talweg, version 1.2: curves on triangle meshes, in C11, without
 * dependencies. docs/plugins.md explains it with a host and a plugin.
 *
 * A plugin is a shared library with one exported symbol, talweg_plugin_entry. A host loads it (or
 * uses the loader of talweg_loader.h), creates instances, gives each a mesh, curves and values of
 * its parameters, and runs it; the plugin passes results to functions of the host's sink.
 *
 * Rules for all functions
 *
 * - Structs never change after a release. A struct that crosses the boundary begins with its size,
 *   which the side that fills it sets to sizeof; the other side refuses a smaller one. Additions
 *   are extensions, found by name (get_extension), or new values of an enumeration.
 * - No memory is freed across the boundary. A function reads the memory behind its pointers only
 *   until it returns. Strings are UTF-8 and end with 0.
 * - No exception and no longjmp crosses the boundary, either way.
 * - Vertices, triangles, curves and points are counted from 0, in the order of the arrays.
 * - Lengths are in mesh units, angles in radians, times in milliseconds, memory in MiB.
 * - A failed call changes nothing but the text of last_error, and the instance stays usable.
 *
 * Threads, as noted in brackets at every function
 *
 * - [any thread]  at any time, also while another call runs.
 * - [instance]    on any thread, but one call at a time for each instance; different instances run
 *                 at the same time. A second call at the same time, even from a callback, is
 *                 refused with TALWEG_BAD_USAGE and does nothing.
 * - [caller]      a function of the host's, called by the plugin on the thread of the host's call,
 *                 before that call returns.
 *
 * Licence: MIT, as all of Talweg.
 */
#ifndef TALWEG_PLUGIN_H
#define TALWEG_PLUGIN_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The version of this header. Versions with the same major work together (see talweg_module). */
#define TALWEG_INTERFACE_MAJOR 1
#define TALWEG_INTERFACE_MINOR 2

/* The name of the exported symbol, for dlsym(). */
#define TALWEG_PLUGIN_ENTRY "talweg_plugin_entry"

#if defined(_WIN32)
#define TALWEG_PLUGIN_EXPORT __declspec(dllexport)
#elif defined(__GNUC__)
#define TALWEG_PLUGIN_EXPORT __attribute__((visibility("default")))
#else
#define TALWEG_PLUGIN_EXPORT
#endif

/* ---- Status of a call ------------------------------------------------------------------------- */

typedef uint32_t talweg_status;
enum {
  TALWEG_OK = 0,
  TALWEG_BAD_USAGE = 1,     /* a wrong argument or parameter, or a wrong order of calls */
  TALWEG_BAD_MESH = 2,      /* the mesh is not a surface that curves can be drawn on */
  TALWEG_BAD_CURVE = 3,     /* a curve does not lie on the mesh, or is invalid */
  TALWEG_BAD_FILE = 4,      /* a file cannot be opened, read or written */
  TALWEG_NUMERICAL = 5,     /* a factorization or solve failed */
  TALWEG_OUT_OF_MEMORY = 6, /* memory ran out */
  TALWEG_CANCELLED = 7,     /* cancelled by the host; there is no result */
  TALWEG_HOST_FAILED = 8,   /* a function of the host's sink failed; no more results were passed */
  TALWEG_UNSUPPORTED = 9,   /* the plugin does not have this function */
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
  /* Since 1.2; an older plugin refuses them. */
  TALWEG_INT8 = 7,
  TALWEG_UINT8 = 8,
  TALWEG_INT16 = 9,
  TALWEG_UINT16 = 10
};

/*
 * `rows` rows of `columns` numbers of one type, contiguous within a row, with rows `stride` bytes
 * apart (0: rows are contiguous, too). An absent array has rows = 0; its other members are not read
 * then. Integers may be given for real numbers; indices must be integers. Arrays from plugins are
 * dense, real numbers FLOAT64, indices UINT32 (attributes of meshes have the type of the given
 * values, see talweg_meshes.h). This struct never grows, hence it has no size: 32 bytes on machines
 * with 64-bit pointers.
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

/* ---- Meshes and curves, as input and as results ----------------------------------------------- */

typedef struct talweg_mesh {
  uint32_t size;
  uint32_t field_count;    /* 0 for a host's mesh */
  talweg_array positions;  /* one row of 3 per vertex */
  talweg_array triangles;  /* one row of 3 vertices per triangle, counterclockwise from outside */
  const talweg_field *const *fields; /* per vertex */
} talweg_mesh;

/* In `vertices`: the point is at no vertex. */
#define TALWEG_NO_VERTEX UINT32_MAX

/*
 * A curve on the mesh. A closed curve does not repeat its first point.
 *
 * As input, its points are given by the first present of: `vertices`; `faces` with `barycentrics`;
 * `positions`, which are moved to the nearest points of the mesh. A plugin's description says how
 * points that are not neighbours are joined.
 *
 * As a result, each point and the next lie in a common triangle, which `faces` names (the first, if
 * there are several; the last point of an open curve has the triangle of the point before).
 * `barycentrics` are in the order of this triangle's vertices; `positions` are the points in space;
 * `vertices` has the vertex that a point is at, or TALWEG_NO_VERTEX.
 */
typedef struct talweg_curve {
  uint32_t size;
  uint32_t closed;           /* 0 or 1 */
  talweg_array vertices;     /* 1 column */
  talweg_array faces;        /* 1 column: triangles of the mesh */
  talweg_array barycentrics; /* 3 columns: each row >= 0 with sum 1 */
  talweg_array positions;    /* 3 columns */
  talweg_array pins;         /* input: 1 column, points that must not move; result: absent */
  uint32_t field_count;      /* result: values per point; input: 0, or see talweg_way_points.h */
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

/* The first stage that run() repeats after a change of a parameter, of the curves or of the mesh.
 * All later stages are repeated, too; earlier stages never. */
enum {
  TALWEG_STAGE_MESH = 1,   /* everything, as after a new mesh */
  TALWEG_STAGE_CURVES = 2, /* stages that depend on the curves, as after new curves */
  TALWEG_STAGE_RUN = 3     /* only the work of every run(): quick enough for a slider */
};

enum {
  TALWEG_OPTIONAL = 1 << 0,       /* no value by default and after reset(), see `doc` */
  TALWEG_OPEN_MINIMUM = 1 << 1,   /* `minimum` itself is not allowed */
  TALWEG_LOGARITHMIC = 1 << 2,    /* a slider should be logarithmic */
  TALWEG_ADVANCED = 1 << 3        /* a panel may hide it at first */
};

typedef struct talweg_parameter {
  uint32_t size;
  uint32_t type;      /* TALWEG_NUMBER, ... */
  uint32_t stage;     /* TALWEG_STAGE_... */
  uint32_t flags;     /* TALWEG_OPTIONAL, ... */
  const char *id;     /* stable: small letters, digits and _ , e.g. "max_deviation" */
  const char *label;  /* for the user, e.g. "Largest deviation" */
  const char *unit;   /* "mesh units", "radians", ... ; "" for a pure number */
  const char *doc;    /* one or two sentences */
  double default_number; /* NUMBER, INTEGER, BOOLEAN; ignored if OPTIONAL */
  double minimum;        /* NUMBER, INTEGER; may be -infinity */
  double maximum;        /* may be +infinity */
  double soft_minimum;   /* range for a slider, within the range above; finite */
  double soft_maximum;
  const char *default_choice; /* CHOICE, else null */
  uint32_t choice_count;      /* CHOICE, else 0 */
  const char *const *choices;       /* ids, e.g. "corridor" */
  const char *const *choice_labels; /* for the user, as many as choices */
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

/* A kind of result of a plugin. */
typedef struct talweg_output {
  uint32_t size;
  uint32_t kind;     /* TALWEG_OUTPUT_... */
  const char *name;  /* the name of a field; otherwise an id */
  const char *label; /* for the user */
  const char *unit;  /* unit of a field; otherwise "" */
  const char *doc;
} talweg_output;

enum {
  TALWEG_VALUE_NUMBER = 1,  /* may be infinite: not bounded, or not measured */
  TALWEG_VALUE_INTEGER = 2, /* whole, below 2^53 */
  TALWEG_VALUE_BOOLEAN = 3, /* 0 or 1 */
  TALWEG_VALUE_TEXT = 4
};

/*
 * One line of a report: a value, or a list of values, under a key. A dot in a key separates a group
 * from its member ("time_ms.trace"); a number between dots, from 0, is the index in a list of
 * groups ("regions.0.label"). An empty list of groups has an empty list under its own key
 * ("regions"). Names and units of Talweg's plugins: docs/driver.md, "The report".
 */
typedef struct talweg_report_entry {
  uint32_t size;
  uint32_t type;    /* TALWEG_VALUE_... */
  int64_t curve;    /* index of the curve that the entry is about; -1: all curves, or none */
  const char *key;  /* small letters, digits, _ and . */
  uint32_t is_list; /* 0: exactly one value; 1: `count` values, possibly none */
  uint32_t count;
  const double *numbers;    /* NUMBER, INTEGER and BOOLEAN */
  const char *const *texts; /* TEXT */
} talweg_report_entry;

/* Flag of a sink: pass point fields with the curves; computing them may take longer than the
   curves. */
#define TALWEG_WANT_POINT_FIELDS 1u

/*
 * The host's functions for results. A null function means that the host does not want such results;
 * work for them alone is skipped. A function returns TALWEG_OK; any other value ends the run with
 * TALWEG_HOST_FAILED. Order: the report's entries for all curves; for each curve the curve and its
 * entries; fields; meshes. A failed or cancelled run passes no results.
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

/* Must keep its address and its values as long as an instance made with it exists. */
typedef struct talweg_host {
  uint32_t size;
  uint32_t interface_major; /* TALWEG_INTERFACE_MAJOR */
  uint32_t interface_minor; /* TALWEG_INTERFACE_MINOR */
  const char *name;         /* e.g. "ParaView" */
  const char *version;
  void *context; /* for the host's own use */
  /* [any thread] A service by its id, valid as long as the host struct; null: not offered. The
   * member may be null: no services. */
  const void *(*get_extension)(const struct talweg_host *host, const char *id);
} talweg_host;

#define TALWEG_HOST_LOG "talweg.log/1"
enum { TALWEG_LOG_DEBUG = 1, TALWEG_LOG_INFO = 2, TALWEG_LOG_WARNING = 3, TALWEG_LOG_ERROR = 4 };
typedef struct talweg_host_log {
  uint32_t size;
  /* [caller] One sentence, without a line break. */
  void (*log)(const talweg_host *host, uint32_t severity, const char *message);
} talweg_host_log;

#define TALWEG_HOST_PROGRESS "talweg.progress/1"
typedef struct talweg_host_progress {
  uint32_t size;
  /* [caller] Called repeatedly during set_mesh and run, with the stage's name, and its completed
   * fraction in [0, 1]. Returns 1 to continue, 0 to cancel: the call ends with TALWEG_CANCELLED. */
  uint32_t (*progress)(const talweg_host *host, const char *stage, double fraction);
} talweg_host_progress;

/* ---- The plugin ------------------------------------------------------------------------------- */

/* A workspace: a mesh, curves on it, and values of parameters. */
typedef struct talweg_instance talweg_instance;

enum {
  TALWEG_TAKES_CURVES = 1 << 0 /* run() needs set_curves() first */
};

/* Constant, and valid as long as the module is loaded. */
typedef struct talweg_plugin {
  uint32_t size;
  uint32_t flags;      /* TALWEG_TAKES_CURVES */
  const char *id;      /* stable and unique, e.g. "talweg.smooth" */
  const char *label;   /* for the user, e.g. "Smooth curves" */
  const char *version; /* of the plugin, e.g. "0.1.0" */
  const char *doc;     /* the purpose, and how given curves are interpreted */
  uint32_t parameter_count;
  uint32_t output_count;
  const talweg_parameter *const *parameters; /* in the order of a panel */
  const talweg_output *const *outputs;

  /* [any thread] Makes an instance with default values. `host` may be null: no services. On failure
   * *instance is null, and only the status tells why. */
  talweg_status (*create)(const talweg_host *host, talweg_instance **instance);

  /* [instance] Frees everything; null is allowed. No call on the instance may be running. */
  void (*destroy)(talweg_instance *instance);

  /* [instance] Copies the mesh, once, and checks it. Curves that were set are removed.
   * TALWEG_BAD_MESH: last_error says what is wrong, and where; the earlier mesh stays. */
  talweg_status (*set_mesh)(talweg_instance *instance, const talweg_mesh *mesh);

  /* [instance] Takes the mesh of another instance of the same plugin: nothing is copied, and the
   * two instances may run on different threads afterwards. `other` must have a mesh, and no
   * set_mesh or share_mesh on it may run at the same time; any other call may. */
  talweg_status (*share_mesh)(talweg_instance *instance, const talweg_instance *other);

  /* [instance] Copies the curves and places them on the mesh, which must be set. They replace
   * earlier curves. TALWEG_BAD_CURVE: the earlier curves stay. Curves that are invalid as a drawing
   * (because they cross themselves, for example) may also be refused by run(). TALWEG_UNSUPPORTED
   * without the flag TALWEG_TAKES_CURVES. */
  talweg_status (*set_curves)(talweg_instance *instance, const talweg_curve *const *curves,
                              uint64_t count);

  /* [instance] Set a parameter. TALWEG_BAD_USAGE: the plugin does not have the id, the parameter
   * has another type, or the value is out of range; the old value stays. run() checks whether an
   * array fits the mesh and the curves. */
  talweg_status (*set_number)(talweg_instance *instance, const char *id, double value);
  talweg_status (*set_choice)(talweg_instance *instance, const char *id, const char *value);
  talweg_status (*set_array)(talweg_instance *instance, const char *id, const talweg_array *values);
  /* [instance] Sets a parameter to its default. The parameter's stage is repeated even if the value
     does not change. */
  talweg_status (*reset)(talweg_instance *instance, const char *id);

  /* [instance] Does all work whose input has changed, and passes the results to `sink`. Equal input
   * and values give equal results, bit for bit, except for times and memory in the report. */
  talweg_status (*run)(talweg_instance *instance, const talweg_sink *sink);

  /* [any thread] The call that runs on the instance ends with TALWEG_CANCELLED at its next
   * progress. Without a running call nothing happens, and later calls are not affected. Not allowed
   * during destroy. */
  void (*cancel)(talweg_instance *instance);

  /* [instance] A sentence for the user on why the last call failed; "" if it succeeded. Valid until
   * the next call on the instance. Never null. */
  const char *(*last_error)(const talweg_instance *instance);

  /* [any thread] An extension of the plugin by its id, valid as long as the plugin; null: not
   * offered. */
  const void *(*get_extension)(const char *id);
} talweg_plugin;

/* ---- The entry -------------------------------------------------------------------------------- */

/*
 * The plugins of a shared library. Rules for versions: the majors must be equal. A host with an
 * older minor accepts a newer plugin if the plugin's `needs_minor` is not above the host's minor; a
 * host with a newer minor accepts every older plugin. Each side may use everything that the other
 * side's version has, and uses get_extension for the rest.
 */
typedef struct talweg_module {
  uint32_t size;
  uint32_t interface_major; /* TALWEG_INTERFACE_MAJOR of its header */
  uint32_t interface_minor; /* TALWEG_INTERFACE_MINOR of its header */
  uint32_t needs_minor;     /* the lowest minor of hosts that the module works with; mostly 0 */
  uint64_t plugin_count;
  const talweg_plugin *const *plugins;
} talweg_module;

/*
 * [any thread] The exported symbol. The arguments are the host's version; the result is a constant
 * that is valid as long as the library is loaded, or null if the library does not work with this
 * host.
 */
typedef const talweg_module *(*talweg_plugin_entry_function)(uint32_t host_major,
                                                             uint32_t host_minor);
TALWEG_PLUGIN_EXPORT const talweg_module *talweg_plugin_entry(uint32_t host_major,
                                                              uint32_t host_minor);

#ifdef __cplusplus
}
#endif

#endif /* TALWEG_PLUGIN_H */
