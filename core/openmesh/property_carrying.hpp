// Property carrying copies the properties of old elements to the new elements of a divided mesh.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "talweg/core/openmesh/division_plan.hpp"
#include "talweg/core/openmesh/property_mixing.hpp"
#include "talweg/core/openmesh/relinking.hpp"

namespace talweg {

/// Writes to new elements first, which may throw, and to old elements last, which cannot throw. Old
/// elements change where a halfedge gets a new head: its values belong to the corner there.
/// O(changed elements) for each property.
template <class Mesh>
class PropertyCarrier {
 public:
  PropertyCarrier(Mesh& mesh, const Relinking& changes) : mesh_(mesh), changes_(changes) {}

  /// Fills the new elements except new vertices of the plan; the mesh must have been resized.
  /// Throws any exception from copying a property.
  void fill_new() {
    for (const auto& [from, to] : changes_.copies) mesh_.copy_all_properties(from, to, true);
    for (const auto& [from, to] : changes_.halves) {
      mesh_.copy_all_properties(from, to, true);
      for (const unsigned side : {0U, 1U}) {
        mesh_.copy_all_properties(mesh_.halfedge_handle(from, side),
                                  mesh_.halfedge_handle(to, side), true);
      }
    }
    for (const auto& [from, to] : changes_.inner) mesh_.copy_all_properties(from, to, false);
    for (const auto& [from, to] : changes_.face_parts) mesh_.copy_all_properties(from, to, true);
    each_mixed_of_halfedges(mesh_,
                            [&](auto& values, Mixing mixing) { mix_corners(values, mixing); });
  }
  /// Fills the new vertices on edges and in faces; the same conditions hold.
  void fill_vertices(const DivisionPlan& plan) {
    for (std::size_t k = 0; k < changes_.vertices.size(); ++k) {
      fill_vertex(changes_.vertices[k], plan.positions[k]);
    }
  }
  /// Changes the values at corners of old halfedges that get a new head.
  void change_old() noexcept {
    for (const auto& change : later_) change();
  }

 private:
  using Status = OpenMesh::Attributes::StatusInfo;

  void fill_vertex(const Relinking::Mixed& mixed, const std::array<double, 3>& position) {
    std::array<int, 3> from{};
    std::size_t nearest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      from[k] = mixed.from[k].idx();
      if (mixed.weights[k] > mixed.weights[nearest]) nearest = k;
    }
    mesh_.copy_all_properties(mixed.from[nearest], mixed.vertex, true);
    if (mesh_.has_vertex_status()) {
      Status& status = mesh_.status(mixed.vertex);
      for (const auto v : mixed.from) {
        if (v.is_valid()) status.set_bits(status.bits() & mesh_.status(v).bits());
      }
    }
    each_mixed_of_vertices(mesh_, [&](auto& values, Mixing mixing) {
      using Value = std::decay_t<decltype(values[0])>;
      values[mixed.vertex.idx()] = mixed_value<Value>(values, from, mixed.weights, mixing);
    });
    mesh_.set_point(mixed.vertex, stored_point<Mesh>(position));
  }
  template <class Values>
  void mix_corners(Values& values, Mixing mixing) {
    using Value = std::decay_t<decltype(values[0])>;
    for (const Relinking::Corner& corner : changes_.corners) {
      const std::array<int, 3> from{corner.from[0].idx(), corner.from[1].idx(),
                                    corner.from[2].idx()};
      const auto value = mixed_value<Value>(values, from, corner.weights, mixing);
      const int h = corner.halfedge.idx();
      if (static_cast<std::size_t>(h) >= 2 * changes_.before.edges) {
        values[h] = value;
      } else {
        later_.push_back([&values, h, value] { values[h] = value; });
      }
    }
  }

  Mesh& mesh_;
  const Relinking& changes_;
  std::vector<std::function<void()>> later_;
};

}  // namespace talweg
