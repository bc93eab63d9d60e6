#include "talweg/core/io/mesh_reader.hpp"

#include <limits>
#include <string>

#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/mesh_file.hpp"
#include "talweg/core/io/text_encoding.hpp"
#include "talweg/core/mesh/polygon_triangulation.hpp"

namespace talweg {
namespace {

using FormatReader = MeshLists (*)(const MeshFile&, MeshAttributes*);

FormatReader format_reader_of(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  if (extension == ".obj") return &read_obj;
  if (extension == ".off") return &read_off;
  if (extension == ".ply") return &read_ply;
  if (extension == ".stl") return &read_stl;
  if (extension == ".om") return &read_om;
  if (extension == ".gii") return &read_gifti_mesh;
  for (const char* surface : {".white", ".pial", ".inflated", ".sphere", ".smoothwm", ".orig",
                              ".mid", ".midthickness", ".graymid", ".reg", ".nofix"}) {
    if (extension == surface) return &read_freesurfer_mesh;
  }
  bad_file(path, (extension.empty() ? "the file name has no extension"
                                    : "'" + extension + "' is no mesh format we read") +
                     "; expected .obj, .off, .ply, .stl, .om, .gii (GIFTI), or a surface of "
                     "FreeSurfer (.white, "
                     ".pial, .inflated, .sphere, .smoothwm, .orig, .mid).");
}

MeshLists read_bytes(const std::filesystem::path& path, std::string_view bytes,
                     MeshAttributes* attributes) {
  const FormatReader read = format_reader_of(path);
  if (bytes.empty()) bad_file(path, "the file is empty.");
  if (read == &read_obj || read == &read_off || read == &read_ply) {
    formats::check_encoding(path, bytes);
    formats::check_line_ends(path, bytes);
    if (read != &read_ply) formats::check_no_nul(path, bytes);
  }
  MeshLists lists = read({path, bytes}, attributes);
  if (lists.points.empty()) bad_file(path, "the file contains no vertices.");
  constexpr std::size_t kMost = std::numeric_limits<std::uint32_t>::max();
  if (lists.points.size() >= kMost || lists.triangles.size() >= kMost / 6) {
    bad_file(path, "the mesh has more elements than 32-bit indices can count.");
  }
  triangulate_polygons(lists, attributes);
  return lists;
}

}  // namespace

MeshLists read_mesh(const std::filesystem::path& path) {
  static_cast<void>(format_reader_of(path));  // checks the extension before the file is read
  return read_mesh(path, read_file(path));
}

MeshLists read_mesh(const std::filesystem::path& path, MeshAttributes& attributes) {
  static_cast<void>(format_reader_of(path));
  return read_mesh(path, read_file(path), attributes);
}

MeshLists read_mesh(const std::filesystem::path& path, std::string_view bytes) {
  return read_bytes(path, bytes, nullptr);
}

MeshLists read_mesh(const std::filesystem::path& path, std::string_view bytes,
                    MeshAttributes& attributes) {
  attributes = {};
  return read_bytes(path, bytes, &attributes);
}

}  // namespace talweg
