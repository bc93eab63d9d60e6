#include "plugin_meshes.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "cut_map.hpp"
#include "output_file.hpp"
#include "plugin_attributes.hpp"
#include "talweg/core/cutting/tagged_edges.hpp"
#include "talweg/core/io/mesh_file.hpp"
#include "talweg/core/io/mesh_writer.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::driver {
namespace {

PartOrigins origins_of(const host::Origin& origin) {
  PartOrigins result;
  for (std::size_t v = 0; v < origin.vertices.size(); ++v) {
    result.vertices.push_back({origin.vertices[v], origin.weights[v]});
  }
  result.faces = origin.triangles;
  for (std::size_t c = 0; c < origin.lengths.size(); ++c) {
    PartOrigins::Curve& curve = result.curves.emplace_back();
    curve.closed = origin.closed[c] != 0;
    curve.vertices.resize(origin.lengths[c]);
  }
  for (const auto& [curve, place, vertex] : origin.chains) {
    result.curves.at(curve).vertices.at(place).push_back(vertex);
  }
  return result;
}

}  // namespace

const talweg_meshes* meshes_of(const talweg_plugin& plugin) {
  const auto* found = static_cast<const talweg_meshes*>(plugin.get_extension(TALWEG_MESHES));
  return found != nullptr && found->size >= sizeof *found ? found : nullptr;
}

void check_tag(const std::string& path) {
  const std::string ending = lower_extension(path);
  if (ending == ".ply" || ending == ".obj" || ending == ".vtk" || ending == ".vtp") return;
  throw Error(ErrorCode::kBadUsage,
              "--tag needs an output that holds edges: .ply, .obj, .vtk or .vtp.");
}

PluginMeshes::PluginMeshes(const host::Instance& instance, const host::Results& results,
                           const MeshAttributes& attributes, bool single, PatientSpace space) {
  const talweg_meshes* extension = meshes_of(instance.plugin());
  for (const host::Mesh& mesh : results.meshes) {
    const std::size_t number = meshes_.size();
    Made& made = meshes_.emplace_back();
    made.lists.single_precision = single;
    made.lists.space = space;
    for (const auto& p : mesh.positions) made.lists.points.emplace_back(p.data());
    made.lists.triangles.assign(mesh.triangles.begin(), mesh.triangles.end());
    if (extension == nullptr) continue;
    made.origins = driver::origins_of(instance.origin(number));
    if ((extension->takes & TALWEG_TAKES_ATTRIBUTES) == 0) continue;
    made.attributes = file_attributes(attributes, instance.attributes(number));
  }
}

std::string PluginMeshes::path_of(const std::string& path, std::size_t mesh) const {
  if (meshes_.size() == 1) return path;
  const std::filesystem::path whole(path);
  return (whole.parent_path() /
          fmt::format("{}-{}{}", whole.stem().string(), mesh, whole.extension().string()))
      .string();
}

void PluginMeshes::write(const std::string& path, bool tag) const {
  for (std::size_t k = 0; k < meshes_.size(); ++k) {
    const Made& made = meshes_[k];
    const std::string name = path_of(path, k);
    std::vector<TaggedEdge> edges;
    if (tag) edges = tagged_edges(made.lists.triangles, made.origins.curves);
    write_output(name, mesh_bytes(name, made.lists, made.attributes, edges).bytes);
  }
}

void PluginMeshes::write_map(const std::string& map, const std::string& path) const {
  std::vector<PartOrigins> origins;
  std::vector<std::string> files;
  for (const Made& made : meshes_) {
    files.push_back(path.empty() ? "" : path_of(path, origins.size()));
    origins.push_back(made.origins);
  }
  write_output(map, cut_map_json(origins, files));
}

}  // namespace talweg::driver
