// Reference curves on real meshes; tests are skipped without the meshes (TALWEG_MESHES).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "places.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"

namespace talweg::test {

/// The folder of the real meshes; the reference data lie beside it.
inline std::filesystem::path mesh_folder() {
  if (const char* given = std::getenv("TALWEG_MESHES")) return given;
  return std::filesystem::path(source_folder()).parent_path() / "shared" / "meshes";
}
inline std::filesystem::path reference_folder() {
  return (mesh_folder() / "..").lexically_normal() / "reference";
}
/// The message of a skipped test.
inline std::string missing(const std::string& name) {
  return "skipped: no " + name + " in " + mesh_folder().string() +
         " or its ../reference (set TALWEG_MESHES)";
}

/// A little-endian binary PLY of float or double points and `uchar int` triangles.
inline MeshLists read_reference_mesh(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::size_t vertices = 0;
  std::size_t faces = 0;
  bool wide = false;
  for (std::string line; std::getline(in, line) && line.rfind("end_header", 0) != 0;) {
    std::istringstream words(line);
    std::string first;
    std::string second;
    words >> first >> second;
    if (second == "vertex") words >> vertices;
    if (second == "face") words >> faces;
    if (first == "property" && second == "double") wide = true;
  }
  MeshLists lists;
  lists.points.resize(vertices);
  for (Point& p : lists.points) {
    for (int k = 0; k < 3; ++k) {
      float narrow = 0;
      if (wide) {
        in.read(reinterpret_cast<char*>(&p[k]), sizeof(double));
      } else {
        in.read(reinterpret_cast<char*>(&narrow), sizeof(float));
        p[k] = narrow;
      }
    }
  }
  lists.triangles.resize(faces);
  for (Triangle& t : lists.triangles) {
    in.get();
    in.read(reinterpret_cast<char*>(t.data()), sizeof(t));
  }
  return lists;
}

struct ReferenceCurve {
  SurfaceMesh mesh;
  std::vector<VertexId> path;  ///< of the drawn curve; a closed curve repeats no vertex
  bool closed = false;
};

inline std::optional<ReferenceCurve> reference_curve(const std::string& name) {
  const auto mesh_file = mesh_folder() / (name + ".ply");
  std::ifstream numbers(reference_folder() / "curves" / (name + ".txt"));
  if (!numbers || !std::filesystem::exists(mesh_file)) return std::nullopt;
  ReferenceCurve curve{SurfaceMesh::open(read_reference_mesh(mesh_file)), {}, false};
  for (std::size_t v = 0; numbers >> v;) curve.path.push_back(VertexId{v});
  curve.closed = curve.path.front() == curve.path.back();
  if (curve.closed) curve.path.pop_back();
  return curve;
}

/// The points of the reference result for tau = 1. A closed curve does not repeat its first point
/// here, but does in the file.
inline std::vector<Point> reference_result(const std::string& name) {
  std::ifstream in(reference_folder() / "results" / (name + "_tau1.xyz"));
  std::vector<Point> points;
  for (Point p; in >> p.x() >> p.y() >> p.z();) points.push_back(p);
  if (points.size() > 1 && points.front() == points.back()) points.pop_back();
  return points;
}

/// The reference result as a curve on the mesh: every point is moved to the nearest edge or vertex.
/// `moved` gets the largest distance of a move.
inline SurfaceCurve reference_result_curve(const ReferenceCurve& drawn, const std::string& name,
                                           double& moved) {
  const Surface& surface = drawn.mesh.surface();
  SurfaceCurve curve{drawn.closed, {}};
  moved = 0;
  const auto lengths = surface.lengths();
  const double longest = *std::max_element(lengths.begin(), lengths.end());
  for (const Point& p : reference_result(name)) {
    double best = std::numeric_limits<double>::infinity();
    EdgeId edge;
    double place = 0;
    for (std::size_t e = 0; e < surface.edge_count(); ++e) {
      const HalfedgeId h = halfedge_of(EdgeId{e});
      const Point& a = drawn.mesh.point(surface.tail(h));
      if ((p - a).cwiseAbs().maxCoeff() > 1.01 * longest) continue;
      const Point along = drawn.mesh.point(surface.head(h)) - a;
      const double t = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
      const double squared = (a + t * along - p).squaredNorm();
      if (squared >= best) continue;
      best = squared;
      edge = EdgeId{e};
      place = t;
    }
    moved = std::max(moved, std::sqrt(best));
    const HalfedgeId h = halfedge_of(edge);
    if (place < 1e-9) {
      curve.points.push_back(SurfacePoint::at_vertex(surface, surface.tail(h)));
    } else if (place > 1 - 1e-9) {
      curve.points.push_back(SurfacePoint::at_vertex(surface, surface.head(h)));
    } else {
      curve.points.push_back(SurfacePoint::on_edge(surface, edge, place));
    }
  }
  return curve;
}

/// The measures of the reference result with the paper's potential.
inline nlohmann::json reference_numbers(const std::string& name, double tau) {
  std::ifstream in(reference_folder() / "paper_potential.json");
  for (const auto& entry : nlohmann::json::parse(in)) {
    if (entry["mesh"] == name + ".ply" && entry["tau"] == tau) return entry;
  }
  return {};
}

}  // namespace talweg::test
