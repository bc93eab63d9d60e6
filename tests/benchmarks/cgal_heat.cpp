#include "cgal_heat.hpp"

#include <optional>

#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace talweg::benchmarks {

struct CgalHeat::Impl {
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  using Mesh = CGAL::Surface_mesh<Point>;
  using Method = CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<
      Mesh, CGAL::Heat_method_3::Intrinsic_Delaunay>;
  Mesh mesh;
  std::optional<Method> method;
};

CgalHeat::CgalHeat(const MeshLists& lists) : impl_(std::make_unique<Impl>()) {
  for (const auto& p : lists.points) impl_->mesh.add_vertex({p[0], p[1], p[2]});
  using Vertex = Impl::Mesh::Vertex_index;
  for (const auto& [a, b, c] : lists.triangles) {
    impl_->mesh.add_face(Vertex(a), Vertex(b), Vertex(c));
  }
}

CgalHeat::~CgalHeat() = default;

void CgalHeat::open() {
  impl_->method.reset();
  impl_->method.emplace(impl_->mesh);
}

std::vector<double> CgalHeat::solve(std::span<const std::uint32_t> sources) {
  Impl::Method& method = *impl_->method;
  method.clear_sources();
  for (const std::uint32_t v : sources) method.add_source(Impl::Mesh::Vertex_index(v));
  auto distance = impl_->mesh.add_property_map<Impl::Mesh::Vertex_index, double>("v:d", 0).first;
  method.estimate_geodesic_distances(distance);
  std::vector<double> result(impl_->mesh.number_of_vertices());
  for (const auto v : impl_->mesh.vertices()) result[v] = distance[v];
  return result;
}

}  // namespace talweg::benchmarks
