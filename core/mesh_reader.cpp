#include "talweg/core/mesh_reader.hpp"

#include <limits>
#include <string>

#include "talweg/core/formats/file_bytes.hpp"
#include "talweg/core/formats/mesh_file.hpp"

namespace talweg {
namespace {

using Reader = MeshLists (*)(const MeshFile&);

Reader reader_of(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  if (extension == ".obj") return &read_obj;
  if (extension == ".off") return &read_off;
  if (extension == ".ply") return &read_ply;
  if (extension == ".stl") return &read_stl;
  if (extension == ".om") return &read_om;
  bad_file(path, (extension.empty() ? "the file name has no extension"
                                    : "'" + extension + "' is no mesh format we read") +
                     "; expected .obj, .off, .ply, .stl or .om.");
}

}  // namespace

MeshLists read_mesh(const std::filesystem::path& path) {
  const Reader read = reader_of(path);
  const std::string bytes = read_file(path);
  MeshLists lists = read({path, bytes});
  if (lists.points.empty()) bad_file(path, "the file contains no vertices.");
  constexpr std::size_t kMost = std::numeric_limits<std::uint32_t>::max();
  if (lists.points.size() >= kMost || lists.triangles.size() >= kMost / 6) {
    bad_file(path, "the mesh has more elements than 32-bit indices can count.");
  }
  return lists;
}

}  // namespace talweg
