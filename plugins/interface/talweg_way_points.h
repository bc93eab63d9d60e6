/*
 * Way-points through the plugin interface: which points of a curve are meant exactly, as clicks are,
 * and which were painted. A plugin that offers the extension TALWEG_WAY_POINTS by
 * plugin->get_extension() reads them from the curves that set_curves() gets, from a field `exact`:
 *
 *   double marks[] = {0, TALWEG_MARK_NONE, 0.5};
 *   talweg_field exact = {sizeof exact, TALWEG_EXACT, "mesh units", {marks, 3, 0, 1, TALWEG_FLOAT64}};
 *   const talweg_field *fields[] = {&exact};
 *   curve.field_count = 1;
 *   curve.fields = fields;
 *
 * Curves without the field say nothing. Between two way-points that follow each other a curve is
 * free, unless a point between them was painted; everything else is a stroke. Other fields of such
 * a curve are passed over, so that a curve which one plugin gives can be given to the next.
 *
 * Curves that talweg.draw gives have the field, and so have those of talweg_curve_files.h, in both
 * directions. Plugins without the extension take every curve as a stroke.
 */
#ifndef TALWEG_WAY_POINTS_H
#define TALWEG_WAY_POINTS_H

#include "talweg_plugin.h"

#ifdef __cplusplus
extern "C" {
#endif

#define TALWEG_WAY_POINTS "talweg.way_points/1"

/* The field: a number for each point. 0 or more is the tolerance of a way-point, in mesh units: how
 * far from it the result may pass. */
#define TALWEG_EXACT "exact"
#define TALWEG_MARK_NONE (-1.0)    /* nothing is said of the point */
#define TALWEG_MARK_PAINTED (-2.0) /* it was painted */
/* It controls a curve of another program. Such points are way-points if the curve's are few and far
 * apart on the mesh, as clicks are (docs/driver.md); otherwise nothing is said of them. */
#define TALWEG_MARK_CONTROL (-3.0)

typedef struct talweg_way_points {
  uint32_t size;
  uint32_t reads_exact; /* 1: set_curves() reads the field */
} talweg_way_points;

#ifdef __cplusplus
}
#endif

#endif /* TALWEG_WAY_POINTS_H */
