// A polygon soup has raw lists in the form of CGAL's Polygon_mesh_processing.
#pragma once

#include <array>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>

#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg::test {

/// The faces with three different existing vertices. Vertices have the numbers of the lists.
struct Soup {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  using Polygon = std::array<std::size_t, 3>;

  explicit Soup(const MeshLists& lists) {
    for (const Point& p : lists.points) points.emplace_back(p.x(), p.y(), p.z());
    for (std::size_t f = 0; f < lists.triangles.size(); ++f) {
      const Triangle& t = lists.triangles[f];
      const std::size_t n = points.size();
      if (t[0] >= n || t[1] >= n || t[2] >= n) continue;
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
      polygons.push_back({t[0], t[1], t[2]});
      face.push_back(f);
    }
  }

  [[nodiscard]] bool is_mesh() const {
    return CGAL::Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(polygons);
  }

  /// The result of orienting by CGAL.
  struct Oriented {
    bool succeeded = false;  ///< whether no vertex was added
    std::set<std::pair<std::size_t, std::size_t>> crowded_edges;
    std::set<std::size_t> singular_vertices;
    std::vector<bool> turned;  ///< per polygon
  };
  Oriented orient() {
    Oriented result;
    result.turned.assign(polygons.size(), false);
    Visitor visitor;
    visitor.seen = &result;
    result.succeeded = CGAL::Polygon_mesh_processing::orient_polygon_soup(
        points, polygons, CGAL::parameters::visitor(visitor));
    return result;
  }

  /// The mesh of a soup that is a mesh; face i is polygon i.
  [[nodiscard]] Mesh mesh() const {
    Mesh result;
    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, polygons, result);
    return result;
  }

  std::vector<Kernel::Point_3> points;
  std::vector<Polygon> polygons;
  std::vector<std::size_t> face;  ///< per polygon, its face in the lists

 private:
  struct Visitor : CGAL::Polygon_mesh_processing::Default_orientation_visitor {
    Oriented* seen = nullptr;
    void non_manifold_edge(std::size_t a, std::size_t b, std::size_t /*faces*/) {
      seen->crowded_edges.insert(std::minmax(a, b));
    }
    void non_manifold_vertex(std::size_t v, std::size_t /*fans*/) {
      seen->singular_vertices.insert(v);
    }
    void polygon_orientation_reversed(std::size_t f) { seen->turned[f] = !seen->turned[f]; }
  };
};

}  // namespace talweg::test
