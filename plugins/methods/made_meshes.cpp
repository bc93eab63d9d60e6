#include "made_meshes.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "array_views.hpp"
#include "talweg/core/cutting/attribute_transfer.hpp"
#include "talweg/plugin/talweg_arrays.hpp"

namespace talweg::plugins {

void MadeMeshes::set_attributes(std::span<const talweg_attribute* const> attributes,
                                std::size_t vertices, std::size_t faces) {
  attributes_.set(attributes, vertices, faces);
  meshes_.clear();
}

void MadeMeshes::forget_attributes() {
  attributes_.clear();
  meshes_.clear();
}

const MadeMesh& MadeMeshes::at(std::uint64_t mesh) const {
  if (mesh < meshes_.size()) return meshes_[mesh];
  throw plugin::Failure(
      TALWEG_BAD_USAGE,
      fmt::format("There is no mesh {}: {} were made by the last run that gave meshes.", mesh,
                  meshes_.size()));
}

void MadeMeshes::give_attributes(std::uint64_t mesh, const plugin::TakeAttribute& take) const {
  const MadeMesh& made = at(mesh);
  attributes_.give(made.carry_over, take);
  if (made.own) made.own(take);
}

void MadeMeshes::give_origin(std::uint64_t mesh, const plugin::TakeOrigin& take) const {
  const MadeMesh& made = at(mesh);
  const PartOrigins origins = made.origins();
  std::vector<std::array<std::uint32_t, 3>> vertices, chains;
  std::vector<std::array<double, 3>> weights;
  vertices.reserve(made.vertices);
  weights.reserve(made.vertices);
  for (const VertexOrigin& origin : origins.vertices) {
    vertices.push_back(origin.vertices);
    weights.push_back(origin.weights);
  }
  const std::array<std::uint32_t, 3> nowhere{TALWEG_NO_VERTEX, TALWEG_NO_VERTEX, TALWEG_NO_VERTEX};
  vertices.resize(made.vertices, nowhere);  // vertices inside lids come last
  weights.resize(made.vertices);
  std::vector<std::uint32_t> closed, lengths;
  for (std::uint32_t c = 0; c < origins.curves.size(); ++c) {
    const PartOrigins::Curve& curve = origins.curves[c];
    closed.push_back(curve.closed ? 1 : 0);
    lengths.push_back(static_cast<std::uint32_t>(curve.vertices.size()));
    for (std::uint32_t k = 0; k < curve.vertices.size(); ++k) {
      for (const std::uint32_t v : curve.vertices[k]) chains.push_back({c, k, v});
    }
  }
  talweg_origin origin = {};
  origin.curve_count = static_cast<std::uint32_t>(origins.curves.size());
  origin.vertices = view_of(vertices);
  origin.weights = view_of(weights);
  origin.triangles = view_of(origins.faces);
  origin.closed = view_of(closed);
  origin.lengths = view_of(lengths);
  origin.chains = view_of(chains);
  take(origin);
}

MadeMesh made_by_cut(const HostMesh& mesh, std::shared_ptr<const CutMesh> cut, MeshPart part) {
  MadeMesh made;
  made.vertices = part.lists.points.size();
  part.lists = {};  // the host has the lists
  const auto kept = std::make_shared<const MeshPart>(std::move(part));
  made.origins = [&mesh, cut, kept] {
    return origins_of(*kept, *cut, mesh.mesh().surface(), mesh.map());
  };
  made.carry_over = [&mesh, cut = std::move(cut), kept](const MeshAttributes& attributes) {
    std::size_t differing = 0;
    const RepairMap* map = mesh.map();
    return picked(
        carried_to(*cut, mesh.mesh().surface(),
                   map == nullptr ? attributes : of_repaired(attributes, *map, differing)),
        kept->vertices, kept->faces);
  };
  return made;
}

void give(const plugin::Outputs& outputs, const MeshLists& lists) {
  talweg_mesh mesh = {};
  mesh.positions = plugin::view(lists.points.empty() ? nullptr : lists.points.front().data(),
                                lists.points.size(), 3);
  mesh.triangles = plugin::view(lists.triangles.empty() ? nullptr : lists.triangles.front().data(),
                                lists.triangles.size(), 3);
  outputs.mesh(mesh);
}

}  // namespace talweg::plugins
