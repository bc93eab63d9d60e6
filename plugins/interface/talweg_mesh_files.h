/*
 * Mesh files through the plugin interface: an extension of the plugin talweg.repair, asked for by
 * plugin->get_extension(TALWEG_MESH_FILES). Formats by the file's extension, as the driver's: .obj,
 * .off, .ply, .stl, .vtk, .vtp, and for reading .om, .msh, .gltf, .glb and .3mf (docs/meshes.md).
 *
 * Columns of a file that belong together are one attribute (talweg_meshes.h), and the other way
 * round: `normals` is nx ny nz; `colors` red green blue, and alpha; `uv` of vertices s t, u v or
 * texture_u texture_v (written: s t); `NAME` with several columns NAME_0 NAME_1 ... At corners
 * there are `uv` (2 or 3 columns) and `normals`. Others have the file's names.
 */
#ifndef TALWEG_MESH_FILES_H
#define TALWEG_MESH_FILES_H

#include "talweg_meshes.h"

#ifdef __cplusplus
extern "C" {
#endif

#define TALWEG_MESH_FILES "talweg.mesh_files/1"

/* Names that an OBJ file gives to groups of triangles. */
typedef struct talweg_name_list {
  uint32_t size;
  uint32_t count;        /* at least 1 */
  const char* attribute; /* "o", "g", "usemtl" or "s": of triangles, 1 column, places in `names` */
  const char* const* names; /* UTF-8, one line each; the first is for triangles without a name */
} talweg_name_list;

typedef struct talweg_mesh_file {
  uint32_t size;
  uint32_t attribute_count;
  const talweg_mesh* mesh; /* FLOAT32 positions where the file has no more digits */
  const talweg_attribute* const* attributes;
  uint32_t name_list_count;
  uint32_t reference_count;
  const talweg_name_list* const* name_lists;
  const char* const* references; /* lines that name other files: "mtllib bone.mtl" */
  uint64_t polygon_count; /* of the file's faces, those with more than three corners; 0 to write */
  /* To write into .obj and .ply: edges of curves, 3 columns: two vertices, and the curve. */
  talweg_array edges;
  /* What the file says of its coordinates: a unit (its UCUM code), the space of a patient (LPS or
   * RAS), both ("mm RAS") or nothing (""). To write, null is nothing; formats without a place for it
   * leave it out. talweg_curve_files_2 takes it. Structs of interface 1.2 end before it. */
  const char* frame;
} talweg_mesh_file;

typedef talweg_status (*talweg_mesh_file_function)(void* context, const talweg_mesh_file* file);
/* `text` is UTF-8, and there until the function returns. */
typedef void (*talweg_text_function)(void* context, const char* text);

typedef struct talweg_mesh_files {
  uint32_t size;
  uint32_t reserved;
  /* [any thread] Gives the mesh of a file once; it is there until `take` returns. Nothing is
   * dropped, and no surface is asked for. `left_out`, which may be null, is told what of the file
   * is not read, a few words each. `message`, of `message_size` bytes, gets one sentence on a
   * failure, cut where it is too long, and may be null. */
  talweg_status (*read)(const char* path, talweg_mesh_file_function take /* [caller] */,
                        talweg_text_function left_out /* [caller] */, void* context, char* message,
                        uint64_t message_size);
  /* [any thread] Writes a mesh. A file that could not be written is as it was. `left_out` is told
   * what the format does not hold. Blanks in names become "_". */
  talweg_status (*write)(const char* path, const talweg_mesh_file* file,
                         talweg_text_function left_out /* [caller] */, void* context, char* message,
                         uint64_t message_size);
} talweg_mesh_files;

#ifdef __cplusplus
}
#endif

#endif /* TALWEG_MESH_FILES_H */
