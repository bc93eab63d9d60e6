// Relinking in place is done whole or not at all.
#pragma once

#include "talweg/core/openmesh/property_carrying.hpp"
#include "talweg/core/openmesh/relinking.hpp"

namespace talweg {

/// Sets what the lists say. Nothing here can fail. O(what they list).
template <class Mesh>
void relink(Mesh& mesh, const Relinking& changes) noexcept {
  for (const auto& [h, v] : changes.heads) mesh.set_vertex_handle(h, v);
  for (const auto& [h, next] : changes.nexts) mesh.set_next_halfedge_handle(h, next);
  for (const auto& [h, f] : changes.faces) mesh.set_face_handle(h, f);
  for (const auto& [f, h] : changes.of_faces) mesh.set_halfedge_handle(f, h);
  for (const auto& [v, h] : changes.of_vertices) mesh.set_halfedge_handle(v, h);
}

/// Makes room, has `fill` give the new elements their values by a PropertyCarrier, and relinks.
/// Throws what making room and `fill` throw; the mesh is then as before.
template <class Mesh, class Fill>
void change(Mesh& mesh, const Relinking& changes, Fill fill) {
  PropertyCarrier<Mesh> properties(mesh, changes);
  try {
    mesh.resize(changes.after.vertices, changes.after.edges, changes.after.faces);
    properties.fill_new();
    fill(properties);
  } catch (...) {
    mesh.resize(changes.before.vertices, changes.before.edges, changes.before.faces);
    throw;
  }
  properties.change_old();
  relink(mesh, changes);
}

}  // namespace talweg
