// talweg-readers MESH [FILE...]: how long reading one mesh takes in each format, here and in other
// libraries; and in the files of the same mesh that other programs have written.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <fmt/format.h>
#include <unistd.h>
#ifdef TALWEG_HAS_CGAL
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>
#endif
#ifdef TALWEG_HAS_ASSIMP
#include <assimp/Importer.hpp>
#include <assimp/scene.h>
#endif
#ifdef TALWEG_HAS_TINYOBJ
#include <tiny_obj_loader.h>
#endif

#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/core/io/mesh_writer.hpp"

namespace talweg::benchmarks {
namespace {

namespace fs = std::filesystem;

struct DoublePoints : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};

/// Reads a file and returns the number of its faces, 0 on an error.
struct Reader {
  const char* name;
  std::function<std::size_t(const std::string&)> faces;
};

std::vector<Reader> readers() {
  std::vector<Reader> all;
  all.push_back(
      {"Talweg", [](const std::string& file) { return read_mesh(file).triangles.size(); }});
  all.push_back({"OpenMesh", [](const std::string& file) -> std::size_t {
                   OpenMesh::TriMesh_ArrayKernelT<DoublePoints> mesh;
                   OpenMesh::IO::Options options = OpenMesh::IO::Options::Default;
                   return OpenMesh::IO::read_mesh(mesh, file, options) ? mesh.n_faces() : 0;
                 }});
#ifdef TALWEG_HAS_CGAL
  all.push_back({"CGAL, soup", [](const std::string& file) -> std::size_t {
                   std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
                   std::vector<std::vector<std::size_t>> polygons;
                   return CGAL::IO::read_polygon_soup(file, points, polygons) ? polygons.size() : 0;
                 }});
#endif
#ifdef TALWEG_HAS_ASSIMP
  all.push_back({"Assimp", [](const std::string& file) -> std::size_t {
                   Assimp::Importer importer;
                   const aiScene* scene = importer.ReadFile(file, 0);
                   return scene != nullptr && scene->mNumMeshes > 0 ? scene->mMeshes[0]->mNumFaces
                                                                    : 0;
                 }});
#endif
#ifdef TALWEG_HAS_TINYOBJ
  all.push_back({"tinyobjloader", [](const std::string& file) -> std::size_t {
                   if (!file.ends_with(".obj")) return 0;
                   tinyobj::ObjReader reader;
                   return reader.ParseFromFile(file) && !reader.GetShapes().empty()
                              ? reader.GetShapes()[0].mesh.num_face_vertices.size()
                              : 0;
                 }});
#endif
  return all;
}

void write_text_ply(const fs::path& file, const MeshLists& lists) {
  std::string text = fmt::format(
      "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\n"
      "property double z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
      lists.points.size(), lists.triangles.size());
  const auto out = std::back_inserter(text);
  for (const Point& p : lists.points) fmt::format_to(out, "{} {} {}\n", p.x(), p.y(), p.z());
  for (const Triangle& t : lists.triangles) fmt::format_to(out, "3 {} {} {}\n", t[0], t[1], t[2]);
  std::ofstream(file, std::ios::binary) << text;
}

void write_text_stl(const fs::path& file, const MeshLists& lists) {
  std::string text = "solid mesh\n";
  const auto out = std::back_inserter(text);
  for (const Triangle& t : lists.triangles) {
    text += " facet normal 0 0 0\n  outer loop\n";
    for (const std::uint32_t v : t) {
      const Eigen::Vector3f p = lists.points[v].cast<float>();
      fmt::format_to(out, "   vertex {} {} {}\n", p.x(), p.y(), p.z());
    }
    text += "  endloop\n endfacet\n";
  }
  std::ofstream(file, std::ios::binary) << text << "endsolid mesh\n";
}

/// The shortest of five times of the processor, in ms; "-" where the reader cannot read it.
std::string time_of(const Reader& reader, const std::string& file, std::size_t faces) {
  double best = 0;
  for (int k = 0; k < 5; ++k) {
    const std::clock_t begin = std::clock();
    std::size_t found = 0;
    try {
      found = reader.faces(file);
    } catch (const std::exception&) {
    }
    const double ms = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    if (found != faces) return "-";
    best = k == 0 ? ms : std::min(best, ms);
  }
  return fmt::format("{:.0f}", best);
}

/// A line of the table.
void print_row(const std::string& name, const fs::path& file, const std::vector<Reader>& all,
               std::size_t faces) {
  fmt::print("\n| {} |", name);
  for (const Reader& reader : all) {
    fmt::print(" {} |", time_of(reader, file.string(), faces));
    std::fflush(stdout);
  }
}

void run(const fs::path& mesh, const std::vector<fs::path>& others) {
  const fs::path folder = fs::temp_directory_path() / fmt::format("talweg-readers-{}", getpid());
  fs::create_directory(folder);
  const MeshLists lists = read_mesh(mesh);
  const std::vector<std::pair<const char*, const char*>> formats = {
      {"PLY, binary", "binary.ply"}, {"PLY, text", "text.ply"},     {"OBJ", "mesh.obj"},
      {"OFF", "mesh.off"},           {"STL, binary", "binary.stl"}, {"STL, text", "text.stl"}};
  for (const char* name : {"binary.ply", "mesh.obj", "mesh.off", "binary.stl"}) {
    write_mesh(folder / name, lists);
  }
  write_text_ply(folder / "text.ply", lists);
  write_text_stl(folder / "text.stl", lists);
  const std::vector<Reader> all = readers();
  fmt::print("| ms, {} faces |", lists.triangles.size());
  for (const Reader& reader : all) fmt::print(" {} |", reader.name);
  fmt::print("\n|---|");
  for (std::size_t i = 0; i < all.size(); ++i) fmt::print("--:|");
  const std::size_t faces = lists.triangles.size();
  for (const auto& [format, file] : formats) print_row(format, folder / file, all, faces);
  for (const fs::path& file : others) print_row(file.filename().string(), file, all, faces);
  fmt::print("\n");
  fs::remove_all(folder);
}

}  // namespace
}  // namespace talweg::benchmarks

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fputs("usage: talweg-readers MESH [FILE...]\n", stderr);
    return 1;
  }
  try {
    talweg::benchmarks::run(argv[1], {argv + 2, argv + argc});
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "talweg-readers: %s\n", error.what());
    return 2;
  }
}
