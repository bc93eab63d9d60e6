// The readers of mesh formats share a type for the file in memory, error messages, and fans of
// polygons.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "talweg/core/mesh/mesh_attributes.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg {

/// A file in memory.
struct MeshFile {
  std::filesystem::path path;
  std::string_view bytes;
};

/// Throws Error(kBadFile): "Cannot read PATH: what" or
/// "Cannot read PATH, line N: what"; `what` ends with a period.
[[noreturn]] void bad_file(const std::filesystem::path& path, const std::string& what);
[[noreturn]] void bad_line(const std::filesystem::path& path, std::size_t line,
                           const std::string& what);

/// The extension in lower case: ".ply" for "A.PLY".
std::string lower_extension(const std::filesystem::path& path);

/// The vertices of a text file with a coordinate that is not finite, and their lines. A stray
/// vertex is an error only if a face uses it.
class StrayVertices {
 public:
  /// Adds a stray vertex. Of several such coordinates of one vertex only the last is kept for the
  /// message.
  void add(std::size_t vertex, std::size_t line, std::string_view word);
  /// Throws Error(kBadFile) naming the first stray vertex that a face uses. O(faces) if there are
  /// stray vertices.
  void check(const MeshFile& file, const MeshLists& lists) const;

 private:
  struct Stray {
    std::size_t vertex, line;
    std::string_view word;
  };
  std::vector<Stray> all_;
};

/// Appends the fan of triangles of a polygon with at least three corners. read_mesh() triangulates
/// concave polygons again when all points are known.
void add_polygon(MeshLists& lists, std::span<const std::uint32_t> corners);

/// Each reader also reads the file's attributes if `attributes` is not null.
MeshLists read_obj(const MeshFile& file, MeshAttributes* attributes = nullptr);
MeshLists read_off(const MeshFile& file, MeshAttributes* attributes = nullptr);
/// Whether the first line of an OFF file says BINARY.
bool is_binary_off(std::string_view bytes);
MeshLists read_binary_off(const MeshFile& file, MeshAttributes* attributes);
MeshLists read_ply(const MeshFile& file, MeshAttributes* attributes = nullptr);
MeshLists read_stl(const MeshFile& file, MeshAttributes* attributes = nullptr);
MeshLists read_om(const MeshFile& file, MeshAttributes* attributes = nullptr);
MeshLists read_gifti_mesh(const MeshFile& file, MeshAttributes* attributes = nullptr);
MeshLists read_freesurfer_mesh(const MeshFile& file, MeshAttributes* attributes = nullptr);
MeshLists read_gltf(const MeshFile& file, MeshAttributes* attributes = nullptr);
MeshLists read_3mf(const MeshFile& file, MeshAttributes* attributes = nullptr);
MeshLists read_msh(const MeshFile& file, MeshAttributes* attributes = nullptr);
MeshLists read_vtk_mesh(const MeshFile& file, MeshAttributes* attributes = nullptr);
MeshLists read_vtp_mesh(const MeshFile& file, MeshAttributes* attributes = nullptr);

}  // namespace talweg
