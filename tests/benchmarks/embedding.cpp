// talweg-embedding: times of embedding curves as edges of an OpenMesh mesh, compared with
// operations of OpenMesh.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "talweg/core/drawing/edge_dijkstra.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/core/openmesh/embed_curves.hpp"
#include "talweg/core/openmesh/openmesh_changes.hpp"
#include "talweg/core/openmesh/split_along.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg::benchmarks {
namespace {

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
  VertexAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Normal);
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge | OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Normal);
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

Mesh mesh_of(const MeshLists& lists) {
  Mesh mesh;
  mesh.reserve(lists.points.size(), lists.points.size() + lists.triangles.size(),
               lists.triangles.size());
  for (const Point& p : lists.points) mesh.add_vertex(OpenMesh::Vec3d(p.x(), p.y(), p.z()));
  for (const Triangle& t : lists.triangles) {
    mesh.add_face(mesh.vertex_handle(t[0]), mesh.vertex_handle(t[1]), mesh.vertex_handle(t[2]));
  }
  return mesh;
}

/// A smoothed curve around the largest of a mesh's coordinates, as many edges of it.
SurfaceCurve curve_on(const std::shared_ptr<const OpenedMesh>& opened, std::size_t edges) {
  const SurfaceMesh& mesh = opened->mesh();
  const auto extreme = [&](int axis, double sign) {
    VertexId found{0};
    for (std::size_t v = 1; v < mesh.points().size(); ++v) {
      if (sign * mesh.points()[v][axis] > sign * mesh.point(found)[axis]) found = VertexId{v};
    }
    return found;
  };
  const std::vector<VertexId> way{extreme(0, -1), extreme(1, -1), extreme(0, 1), extreme(1, 1)};
  SurfaceCurve drawn{true, {}};
  for (const VertexId v : draw_edge_path(mesh.surface(), way, true)) {
    drawn.points.push_back(SurfacePoint::at_vertex(mesh.surface(), v));
  }
  SurfaceCurve curve = smooth_curve(opened, drawn, {}).curve();
  if (curve.points.size() > edges + 1) {
    curve.points.erase(curve.points.begin() + static_cast<std::ptrdiff_t>(edges) + 1,
                       curve.points.end());
    curve.closed = false;
  }
  return curve;
}

/// The median time of several runs, each on a mesh that is made ready before.
double median(int runs, const std::function<void()>& prepare, const std::function<void()>& run) {
  std::vector<double> times;
  for (int k = 0; k < runs; ++k) {
    prepare();
    const Stopwatch watch;
    run();
    times.push_back(watch.ms());
  }
  std::nth_element(times.begin(), times.begin() + runs / 2, times.end());
  return times[static_cast<std::size_t>(runs) / 2];
}

int run(const char* path) {
  constexpr int kRuns = 9;
  const Mesh original = mesh_of(read_mesh(path));
  OpenMeshIds ids;
  const Stopwatch opening;
  const auto opened = open_mesh(original, &ids);
  std::printf("%zu faces, opened in %.0f ms\n", original.n_faces(), opening.ms());
  std::uint64_t stamp = 0;
  std::printf("stamp_of                             %7.2f ms\n",
              median(
                  kRuns, [] {},
                  [&] {
                    const OpenMeshStamp now = stamp_of(original);
                    stamp ^= now.points ^ now.connectivity;
                  }));
  std::printf("reopen                               %7.2f ms%s\n",
              median(
                  kRuns, [] {}, [&] { reopen(original, ids, *opened); }),
              stamp == 1 ? " " : "");  // so that nothing is left out
  const SurfaceCurve curve = curve_on(opened, 2000);
  const std::span<const SurfaceCurve> curves(&curve, 1);

  Mesh mesh;
  Embedding made;
  const auto embed = [&] { made = embed_curves(mesh, opened->mesh(), ids, curves); };
  const auto copy = [&] { mesh = original; };
  const auto copy_with_room = [&] {
    mesh = original;
    const std::size_t more = 20000;
    mesh.reserve(mesh.n_vertices() + more, mesh.n_edges() + more, mesh.n_faces() + more);
  };
  const double with_room = median(kRuns, copy_with_room, embed);
  const double without = median(kRuns, copy, embed);
  std::printf("embed_curves, %zu edges, %zu new vertices, %zu new faces\n", made.chains[0].size(),
              made.vertices.size(), made.faces.size());
  std::printf("  its plan alone                     %7.2f ms\n",
              median(
                  kRuns, [] {}, [&] { plan_cut(opened->mesh(), curves); }));
  std::printf("  where the mesh's lists have room   %7.2f ms\n", with_room);
  std::printf("  where they are full and must grow  %7.2f ms\n", without);
  double area = 0;
  std::printf("a loop over the faces for the area   %7.2f ms\n", median(kRuns, copy, [&] {
                for (const auto f : mesh.faces()) area += mesh.calc_face_area(f);
              }));
  std::printf("garbage_collection() of one face     %7.2f ms\n",
              median(
                  kRuns,
                  [&] {
                    mesh = original;
                    mesh.delete_face(mesh.face_handle(0), true);
                  },
                  [&] { mesh.garbage_collection(); }));
  mesh = original;
  const HandleChain chain = embed_curves(mesh, opened->mesh(), ids, curves).chains[0];
  const Mesh embedded = mesh;
  const std::span<const HandleChain> chains(&chain, 1);
  std::printf("open_seam                            %7.2f ms\n",
              median(
                  kRuns,
                  [&] {
                    mesh = embedded;
                    const std::size_t more = 20000;
                    mesh.reserve(mesh.n_vertices() + more, mesh.n_edges() + more, mesh.n_faces());
                  },
                  [&] { open_seam(mesh, chains); }));
  std::printf("sides_of                             %7.2f ms\n",
              median(
                  kRuns, [] {}, [&] { static_cast<void>(sides_of(embedded, chains)); }));
  std::size_t parts = 0;
  const double split = median(
      kRuns, [] {}, [&] { parts = split_along(embedded, chains).size(); });
  std::printf("split_along into %-4zu               %8.2f ms\n", parts, split);
  return area > 0 ? 0 : 1;
}

}  // namespace
}  // namespace talweg::benchmarks

int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "usage: talweg-embedding MESH\n");
    return 1;
  }
  try {
    return talweg::benchmarks::run(arguments[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "talweg-embedding: %s\n", error.what());
    return 2;
  }
}
