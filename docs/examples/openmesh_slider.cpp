// openmesh_slider MESH FROM TO RESULT.om: a slider. The mesh is opened once; each line of the
// standard input is a tau. The last curve becomes edges of the mesh, with its number in "curve".
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <vector>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <talweg/openmesh.hpp>

int main(int argc, char** argv) try {
  if (argc != 5) throw std::runtime_error("usage: openmesh_slider MESH FROM TO RESULT.om < TAUS");
  OpenMesh::TriMesh_ArrayKernelT<> mesh;
  if (!OpenMesh::IO::read_mesh(mesh, argv[1])) throw std::runtime_error("The mesh is not read.");

  talweg::OpenMeshIds ids;
  const auto opened = talweg::open_mesh(mesh, &ids);
  const std::vector<talweg::VertexId> ends = {ids.id(OpenMesh::VertexHandle(std::atoi(argv[2]))),
                                              ids.id(OpenMesh::VertexHandle(std::atoi(argv[3])))};
  talweg::CurveSmoother smoother(opened);
  smoother.set_curve(
      talweg::curve_through(opened->surface(), talweg::draw_edge_path(opened->surface(), ends)));
  std::vector<talweg::SurfaceCurve> curves;
  for (double tau = 0; std::scanf("%lf", &tau) == 1;) {  // as often as somebody moves it
    const talweg::SmoothingResult result = smoother.smooth(tau);
    std::printf("tau %g: %g long, off the drawing by %g at most\n", tau,
                result.report().after.length, result.report().deviation_from_drawn_max);
    curves = result.curves;
  }

  talweg::EmbedOptions options;
  mesh.add_property(options.marks.curve, "curve");
  mesh.property(options.marks.curve).set_persistent(true);
  for (const auto e : mesh.edges()) mesh.property(options.marks.curve, e) = -1;
  talweg::embed_curves(mesh, opened->mesh(), ids, curves, options);
  if (!OpenMesh::IO::write_mesh(mesh, argv[4])) throw std::runtime_error("Nothing is written.");
} catch (const std::exception& error) {
  std::fprintf(stderr, "openmesh_slider: %s\n", error.what());
  return 1;
}
