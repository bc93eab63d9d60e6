#include "talweg/core/io/mesh_reader.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/mesh_file.hpp"
#include "talweg/core/io/other_formats.hpp"
#include "talweg/core/io/text_encoding.hpp"
#include "talweg/core/io/text_words.hpp"
#include "talweg/core/mesh/polygon_triangulation.hpp"

namespace talweg {
namespace {

using FormatReader = MeshLists (*)(const MeshFile&, MeshAttributes*);

struct Format {
  std::string_view extension;
  FormatReader read;
};

/// The order is the order of the list in error messages.
constexpr std::array kFormats{
    Format{".obj", &read_obj},      Format{".off", &read_off}, Format{".ply", &read_ply},
    Format{".stl", &read_stl},      Format{".om", &read_om},   Format{".vtk", &read_vtk_mesh},
    Format{".vtp", &read_vtp_mesh}, Format{".msh", &read_msh}, Format{".gltf", &read_gltf},
    Format{".glb", &read_gltf},     Format{".3mf", &read_3mf}, Format{".gii", &read_gifti_mesh}};

/// FreeSurfer's extensions name the kind of a surface, not its format.
constexpr std::array kFreeSurfer{".white",        ".pial",    ".inflated", ".sphere",
                                 ".smoothwm",     ".orig",    ".mid",      ".reg",
                                 ".midthickness", ".graymid", ".nofix"};

FormatReader format_reader_of(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  for (const Format& format : kFormats) {
    if (extension == format.extension) return format.read;
  }
  if (std::find(kFreeSurfer.begin(), kFreeSurfer.end(), extension) != kFreeSurfer.end()) {
    return &read_freesurfer_mesh;
  }
  const std::string known = fmt::format("; expected {}.", readable_meshes());
  if (extension.empty()) bad_file(path, "the file name has no extension" + known);
  bad_file(path, fmt::format("'{}' is not a mesh format that Talweg reads{}{}",
                             printable(extension), instead_of(path), known));
}

MeshLists read_bytes(const std::filesystem::path& path, std::string_view bytes,
                     MeshAttributes* attributes) {
  const FormatReader read = format_reader_of(path);
  if (bytes.empty()) bad_file(path, "the file is empty.");
  const bool off_text = read == &read_off && !is_binary_off(bytes);
  if (read == &read_obj || off_text || read == &read_ply) {
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

std::string readable_meshes() {
  std::string all;
  for (std::size_t k = 0; k < kFormats.size(); ++k) {
    if (k > 0) all += ", ";
    all += kFormats[k].extension;
  }
  return all +
         " or a surface of FreeSurfer (.white, .pial, .inflated, .sphere, .smoothwm, .orig, .mid)";
}

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
