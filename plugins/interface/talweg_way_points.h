/*
 * Way-points through the plugin interface: marks for points of a curve that the result must pass,
 * such as clicks, and for painted points. A plugin that offers the extension TALWEG_WAY_POINTS by
 * plugin->get_extension() reads them from the curves that set_curves() gets, from a field `exact`:
 *
 *   double marks[] = {0, TALWEG_MARK_NONE, 0.5};
 *   talweg_field exact = {sizeof exact, TALWEG_EXACT, "mesh units", {marks, 3, 0, 1, TALWEG_FLOAT64}};
 *   const talweg_field *fields[] = {&exact};
 *   curve.field_count = 1;
 *   curve.fields = fields;
 *
 * A curve without the field has no marks. Between two consecutive way-points a curve is free,
 * unless a point between them was painted; the rest of the curve is a stroke. Other fields are
 * ignored, so that the result of one plugin can be the input of the next.
 *
 * Results of talweg.draw have the field. The functions of talweg_curve_files.h read and write it.
 * Plugins without the extension treat every curve as a stroke.
 */
#ifndef TALWEG_WAY_POINTS_H
#define TALWEG_WAY_POINTS_H

#include "talweg_plugin.h"

#ifdef __cplusplus
extern "C" {
#endif

#define TALWEG_WAY_POINTS "talweg.way_points/1"

/* The name of the field, which has a number for each point. 0 or more is the tolerance of a
 * way-point: the largest distance, in mesh units, at which the result may pass. */
#define TALWEG_EXACT "exact"
#define TALWEG_MARK_NONE (-1.0)    /* the point has no mark */
#define TALWEG_MARK_PAINTED (-2.0) /* the point was painted */
/* A control point of a curve of another program. Control points are way-points if they are few and
 * far apart on the mesh, like clicks (docs/driver.md); otherwise they have no mark. */
#define TALWEG_MARK_CONTROL (-3.0)

typedef struct talweg_way_points {
  uint32_t size;
  uint32_t reads_exact; /* 1: set_curves() reads the field */
} talweg_way_points;

#ifdef __cplusplus
}
#endif

#endif /* TALWEG_WAY_POINTS_H */
