// openmesh_decimate MESH CURVE RESULT [SHARE]: makes a smoothed curve edges of the mesh, locks
// them, and decimates all else to a twentieth of its faces (or another share). The curve stays, to
// the bit.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iterator>
#include <stdexcept>
#include <vector>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <talweg/openmesh.hpp>

namespace {

using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;  // of floats

Mesh read(const char* path) {
  Mesh mesh;
  if (!OpenMesh::IO::read_mesh(mesh, path))
    throw std::runtime_error("OpenMesh cannot read the mesh.");
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_halfedge_status();
  mesh.request_face_status();
  return mesh;
}

/// The smoothed curves of a file as chains of edges of the mesh, which are marked `feature`.
talweg::Embedding embed(Mesh& mesh, const char* path) {
  talweg::OpenMeshIds ids;
  const auto opened = talweg::open_mesh(mesh, &ids);
  std::vector<talweg::SurfaceCurve> drawn;
  talweg::StraightLines lines(opened->surface());
  for (const talweg::SnappedCurve& curve :
       talweg::snap(opened->mesh(), talweg::read_curves(path))) {
    drawn.push_back(lines.join(curve.points, curve.closed));
  }
  talweg::CurveSmoother smoother(opened);
  smoother.set_curves(drawn);
  const auto result = smoother.smooth(1.0);
  talweg::EmbedOptions options;
  options.marks.feature = true;
  return talweg::embed_curves(mesh, opened->mesh(), ids, result.curves, options);
}

void decimate(Mesh& mesh, double share) {
  const auto wanted = static_cast<std::size_t>(share * static_cast<double>(mesh.n_faces()));
  OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
  OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
  decimater.add(quadric);
  decimater.initialize();
  decimater.decimate_to_faces(0, wanted);  // leaves locked vertices alone
}

void run(const char* path, const char* curve, const char* result, double share) {
  Mesh mesh = read(path);
  const talweg::Embedding embedding = embed(mesh, curve);
  std::vector<Mesh::Point> before;
  for (const auto& chain : embedding.chains) {
    for (const auto h : chain) {
      for (const auto v : {mesh.from_vertex_handle(h), mesh.to_vertex_handle(h)}) {
        mesh.status(v).set_locked(true);
        before.push_back(mesh.point(v));
      }
    }
  }
  const std::size_t faces = mesh.n_faces();
  decimate(mesh, share);

  std::size_t edges = 0, place = 0;
  for (const auto& chain : embedding.chains) {
    for (const auto h : chain) {  // handles stay valid until garbage is collected
      const bool there = !mesh.status(mesh.edge_handle(h)).deleted() &&
                         mesh.point(mesh.from_vertex_handle(h)) == before[place] &&
                         mesh.point(mesh.to_vertex_handle(h)) == before[place + 1];
      if (!there) throw std::runtime_error("An edge of the curve is gone.");
      ++edges;
      place += 2;
    }
  }
  mesh.garbage_collection();
  std::printf("%zu faces, now %zu; all %zu edges of the curve are there, to the bit\n", faces,
              mesh.n_faces(), edges);
  if (!OpenMesh::IO::write_mesh(mesh, result))
    throw std::runtime_error("The result is not written.");
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 4 || argc > 5)
    throw std::runtime_error("usage: openmesh_decimate MESH CURVE RESULT [SHARE]");
  run(argv[1], argv[2], argv[3], argc > 4 ? std::atof(argv[4]) : 0.05);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "openmesh_decimate: %s\n", error.what());
  return 1;
}
