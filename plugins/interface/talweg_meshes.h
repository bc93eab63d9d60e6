/*
 * Meshes with attributes through the plugin interface: a host sets values at vertices, triangles
 * and corners of a mesh, and gets the values on the meshes that a run makes, with the origin of
 * each element. The extension plugin->get_extension(TALWEG_MESHES) is offered by talweg.cut,
 * talweg.labels and talweg.repair.
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
 * A host can interpolate attributes of other kinds itself, with the origin of each element.
 */
#ifndef TALWEG_MESHES_H
#define TALWEG_MESHES_H

#include "talweg_plugin.h"

#ifdef __cplusplus
extern "C" {
#endif

#define TALWEG_MESHES "talweg.meshes/1"

/* No triangle, in `triangles` of an origin; no entry, in `corners` of an attribute. */
#define TALWEG_NO_TRIANGLE UINT32_MAX
#define TALWEG_NO_ENTRY UINT32_MAX

/* The kind of elements that an attribute's values belong to. */
enum { TALWEG_OF_VERTICES = 1, TALWEG_OF_TRIANGLES = 2, TALWEG_OF_CORNERS = 3 };

/* The rule for the values of a new vertex or corner, from the three corners of the old triangle
 * that it lies in. New triangles always copy the values of the old triangle that they are a part
 * of. */
enum {
  TALWEG_CARRY_LINEAR = 1,   /* linear interpolation, for real numbers */
  TALWEG_CARRY_ROUNDED = 2,  /* linear interpolation, rounded to whole numbers: colours of 8 bits */
  TALWEG_CARRY_NEAREST = 3,  /* values of the nearest corner (the first of equally near ones): labels, ids */
  TALWEG_CARRY_DIRECTION = 4 /* linear interpolation, scaled to length 1: normals; 3 columns */
};

typedef struct talweg_attribute {
  uint32_t size;
  uint32_t element; /* TALWEG_OF_... */
  uint32_t carry;   /* TALWEG_CARRY_... */
  uint32_t reserved; /* 0 */
  const char *name;  /* not empty, unique among attributes of the same element */
  double fill;       /* for vertices and triangles without an origin, such as lids; in each column */
  /* A row for each vertex or triangle, in their order; 1 to 64 columns of numbers of any type,
   * whole numbers below 2^53. For corners: three rows for each triangle, or entries that corners
   * share. Attributes in results are dense and have the type of the given values. */
  talweg_array values;
  /* For corners that share entries: 3 columns, a row for each triangle: the entry of each of its
   * corners, or TALWEG_NO_ENTRY. Absent: corner k of triangle t has the entry 3 t + k. In results
   * the array is present if the given attribute had it, or if a corner has no entry. */
  talweg_array corners;
} talweg_attribute;

/*
 * The origin of a mesh that a run made, in indices of the given mesh. Each vertex is the
 * combination of `vertices` of one old triangle (or edge, or vertex) with `weights`; vertices that
 * are not needed are TALWEG_NO_VERTEX, with the weight 0. An old vertex has itself, with the weight
 * 1. A vertex inside a lid has no origin.
 */
typedef struct talweg_origin {
  uint32_t size;
  uint32_t curve_count;   /* of the run: the curves that were set, or the borders that were found */
  talweg_array vertices;  /* 3 columns, a row for each vertex of the new mesh */
  talweg_array weights;   /* 3 columns, likewise: >= 0, with sum 1, or 0 without an origin */
  talweg_array triangles; /* 1 column: the old triangle of each, or TALWEG_NO_TRIANGLE */
  talweg_array closed;    /* 1 column, for each curve 1 (closed) or 0 */
  talweg_array lengths;   /* 1 column, for each curve the number of vertices in its chain of edges */
  /* 3 columns, ascending: a curve, a place in its chain from 0, and a vertex of the new mesh at
   * this place. A place on an opened seam has two rows or more; a place in another mesh has
   * none. */
  talweg_array chains;
} talweg_origin;

/* Flags of `takes`. */
enum {
  TALWEG_TAKES_ATTRIBUTES = 1 << 0, /* set_attributes() and attributes() are not null */
  TALWEG_TAKES_ANY_MESH = 1 << 1    /* set_mesh() also takes a mesh that is not a surface */
};

typedef talweg_status (*talweg_attribute_function)(void *context, const talweg_attribute *attribute);
typedef talweg_status (*talweg_origin_function)(void *context, const talweg_origin *origin);

typedef struct talweg_meshes {
  uint32_t size;
  uint32_t takes; /* TALWEG_TAKES_... */
  /* [instance] Copies attributes of the mesh, which must be set. They replace the attributes of
   * an earlier call; set_mesh() and share_mesh() clear them. They affect no results other than
   * attributes. This function and `attributes` are null if `takes` lacks
   * TALWEG_TAKES_ATTRIBUTES. */
  talweg_status (*set_attributes)(talweg_instance *instance,
                                  const talweg_attribute *const *attributes, uint64_t count);
  /* [instance] Passes the attributes of mesh number `mesh` of the last run to `take`: first the
   * given attributes in their order, then the plugin's own. They exist after a run whose sink wants
   * meshes, until the mesh, the curves or the attributes are set again, or a run begins.
   * TALWEG_BAD_USAGE: there is no such mesh. TALWEG_HOST_FAILED: `take` returned another value than
   * TALWEG_OK. */
  talweg_status (*attributes)(talweg_instance *instance, uint64_t mesh,
                              talweg_attribute_function take /* [caller] */, void *context);
  /* [instance] Passes the origin of the mesh to `take`; otherwise as `attributes`. */
  talweg_status (*origin)(talweg_instance *instance, uint64_t mesh,
                          talweg_origin_function take /* [caller] */, void *context);
} talweg_meshes;

#ifdef __cplusplus
}
#endif

#endif /* TALWEG_MESHES_H */
