/*
 * What a cut changes, by number: new vertices, divided triangles, and the curves as chains of edges.
 * A host applies it to its own mesh, in place, and keeps all that the mesh knows. An extension that
 * a plugin offers by plugin->get_extension(TALWEG_CUT_PLAN): talweg.cut does.
 *
 *   const talweg_cut_plans *plans = plugin->get_extension(TALWEG_CUT_PLAN);
 *   talweg_sink sink = {sizeof sink, 0, context, 0, 0, take_report, 0};
 *   plugin->run(instance, &sink);             // wants no mesh, so only a plan is made
 *   plans->plan(instance, take_plan, context);
 *
 * A run costs what the curves touch, however large the mesh is, if its sink wants no meshes and no
 * parameter says that the mesh is to be taken apart (`open`, `split`, `keep`, `cap`).
 *
 * For meshes of OpenMesh, talweg/core/openmesh/plan_application.hpp applies a plan.
 */
#ifndef TALWEG_CUT_PLAN_H
#define TALWEG_CUT_PLAN_H

#include "talweg_plugin.h"

#ifdef __cplusplus
extern "C" {
#endif

#define TALWEG_CUT_PLAN "talweg.cut_plan/1"

/* Old vertices and triangles have the numbers of the mesh that came in. New vertices follow: the
 * first has the number `vertex_count`. No old vertex moves. */
typedef struct talweg_cut_plan {
  uint32_t size;
  uint32_t curve_count;    /* of those that were set */
  uint64_t vertex_count;   /* of the mesh that came in */
  uint64_t triangle_count; /* likewise */
  /* 3 columns, a row for each new vertex: the old vertices of the edge or triangle that it lies in.
   * On an edge the third is TALWEG_NO_VERTEX. */
  talweg_array vertices;
  talweg_array weights;   /* 3 columns, likewise: > 0, with sum 1; 0 where there is no vertex */
  talweg_array positions; /* 3 columns, likewise */
  talweg_array divided;   /* 1 column: the old triangles that are divided, ascending */
  talweg_array parts;     /* 1 column, a row for each of these: how many triangles it becomes, >= 2 */
  /* 3 columns: the triangles that take their places, those of the first divided one first. They
   * have its orientation. Where an edge gets vertices, the triangles on both sides are divided. */
  talweg_array triangles;
  talweg_array closed;  /* 1 column, a row for each curve: 1 or 0 */
  talweg_array lengths; /* 1 column, a row for each curve: vertices in its chain of edges */
  talweg_array chains;  /* 1 column: the vertices of the first chain, of the second, ... */
} talweg_cut_plan;

typedef talweg_status (*talweg_cut_plan_function)(void *context, const talweg_cut_plan *plan);

typedef struct talweg_cut_plans {
  uint32_t size;
  uint32_t reserved; /* 0 */
  /* [instance] Gives the plan of the last run. There until the mesh or the curves are set again, or a
   * run begins; TALWEG_BAD_USAGE if there is none, TALWEG_UNSUPPORTED if the mesh was repaired before
   * it was cut, so that the plan is not one for the mesh that came in. What the function returns
   * other than TALWEG_OK ends the call with TALWEG_HOST_FAILED. */
  talweg_status (*plan)(talweg_instance *instance, talweg_cut_plan_function take /* [caller] */,
                        void *context);
} talweg_cut_plans;

#ifdef __cplusplus
}
#endif

#endif /* TALWEG_CUT_PLAN_H */
