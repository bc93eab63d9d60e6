/*
 * The changes that a cut makes to a mesh, by indices: new vertices, divided triangles, and the
 * curves as chains of edges. A host applies such a plan to its own mesh, in place, and keeps all
 * other data of the mesh. The plan is an extension, plugin->get_extension(TALWEG_CUT_PLAN), which
 * talweg.cut offers.
 *
 *   const talweg_cut_plans *plans = plugin->get_extension(TALWEG_CUT_PLAN);
 *   talweg_sink sink = {sizeof sink, 0, context, 0, 0, take_report, 0};
 *   plugin->run(instance, &sink);             // wants no mesh, so only a plan is made
 *   plans->plan(instance, take_plan, context);
 *
 * The time of a run depends on the triangles that the curves touch, not on the size of the mesh, if
 * the sink wants no meshes and no parameter takes the mesh apart (`open`, `split`, `keep`, `cap`).
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

/* Old vertices and triangles have the indices of the given mesh. New vertices follow: the first has
 * the index `vertex_count`. No old vertex moves. */
typedef struct talweg_cut_plan {
  uint32_t size;
  uint32_t curve_count;    /* curves that were set */
  uint64_t vertex_count;   /* of the given mesh */
  uint64_t triangle_count; /* of the given mesh */
  /* 3 columns, a row for each new vertex: the old vertices of its edge or triangle. On an edge the
   * third is TALWEG_NO_VERTEX. */
  talweg_array vertices;
  talweg_array weights;   /* 3 columns, likewise: > 0, with sum 1; 0 where there is no vertex */
  talweg_array positions; /* 3 columns, likewise */
  talweg_array divided;   /* 1 column: the old triangles that are divided, ascending */
  talweg_array parts;     /* 1 column, for each divided triangle the number of its parts, >= 2 */
  /* 3 columns: the parts of the divided triangles, in their order, with their orientation. If an
   * edge gets vertices, the triangles on both sides are divided. */
  talweg_array triangles;
  talweg_array closed;  /* 1 column, for each curve 1 (closed) or 0 */
  talweg_array lengths; /* 1 column, for each curve the number of vertices in its chain of edges */
  talweg_array chains;  /* 1 column: the vertices of the first chain, of the second, ... */
} talweg_cut_plan;

typedef talweg_status (*talweg_cut_plan_function)(void *context, const talweg_cut_plan *plan);

typedef struct talweg_cut_plans {
  uint32_t size;
  uint32_t reserved; /* 0 */
  /* [instance] Passes the plan of the last run to `take`. A plan exists until the mesh or the
   * curves are set again, or a run begins. TALWEG_BAD_USAGE: there is no plan. TALWEG_UNSUPPORTED:
   * the mesh was repaired before the cut, so that the plan does not fit the given mesh.
   * TALWEG_HOST_FAILED: `take` returned another value than TALWEG_OK. */
  talweg_status (*plan)(talweg_instance *instance, talweg_cut_plan_function take /* [caller] */,
                        void *context);
} talweg_cut_plans;

#ifdef __cplusplus
}
#endif

#endif /* TALWEG_CUT_PLAN_H */
