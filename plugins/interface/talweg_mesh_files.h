/*
 * Mesh files through the plugin interface: an extension of the plugin talweg.repair, which a host
 * gets by plugin->get_extension(TALWEG_MESH_FILES). The file's extension selects the format, as in
 * the driver: .obj, .off, .ply, .stl, .vtk, .vtp, and for reading .om, .msh, .gltf, .glb and .3mf
 * (docs/meshes.md).
 *
 * Related columns of a file form one attribute (talweg_meshes.h), which is written as such columns
 * again. The attribute `normals` has the columns nx ny nz; `colors` has red green blue, and
 * optionally alpha; `uv` of vertices has s t, u v or texture_u texture_v, and is written as s t;
 * another attribute NAME with several columns has NAME_0 NAME_1 ... Attributes of corners are `uv`
 * (2 or 3 columns) and `normals`. All other attributes have the names of the file's columns.
 */
#ifndef TALWEG_MESH_FILES_H
#define TALWEG_MESH_FILES_H

#include "talweg_meshes.h"

#ifdef __cplusplus
extern "C" {
#endif

#define TALWEG_MESH_FILES "talweg.mesh_files/1"

/* Names of an OBJ file for groups of triangles. */
typedef struct talweg_name_list {
  uint32_t size;
  uint32_t count;        /* at least 1 */
  const char* attribute; /* "o", "g", "usemtl" or "s": attribute of triangles, 1 column, indices of
                            `names` */
  const char* const* names; /* UTF-8, one line each; the first is for triangles without a name */
} talweg_name_list;

typedef struct talweg_mesh_file {
  uint32_t size;
  uint32_t attribute_count;
  const talweg_mesh* mesh; /* positions are FLOAT32 if the file's digits need no more */
  const talweg_attribute* const* attributes;
  uint32_t name_list_count;
  uint32_t reference_count;
  const talweg_name_list* const* name_lists;
  const char* const* references; /* lines that name other files: "mtllib bone.mtl" */
  uint64_t polygon_count; /* number of the file's faces with more than three corners; 0 when
                             writing */
  /* For writing .obj and .ply: edges of curves, 3 columns: two vertices, and the curve. */
  talweg_array edges;
  /* Unit and space of the file's coordinates: a unit (its UCUM code), an anatomical space (LPS or
   * RAS), both ("mm RAS") or nothing (""). When writing, null stands for nothing; formats without a
   * place for the frame leave it out. talweg_curve_files_2 takes a frame as its `mesh_unit`.
   * Structs of interface 1.2 end before this member. */
  const char* frame;
} talweg_mesh_file;

typedef talweg_status (*talweg_mesh_file_function)(void* context, const talweg_mesh_file* file);
/* `text` is UTF-8, and valid until the function returns. */
typedef void (*talweg_text_function)(void* context, const char* text);

typedef struct talweg_mesh_files {
  uint32_t size;
  uint32_t reserved;
  /* [any thread] Passes the mesh of a file to `take`, once; the mesh is valid until `take` returns.
   * No element is dropped, and the mesh need not be a surface. `left_out`, which may be null, gets
   * a few words for each kind of data that is not read. `message`, of `message_size` bytes, gets a
   * sentence on a failure, truncated to this size; it may be null. */
  talweg_status (*read)(const char* path, talweg_mesh_file_function take /* [caller] */,
                        talweg_text_function left_out /* [caller] */, void* context, char* message,
                        uint64_t message_size);
  /* [any thread] Writes a mesh. If the file cannot be written, an existing file stays unchanged.
   * `left_out` gets a few words for each kind of data that the format cannot hold. Blanks in names
   * become "_". */
  talweg_status (*write)(const char* path, const talweg_mesh_file* file,
                         talweg_text_function left_out /* [caller] */, void* context, char* message,
                         uint64_t message_size);
} talweg_mesh_files;

#ifdef __cplusplus
}
#endif

#endif /* TALWEG_MESH_FILES_H */
