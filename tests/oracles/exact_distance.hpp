// CGAL's exact geodesics (Chen & Han, with the filter of Xin & Wang) behind Talweg's types.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include "talweg/core/mesh/mesh_lists.hpp"
#include "talweg/intrinsic/surface/ids.hpp"

namespace talweg::test {

/// Exact distances and shortest paths on a polyhedral surface. Vertices have the numbers of the
/// lists.
class ExactGeodesics {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
  using ShortestPath = CGAL::Surface_mesh_shortest_path<Traits>;
  using Halfedge = Mesh::Halfedge_index;

 public:
  explicit ExactGeodesics(const MeshLists& lists) : mesh_(mesh_of(lists)), paths_(mesh_) {}
  ExactGeodesics(const ExactGeodesics&) = delete;
  ExactGeodesics& operator=(const ExactGeodesics&) = delete;

  void add_source(VertexId v) { paths_.add_source_point(vertex(v)); }

  /// Adds a source between two neighbours, at fraction t from the first. On the boundary the source
  /// lies slightly inside the face, because CGAL 5.5 takes a source on a boundary edge for its
  /// mirror image.
  void add_source(VertexId a, VertexId b, double t) {
    Halfedge h = mesh_.halfedge(vertex(a), vertex(b));
    if (mesh_.is_border(h)) {
      h = mesh_.opposite(h);
      t = 1 - t;
    }
    // The barycentrics of a face begin at the source of its own halfedge.
    constexpr double kHair = 1e-9;
    const Mesh::Face_index face = mesh_.face(h);
    std::array<double, 3> barycentric{};
    Halfedge side = mesh_.halfedge(face);
    for (std::size_t k = 0; k < 3; ++k, side = mesh_.next(side)) {
      if (side != h) continue;
      barycentric[k] = (1 - t) * (1 - kHair);
      barycentric[(k + 1) % 3] = t * (1 - kHair);
      barycentric[(k + 2) % 3] = kHair;
    }
    paths_.add_source_point(face, {{barycentric[0], barycentric[1], barycentric[2]}});
  }

  void clear_sources() { paths_.remove_all_source_points(); }

  double distance(VertexId v) { return paths_.shortest_distance_to_source_points(vertex(v)).first; }

  /// The distance of a point with these weights of the corners of a face.
  double distance(FaceId f, const std::array<VertexId, 3>& corners,
                  const std::array<double, 3>& weights) {
    const Mesh::Face_index face(static_cast<Mesh::size_type>(f.index()));
    Traits::Barycentric_coordinates at{{0, 0, 0}};
    Halfedge side = mesh_.halfedge(face);
    for (std::size_t k = 0; k < 3; ++k, side = mesh_.next(side)) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (vertex(corners[i]) == mesh_.source(side)) at[k] = weights[i];
      }
    }
    return paths_.shortest_distance_to_source_points(face, at).first;
  }

  /// A place of a shortest path: a vertex, or an edge by its two ends, the left end first.
  struct Passage {
    VertexId left, right;  ///< equal at a vertex
    double from_left = 0;  ///< fraction of the edge, in [0, 1]
  };
  std::vector<Passage> path_from(VertexId v) {
    Recorder recorder{&mesh_, {}};
    paths_.shortest_path_sequence_to_source_points(vertex(v), recorder);
    return recorder.passages;
  }

 private:
  struct Recorder {
    const Mesh* mesh;
    std::vector<Passage> passages;
    static VertexId id(Mesh::Vertex_index v) { return VertexId{static_cast<std::uint32_t>(v)}; }
    void operator()(Halfedge h, Kernel::FT from_source) {
      // The path leaves the face of h across h, so the source of h is on the right.
      passages.push_back({id(mesh->target(h)), id(mesh->source(h)), 1 - from_source});
    }
    void operator()(Mesh::Vertex_index v) { passages.push_back({id(v), id(v), 0}); }
    void operator()(Mesh::Face_index, const Traits::Barycentric_coordinates&) {}
  };

  static Mesh::Vertex_index vertex(VertexId v) {
    return Mesh::Vertex_index(static_cast<Mesh::size_type>(v.index()));
  }
  static Mesh mesh_of(const MeshLists& lists) {
    Mesh mesh;
    for (const Point& p : lists.points) mesh.add_vertex({p.x(), p.y(), p.z()});
    for (const Triangle& t : lists.triangles) {
      mesh.add_face(vertex(VertexId{t[0]}), vertex(VertexId{t[1]}), vertex(VertexId{t[2]}));
    }
    return mesh;
  }

  Mesh mesh_;
  ShortestPath paths_;
};

}  // namespace talweg::test
