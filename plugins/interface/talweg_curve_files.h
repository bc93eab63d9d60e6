/*
 * Curve files through the plugin interface: an extension of the plugin talweg.draw, asked for by
 * plugin->get_extension(TALWEG_CURVE_FILES). Formats by the file's extension, as the driver's:
 * .obj, .ply, .vtp, .vtk, .mrk.json, .fcsv, .json, .txt, and with TALWEG_CURVE_FILES_3 .border
 * (docs/driver.md).
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

/* For meshes in millimetres: .mrk.json files, which name their unit, are converted to it and written
 * in it. */
typedef struct talweg_curve_files {
  uint32_t size;
  /* [any thread] Writes curves as plugins give them: each with faces, barycentrics and positions,
   * and maybe vertices (.txt needs them), pins (.json and .mrk.json hold them) and the field `exact`
   * (talweg_way_points.h; .json, .vtp and .vtk hold it). The same curves make the same bytes. A file that could not be written is as it
   * was. `message`, of `message_size` bytes, gets one sentence on a failure, cut where it is too
   * long, and may be null. */
  talweg_status (*write)(const char* path, const talweg_curve* const* curves, uint64_t count,
                         char* message, uint64_t message_size);
  /* [any thread] Gives every curve of a file to the sink's `curve`, in order, as input for
   * set_curves(): vertices, or faces with barycentrics, or positions; pins; and the field `exact`
   * where the file says something of points. Nothing is checked against a mesh. */
  talweg_status (*read)(const char* path, const talweg_sink* sink, char* message,
                        uint64_t message_size);
} talweg_curve_files;

/* For meshes in any unit and space. `mesh_unit` is the unit's UCUM code ("mm", "cm", "m", "um",
 * "[in_i]", ...; null: "mm"), or what talweg_mesh_file's `frame` says: also "RAS" or "mm RAS", and
 * positions of files in another space get x and y turned. One that is not known is
 * TALWEG_BAD_USAGE. After a success `message` of read tells what was converted or left out, a few
 * sentences, or is empty. All else is as above. */
typedef struct talweg_curve_files_2 {
  uint32_t size;
  talweg_status (*write)(const char* path, const char* mesh_unit,
                         const talweg_curve* const* curves, uint64_t count, char* message,
                         uint64_t message_size);
  talweg_status (*read)(const char* path, const char* mesh_unit, const talweg_sink* sink,
                        char* message, uint64_t message_size);
} talweg_curve_files_2;

/* For the curves of one mesh, since 0.2.0: .border files name the vertices around each point, and no
 * other functions read and write them. `mesh` is that of the curves: its triangles tell the face of
 * each point, and of its positions only the number counts. A point between vertices that have no common triangle is
 * TALWEG_BAD_CURVE. A null mesh is as with talweg_curve_files_2; all else is as there. */
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
