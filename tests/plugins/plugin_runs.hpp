// A plugin run is made as a host in C++ does it, on meshes and drawings of the library.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/jagged_curves.hpp"
#include "places.hpp"
#include "talweg/core/drawing/placed_curve.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"
#include "talweg/loader/talweg_loader.h"
#include "talweg/plugin/talweg_host.hpp"

namespace talweg::test {

struct CloseLoader {
  void operator()(talweg_loader* loader) const { talweg_loader_close(loader); }
};
using Loader = std::unique_ptr<talweg_loader, CloseLoader>;

/// The plugins of this build.
inline Loader open_loader() { return Loader(talweg_loader_open(plugin_folder())); }

/// A plugin of this build. It stays loaded until the program ends.
inline const talweg_plugin& plugin_of_this_build(const char* id) {
  static const Loader loader = open_loader();
  const talweg_plugin* plugin = talweg_loader_find(loader.get(), id);
  if (plugin == nullptr) throw std::runtime_error(std::string("no plugin ") + id);
  return *plugin;
}

inline host::Curve as_host_curve(const SurfaceMesh& mesh, const SurfaceCurve& curve) {
  const PlacedCurve placed = place(mesh, curve);
  host::Curve result;
  result.closed = curve.closed;
  for (const FaceCoordinates& at : placed.faces) {
    result.faces.push_back(static_cast<std::uint32_t>(at.face.index()));
    result.barycentrics.push_back(at.barycentric);
  }
  return result;
}

inline void set_mesh(host::Instance& instance, const MeshLists& lists) {
  instance.set_mesh(host::view(lists.points.front().data(), lists.points.size(), 3),
                    host::view(lists.triangles.front().data(), lists.triangles.size(), 3));
}

/// Hills, and a jagged drawing across them.
struct Subject {
  MeshLists lists = hills(40);
  std::shared_ptr<const OpenedMesh> opened = OpenedMesh::open(lists);
  SurfaceCurve drawn = wave_on_hills(opened->mesh());
  host::Curve curve = as_host_curve(opened->mesh(), drawn);
};

/// Equal to the last bit.
inline bool same_bits(const host::Curve& a, const PlacedCurve& b) {
  if (a.closed != b.closed || a.faces.size() != b.faces.size()) return false;
  for (std::size_t k = 0; k < a.faces.size(); ++k) {
    const bool at_vertex = b.vertices[k].valid();
    if (at_vertex ? a.vertices[k] != b.vertices[k].index() : a.vertices[k] != TALWEG_NO_VERTEX) {
      return false;
    }
    if (a.faces[k] != b.faces[k].face.index() || a.barycentrics[k] != b.faces[k].barycentric) {
      return false;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      if (a.positions[k][i] != b.positions[k][static_cast<Eigen::Index>(i)]) return false;
    }
  }
  return true;
}

inline bool same_bits(const host::Curve& a, const host::Curve& b) {
  return a.closed == b.closed && a.vertices == b.vertices && a.faces == b.faces &&
         a.barycentrics == b.barycentrics && a.positions == b.positions;
}

}  // namespace talweg::test
