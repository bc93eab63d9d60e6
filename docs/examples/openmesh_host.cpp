// A host with OpenMesh: openmesh_host MESH VERTEX VERTEX [TAU] draws a curve between two vertices
// of a mesh in single precision, smooths it, and tells where its points are.
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <talweg/loader/talweg_loader.h>
#include <talweg/plugin/talweg_host_openmesh.hpp>

namespace {

using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;  // of floats
using Instance = talweg::host::OpenMeshInstance<Mesh>;

const talweg_plugin& plugin_named(const char* id) {
  static const talweg_loader* const loader = talweg_loader_open(nullptr);
  const talweg_plugin* plugin = talweg_loader_find(loader, id);
  if (plugin == nullptr) throw std::runtime_error(std::string("There is no plugin ") + id + ".");
  return *plugin;
}

void run(int count, char** words) {
  if (count < 4) throw std::runtime_error("usage: openmesh_host MESH VERTEX VERTEX [TAU]");
  Mesh mesh;
  if (!OpenMesh::IO::read_mesh(mesh, words[1])) throw std::runtime_error("The mesh is not read.");
  const talweg::host::Services services("openmesh_host", "1");

  talweg::openmesh::Curve ends;
  for (int k : {2, 3}) {
    ends.points.push_back(
        {OpenMesh::VertexHandle(std::stoi(words[k])), OpenMesh::FaceHandle(), {}});
  }
  Instance draw(plugin_named("talweg.draw"), services);
  draw.set_mesh(mesh);
  draw.set_curves({ends});

  Instance smooth(plugin_named("talweg.smooth"), services);
  smooth.set_mesh(mesh);
  smooth.set_curves(draw.run().curves);
  smooth.set("tau", count > 4 ? std::stod(words[4]) : 1.0);
  const auto results = smooth.run({.vertex_fields = true});
  smooth.put_fields(results, mesh);

  const OpenMesh::VProp<double> distance(mesh, "distance");  // to the drawing
  for (const auto& point : results.curves.at(0).points) {
    const auto corners = talweg::openmesh::corners_of(mesh, point.face);
    std::printf("face %d, %g from the drawing at its corner %d\n", point.face.idx(),
                distance[corners[0]], corners[0].idx());
  }
}

}  // namespace

int main(int count, char** words) {
  try {
    run(count, words);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "openmesh_host: %s\n", error.what());
    return 1;
  }
}
