// talweg-openmesh-writer MESH FOLDER writes the mesh by OpenMesh in all its formats, encodings and
// byte orders.
#include <cstdio>
#include <string>
#include <utility>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

namespace {

using Options = OpenMesh::IO::Options;

struct DoublePoints : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};

constexpr int kText = Options::Default;
constexpr int kBinary = Options::Binary;
constexpr int kBig = Options::Binary | Options::MSB;
constexpr std::pair<const char*, int> kFiles[] = {
    {"openmesh.om", kBinary},   {"openmesh-big.om", kBig}, {"openmesh.ply", kBinary},
    {"openmesh-big.ply", kBig}, {"openmesh.off", kBinary}, {"openmesh-text.off", kText},
    {"openmesh.obj", kText},    {"openmesh.stl", kBinary}, {"openmesh-text.stl", kText},
};

}  // namespace

int main(int argc, char** argv) {
  OpenMesh::TriMesh_ArrayKernelT<DoublePoints> mesh;
  if (argc != 3 || !OpenMesh::IO::read_mesh(mesh, argv[1])) {
    std::fputs("usage: talweg-openmesh-writer MESH FOLDER\n", stderr);
    return 1;
  }
  for (const auto& [name, options] : kFiles) {
    if (OpenMesh::IO::write_mesh(mesh, argv[2] + std::string("/") + name, options)) continue;
    std::fprintf(stderr, "OpenMesh did not write %s.\n", name);
    return 1;
  }
  return 0;
}
