// openmesh_borders MESH LABELS RESULTS: smooths the borders of a segmentation, a number per face,
// makes them edges of the mesh, and writes RESULTS-LABEL.obj for each region, subdivided with
// Loop's scheme.
#include <cstdio>
#include <exception>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <talweg/openmesh.hpp>

namespace {

using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;  // of floats

Mesh read(const char* path) {
  Mesh mesh;
  if (!OpenMesh::IO::read_mesh(mesh, path))
    throw std::runtime_error("OpenMesh cannot read the mesh.");
  return mesh;
}

/// A property, as a tool has its labels.
OpenMesh::FProp<int> read_labels(Mesh& mesh, const char* path) {
  auto label = OpenMesh::getOrMakeProperty<OpenMesh::FaceHandle, int>(mesh, "label");
  std::ifstream file(path);
  for (const auto f : mesh.faces()) {
    if (!(file >> label[f])) throw std::runtime_error("There is not a label for each face.");
  }
  return label;
}

/// The smoothed borders, as edges of the mesh. What lies between them has the label of its side.
talweg::Embedding embed_borders(Mesh& mesh, OpenMesh::FProp<int>& label) {
  talweg::OpenMeshIds ids;
  const auto opened = talweg::open_mesh(mesh, &ids);
  const auto network = talweg::smooth_labels(opened, talweg::labels_of(ids, label));
  std::vector<talweg::SurfaceCurve> borders;
  for (const talweg::SmoothedBorder& border : network.borders) {
    borders.push_back(border.border.curve);
  }
  talweg::Embedding embedding = talweg::embed_curves(mesh, opened->mesh(), ids, borders);

  const talweg::CurveSides sides = talweg::sides_of(mesh, embedding.chains);
  std::map<int, int> label_of;  // by piece
  for (std::size_t c = 0; c < borders.size(); ++c) {
    const auto& [left, right] = network.borders[c].border.labels;
    for (const int piece : sides.left[c]) label_of[piece] = static_cast<int>(left);
    for (const int piece : sides.right[c]) label_of[piece] = static_cast<int>(right);
  }
  for (const auto f : mesh.faces()) {
    const auto found = label_of.find(sides.piece_of[static_cast<std::size_t>(f.idx())]);
    if (found != label_of.end()) label[f] = found->second;
  }
  return embedding;
}

void run(const char* path, const char* labels, const std::string& results) {
  Mesh mesh = read(path);
  auto label = read_labels(mesh, labels);
  const talweg::Embedding embedding = embed_borders(mesh, label);
  std::map<int, int> parts;  // of each label
  for (Mesh& region : talweg::split_along(mesh, embedding.chains)) {
    const OpenMesh::FProp<int> own(region, "label");
    const int number = own[region.face_handle(0)];
    OpenMesh::Subdivider::Uniform::LoopT<Mesh> loop;
    loop.attach(region);
    loop(1);
    loop.detach();
    const int part = parts[number]++;
    const std::string name = results + "-" + std::to_string(number) +
                             (part == 0 ? "" : "-" + std::to_string(part)) + ".obj";
    if (!OpenMesh::IO::write_mesh(region, name))
      throw std::runtime_error(name + " is not written.");
    std::printf("%s: %zu faces\n", name.c_str(), region.n_faces());
  }
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 4) throw std::runtime_error("usage: openmesh_borders MESH LABELS RESULTS");
  run(argv[1], argv[2], argv[3]);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "openmesh_borders: %s\n", error.what());
  return 1;
}
