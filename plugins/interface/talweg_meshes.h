/*
 * Meshes with attributes through the plugin interface: values at vertices, triangles and corners go
 * in with a mesh, and come out with the meshes that a run makes of it, with where everything of them
 * comes from. An extension that a plugin offers by plugin->get_extension(TALWEG_MESHES): talweg.cut,
 * talweg.labels and talweg.repair do.
 *
 *   float uv[3 * TRIANGLES][2] = ...;
 *   talweg_attribute texture = {sizeof texture, TALWEG_OF_CORNERS, TALWEG_CARRY_LINEAR, 0, "uv", 0,
 *                               {uv, 3 * TRIANGLES, 0, 2, TALWEG_FLOAT32}, {0}};
 *   const talweg_attribute *all[] = {&texture};
 *   meshes->set_attributes(instance, all, 1);    // after set_mesh()
 *   plugin->run(instance, &sink);                // gives meshes 0, 1, ... to sink.mesh
 *   meshes->attributes(instance, 0, take_attribute, context);
 *   meshes->origin(instance, 0, take_origin, context);
 *
 * A host that has attributes of kinds that cannot be handed over carries them itself, by the origin.
 */
#ifndef TALWEG_MESHES_H
#define TALWEG_MESHES_H

#include "talweg_plugin.h"

#ifdef __cplusplus
extern "C" {
#endif

#define TALWEG_MESHES "talweg.meshes/1"

/* In `triangles` of an origin, and in `corners` of an attribute: none. */
#define TALWEG_NO_TRIANGLE UINT32_MAX
#define TALWEG_NO_ENTRY UINT32_MAX

/* What an attribute's values belong to. */
enum { TALWEG_OF_VERTICES = 1, TALWEG_OF_TRIANGLES = 2, TALWEG_OF_CORNERS = 3 };

/* What a new vertex or corner gets, from the three corners of the triangle that it lies in.
 * Triangles always have the values of the one that they are a part of. */
enum {
  TALWEG_CARRY_LINEAR = 1,   /* between them, linearly: real numbers */
  TALWEG_CARRY_ROUNDED = 2,  /* the same, rounded to whole numbers: colours of 8 bits */
  TALWEG_CARRY_NEAREST = 3,  /* the values of the nearest (the first of equals): numbers of things */
  TALWEG_CARRY_DIRECTION = 4 /* between them, and made as long as one: normals; 3 columns */
};

typedef struct talweg_attribute {
  uint32_t size;
  uint32_t element; /* TALWEG_OF_... */
  uint32_t carry;   /* TALWEG_CARRY_... */
  uint32_t reserved; /* 0 */
  const char *name;  /* not empty, and no other attribute of the same element has it */
  double fill;       /* in every column of what comes from nowhere, such as lids; not at corners */
  /* A row for each vertex or triangle, in their order; 1 to 64 columns of numbers of any type, whole
   * ones below 2^53. For corners three rows for each triangle, or entries that corners share. What comes out is dense and of the type that came in. */
  talweg_array values;
  /* Of corners that share entries: a row of 3 for each triangle, the entry of each of its corners,
   * or TALWEG_NO_ENTRY. Absent: corner k of triangle t has the entry 3 t + k. What comes out has it
   * if what came in had, or a corner has none. */
  talweg_array corners;
} talweg_attribute;

/*
 * Where a mesh that a run gave comes from, in the numbers of the mesh that came in. Each vertex lies
 * in a triangle of that one (or on an edge, or at a vertex), at `weights` between its `vertices`;
 * those that it does not need are TALWEG_NO_VERTEX, with the weight 0. A vertex that was there keeps
 * one, with the weight 1. One that comes from nowhere (inside a lid) has none.
 */
typedef struct talweg_origin {
  uint32_t size;
  uint32_t curve_count;   /* of the run: those that were set, or the borders that were found */
  talweg_array vertices;  /* 3 columns, a row for each vertex of the new mesh */
  talweg_array weights;   /* 3 columns, likewise: >= 0, with sum 1 or, for those from nowhere, 0 */
  talweg_array triangles; /* 1 column: the triangle that each is a part of, or TALWEG_NO_TRIANGLE */
  talweg_array closed;    /* 1 column, a row for each curve: 1 or 0 */
  talweg_array lengths;   /* 1 column, a row for each curve: vertices in its chain of edges */
  /* 3 columns: a curve, a place in its chain from 0, and a vertex of the new mesh that is there.
   * Ascending; where a seam was opened a place has two vertices or more, and one that is in another
   * mesh has none. */
  talweg_array chains;
} talweg_origin;

/* In `takes`. */
enum {
  TALWEG_TAKES_ATTRIBUTES = 1 << 0, /* set_attributes() and attributes() are there */
  TALWEG_TAKES_ANY_MESH = 1 << 1    /* set_mesh() takes what is no surface, too */
};

typedef talweg_status (*talweg_attribute_function)(void *context, const talweg_attribute *attribute);
typedef talweg_status (*talweg_origin_function)(void *context, const talweg_origin *origin);

typedef struct talweg_meshes {
  uint32_t size;
  uint32_t takes; /* TALWEG_TAKES_... */
  /* [instance] Copies the attributes of the mesh, which must be there. They replace those that were
   * set; set_mesh() and share_mesh() forget them. They change no result but attributes. Null where
   * `takes` does not have TALWEG_TAKES_ATTRIBUTES, as is the next one. */
  talweg_status (*set_attributes)(talweg_instance *instance,
                                  const talweg_attribute *const *attributes, uint64_t count);
  /* [instance] Gives the attributes of mesh number `mesh` of the last run, in the order in which
   * they came in, and then those that the plugin makes. There until the mesh, the curves or the
   * attributes are set again, or a run begins; TALWEG_BAD_USAGE if there is no such mesh. Only
   * runs whose sink wants meshes have them. What the function returns other than TALWEG_OK ends the
   * call with TALWEG_HOST_FAILED. */
  talweg_status (*attributes)(talweg_instance *instance, uint64_t mesh,
                              talweg_attribute_function take /* [caller] */, void *context);
  /* [instance] Gives where the mesh comes from; else as above. */
  talweg_status (*origin)(talweg_instance *instance, uint64_t mesh,
                          talweg_origin_function take /* [caller] */, void *context);
} talweg_meshes;

#ifdef __cplusplus
}
#endif

#endif /* TALWEG_MESHES_H */
