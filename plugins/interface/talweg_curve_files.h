/*
 * Curve files through the plugin interface: an extension of the plugin talweg.draw, which a host
 * gets by plugin->get_extension(TALWEG_CURVE_FILES). The file's extension selects the format, as in
 * the driver: .obj, .ply, .vtp, .vtk, .mrk.json, .fcsv, .json, .txt, and with TALWEG_CURVE_FILES_3
 * .border (docs/driver.md).
 */
#ifndef TALWEG_CURVE_FILES_H
#define TALWEG_CURVE_FILES_H

#include "talweg_plugin.h"

#ifdef __cplusplus
extern "C" {
#endif

#define TALWEG_CURVE_FILES "talweg.curve_files/1"
#define TALWEG_CURVE_FILES_2 "talweg.curve_files/2"
#define TALWEG_CURVE_FILES_3 "talweg.curve_files/3"

/* For meshes in millimetres: curves of .mrk.json files, which name their unit, are converted to
 * millimetres when they are read, and written in millimetres. */
typedef struct talweg_curve_files {
  uint32_t size;
  /* [any thread] Writes curves in the form of plugins' results: each with faces, barycentrics and
   * positions, and optionally vertices (.txt needs them), pins (stored in .json and .mrk.json) and
   * the field `exact` (talweg_way_points.h; stored in .json, .vtp and .vtk). Equal curves give
   * equal bytes. If the file cannot be written, an existing file stays unchanged. `message`, of
   * `message_size` bytes, gets a sentence on a failure, truncated to this size; it may be null. */
  talweg_status (*write)(const char* path, const talweg_curve* const* curves, uint64_t count,
                         char* message, uint64_t message_size);
  /* [any thread] Passes every curve of a file to the sink's `curve`, in order, as input for
   * set_curves(): vertices, or faces with barycentrics, or positions; pins; and the field `exact`
   * if the file marks points. Indices are not checked against a mesh. */
  talweg_status (*read)(const char* path, const talweg_sink* sink, char* message,
                        uint64_t message_size);
} talweg_curve_files;

/* For meshes in any unit and space. `mesh_unit` is the unit's UCUM code ("mm", "cm", "m", "um",
 * "[in_i]", ...; null: "mm"), or the `frame` of a talweg_mesh_file, which may add the space: "RAS"
 * or "mm RAS". Positions of files in the other space get x and y negated. An unknown unit is
 * TALWEG_BAD_USAGE. After a success of `read`, `message` has a few sentences on conversions and
 * omissions, or is empty. The rest is as in talweg_curve_files. */
typedef struct talweg_curve_files_2 {
  uint32_t size;
  talweg_status (*write)(const char* path, const char* mesh_unit,
                         const talweg_curve* const* curves, uint64_t count, char* message,
                         uint64_t message_size);
  talweg_status (*read)(const char* path, const char* mesh_unit, const talweg_sink* sink,
                        char* message, uint64_t message_size);
} talweg_curve_files_2;

/* For the curves of one mesh, since 0.2.0. Only these functions read and write .border files, which
 * name the vertices around each point. `mesh` is the mesh of the curves: its triangles give the
 * face of each point; of its positions only the number is used. A point between vertices without a
 * common triangle is TALWEG_BAD_CURVE. With a null mesh, and in all other respects, the functions
 * act as those of talweg_curve_files_2. */
typedef struct talweg_curve_files_3 {
  uint32_t size;
  talweg_status (*write)(const char* path, const char* mesh_unit, const talweg_mesh* mesh,
                         const talweg_curve* const* curves, uint64_t count, char* message,
                         uint64_t message_size);
  talweg_status (*read)(const char* path, const char* mesh_unit, const talweg_mesh* mesh,
                        const talweg_sink* sink, char* message, uint64_t message_size);
} talweg_curve_files_3;

#ifdef __cplusplus
}
#endif

#endif /* TALWEG_CURVE_FILES_H */
