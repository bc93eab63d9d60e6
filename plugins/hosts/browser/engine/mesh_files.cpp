#include "mesh_files.hpp"

#include <utility>

#include "talweg/plugin/talweg_mesh_files.h"

namespace talweg::browser {
namespace {

const talweg_mesh_files& files_of(const editing::Plugins& plugins) {
  return *static_cast<const talweg_mesh_files*>(
      plugins.find("talweg.repair").get_extension(TALWEG_MESH_FILES));
}

talweg_status take(void* context, const talweg_mesh_file* file) {
  auto& mesh = *static_cast<FileMesh*>(context);
  try {
    auto arrays = std::make_shared<editing::MeshArrays>();
    host::Mesh copy = host::detail::copy(*file->mesh);
    arrays->positions = std::move(copy.positions);
    arrays->triangles = std::move(copy.triangles);
    for (std::uint32_t k = 0; k < file->attribute_count; ++k) {
      mesh.attributes.push_back(host::detail::copy(*file->attributes[k]));
    }
    mesh.arrays = std::move(arrays);
    if (file->size >= sizeof *file) mesh.frame = file->frame;
    return TALWEG_OK;
  } catch (...) {
    return TALWEG_OUT_OF_MEMORY;
  }
}

/// Whether the word is an anatomical space (talweg_mesh_files.h).
bool is_space(const std::string& word) { return word == "LPS" || word == "RAS"; }

void note(void* context, const char* text) {
  static_cast<FileMesh*>(context)->left_out.emplace_back(text);
}

}  // namespace

std::string unit_in(const std::string& frame) {
  const std::string first = frame.substr(0, frame.find(' '));
  return is_space(first) ? "" : first;
}

std::string with_unit(const std::string& frame, const std::string& unit) {
  const std::string last = frame.substr(frame.rfind(' ') + 1);
  const std::string space = is_space(last) ? last : "";
  return unit.empty() || space.empty() ? unit + space : unit + " " + space;
}

FileMesh read_mesh(const editing::Plugins& plugins, const std::string& path) {
  FileMesh mesh;
  std::string message(1000, 0);
  const talweg_status status =
      files_of(plugins).read(path.c_str(), take, note, &mesh, message.data(), message.size());
  if (status != TALWEG_OK) throw host::Error(status, message.c_str());
  return mesh;
}

std::vector<std::string> write_mesh(const editing::Plugins& plugins, const std::string& path,
                                    const editing::MeshArrays& mesh,
                                    const std::vector<host::Attribute>& attributes,
                                    const std::string& frame) {
  const talweg_mesh view = {
      sizeof view, 0, host::detail::view_of(mesh.positions),
      host::view(mesh.triangles.empty() ? nullptr : mesh.triangles.front().data(),
                 mesh.triangles.size(), 3),
      nullptr};
  std::vector<talweg_attribute> views;
  std::vector<const talweg_attribute*> list;
  for (const host::Attribute& attribute : attributes) {
    views.push_back(host::detail::view_of(attribute));
  }
  for (const talweg_attribute& attribute : views) list.push_back(&attribute);
  talweg_mesh_file file = {};
  file.size = sizeof file;
  file.mesh = &view;
  file.attribute_count = static_cast<std::uint32_t>(list.size());
  file.attributes = list.data();
  file.frame = frame.c_str();
  FileMesh notes;
  std::string message(1000, 0);
  const talweg_status status =
      files_of(plugins).write(path.c_str(), &file, note, &notes, message.data(), message.size());
  if (status != TALWEG_OK) throw host::Error(status, message.c_str());
  return notes.left_out;
}

}  // namespace talweg::browser
