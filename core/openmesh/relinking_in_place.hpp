// Relinking in place changes a mesh completely or, after an exception, not at all.
#pragma once

#include "talweg/core/openmesh/property_carrying.hpp"
#include "talweg/core/openmesh/relinking.hpp"

namespace talweg {

/// Sets the links in the lists. Cannot fail. O(length of the lists).
template <class Mesh>
void relink(Mesh& mesh, const Relinking& changes) noexcept {
  for (const auto& [h, v] : changes.heads) mesh.set_vertex_handle(h, v);
  for (const auto& [h, next] : changes.nexts) mesh.set_next_halfedge_handle(h, next);
  for (const auto& [h, f] : changes.faces) mesh.set_face_handle(h, f);
  for (const auto& [f, h] : changes.of_faces) mesh.set_halfedge_handle(f, h);
  for (const auto& [v, h] : changes.of_vertices) mesh.set_halfedge_handle(v, h);
}

/// Resizes the mesh, fills the properties of new elements, calls `fill` with the PropertyCarrier
/// for more of them, and relinks. An exception from resizing, copying or `fill` leaves the mesh
/// unchanged.
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
