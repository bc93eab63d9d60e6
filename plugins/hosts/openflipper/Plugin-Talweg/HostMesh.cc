#include "HostMesh.hh"

#include <algorithm>
#include <cmath>

#include <ACG/Geometry/Algorithms.hh>
#include <ACG/Utils/ColorCoder.hh>
#include <MeshTools/MeshSelectionT.hh>

namespace talweg::openflipper {
namespace {

/// The edge on which the point lies between two corners, or -1.
int edge_at(const TriMesh& mesh, unsigned face, const std::array<double, 3>& barycentric) {
  const auto zero = std::find(barycentric.begin(), barycentric.end(), 0.0);
  if (zero == barycentric.end()) return -1;
  std::array<TriMesh::VertexHandle, 3> corners;
  std::size_t k = 0;
  const TriMesh::FaceHandle handle(static_cast<int>(face));
  for (auto v = mesh.cfv_iter(handle); v.is_valid() && k < 3; ++v) corners[k++] = *v;
  const std::size_t opposite = static_cast<std::size_t>(zero - barycentric.begin());
  const auto a = corners[(opposite + 1) % 3], b = corners[(opposite + 2) % 3];
  const auto halfedge = mesh.find_halfedge(a, b);
  return halfedge.is_valid() ? mesh.edge_handle(halfedge).idx() : -1;
}

void make_handles(PolyLine& line) {
  line.clear();
  if (!line.vertex_vhandles_available()) line.request_vertex_vhandles();
  if (!line.vertex_ehandles_available()) line.request_vertex_ehandles();
  if (!line.vertex_fhandles_available()) line.request_vertex_fhandles();
}

void add(PolyLine& line, const ACG::Vec3d& position, int vertex, int edge, int face) {
  line.add_point(position);
  const auto last = static_cast<unsigned>(line.n_vertices() - 1);
  line.vertex_vhandle(last) = vertex;
  line.vertex_ehandle(last) = edge;
  line.vertex_fhandle(last) = face;
}

ACG::Vec4f colour_of(const ACG::ColorCoder& coder, double value) {
  if (!std::isfinite(value)) return {0.6f, 0.6f, 0.6f, 1.0f};
  return coder.color_float4(static_cast<float>(value));
}

}  // namespace

std::shared_ptr<const editing::MeshArrays> arrays_of(const TriMesh& mesh) {
  auto arrays = std::make_shared<editing::MeshArrays>();
  arrays->positions.reserve(mesh.n_vertices());
  arrays->triangles.reserve(mesh.n_faces());
  for (const auto v : mesh.all_vertices()) {
    const auto& p = mesh.point(v);
    arrays->positions.push_back({p[0], p[1], p[2]});
  }
  for (const auto f : mesh.all_faces()) {
    if (mesh.has_face_status() && mesh.status(f).deleted()) {
      throw editing::Error("The mesh has deleted faces; collect its garbage first.");
    }
    std::array<std::uint32_t, 3> corners = {};
    std::size_t k = 0;
    for (auto v = mesh.cfv_iter(f); v.is_valid() && k < 3; ++v) {
      corners[k++] = static_cast<std::uint32_t>(v->idx());
    }
    arrays->triangles.push_back(corners);
  }
  return arrays;
}

editing::Point picked_on(const TriMesh& mesh, unsigned face, const ACG::Vec3d& hit) {
  std::array<ACG::Vec3d, 3> corners;
  std::size_t k = 0;
  const TriMesh::FaceHandle handle(static_cast<int>(face));
  for (auto v = mesh.cfv_iter(handle); v.is_valid() && k < 3; ++v) corners[k++] = mesh.point(*v);
  ACG::Vec3d at(1.0 / 3);
  ACG::Geometry::baryCoord(hit, corners[0], corners[1], corners[2], at);
  return editing::picked(face, {at[0], at[1], at[2]});
}

ACG::Vec3d vector_at(const editing::MeshArrays& mesh, const editing::Point& point) {
  const auto p = editing::position_of(mesh, point);
  return {p[0], p[1], p[2]};
}

void fill(PolyLine& line, const TriMesh& mesh, const host::Curve& result) {
  make_handles(line);
  line.set_closed(result.closed);
  for (std::size_t k = 0; k < result.positions.size(); ++k) {
    const auto& p = result.positions[k];
    const std::uint32_t vertex = result.vertices[k];
    const bool at_vertex = vertex != TALWEG_NO_VERTEX;
    add(line, {p[0], p[1], p[2]}, at_vertex ? static_cast<int>(vertex) : -1,
        at_vertex ? -1 : edge_at(mesh, result.faces[k], result.barycentrics[k]),
        static_cast<int>(result.faces[k]));
  }
  for (const host::Field& field : result.fields) {
    if (field.name != "deviation") continue;
    if (!line.vertex_scalars_available()) line.request_vertex_scalars();
    for (unsigned k = 0; k < field.values.size(); ++k) line.vertex_scalar(k) = field.values[k];
  }
}

void fill(PolyLine& line, const TriMesh& mesh, const editing::MeshArrays& arrays,
          const editing::Curve& drawn) {
  make_handles(line);
  line.set_closed(drawn.closed);
  for (const editing::Point& point : drawn.points) {
    int vertex = -1;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      if (point.barycentric[corner] == 1) {
        vertex = static_cast<int>(arrays.triangles[point.face][corner]);
      }
    }
    add(line, vector_at(arrays, point), vertex,
        vertex >= 0 ? -1 : edge_at(mesh, point.face, point.barycentric),
        static_cast<int>(point.face));
  }
}

host::Curve positions_of(const PolyLine& line) {
  host::Curve curve;
  curve.closed = line.is_closed();
  for (const ACG::Vec3d& p : line.points()) curve.positions.push_back({p[0], p[1], p[2]});
  return curve;
}

std::vector<editing::OrderedVertices> ordered_selection(TriMesh& mesh,
                                                        const editing::MeshArrays& arrays) {
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (const int e : MeshSelection::getEdgeSelection(&mesh)) {
    const auto h = mesh.halfedge_handle(TriMesh::EdgeHandle(e), 0);
    edges.push_back({static_cast<std::uint32_t>(mesh.from_vertex_handle(h).idx()),
                     static_cast<std::uint32_t>(mesh.to_vertex_handle(h).idx())});
  }
  std::vector<std::uint32_t> vertices;
  for (const int v : MeshSelection::getVertexSelection(&mesh)) {
    vertices.push_back(static_cast<std::uint32_t>(v));
  }
  auto curves = edges.empty() ? editing::order_along_mesh(arrays, vertices)
                              : editing::order_along_edges(edges);
  if (curves.empty()) throw editing::Error("Select vertices or edges of the mesh first.");
  return curves;
}

double largest_of(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::isfinite(value) ? value : 0);
  return largest;
}

std::vector<ACG::Vec4f> colours_of(const std::vector<double>& values) {
  const double largest = largest_of(values);
  const ACG::ColorCoder coder(0.0f, largest > 0 ? static_cast<float>(largest) : 1.0f);
  std::vector<ACG::Vec4f> colours;
  for (const double value : values) colours.push_back(colour_of(coder, value));
  return colours;
}

void colour(TriMesh& mesh, const std::vector<double>& values) {
  const std::vector<ACG::Vec4f> colours = colours_of(values);
  if (!mesh.has_vertex_colors()) mesh.request_vertex_colors();
  for (const auto v : mesh.vertices()) {
    mesh.set_color(v, colours.at(static_cast<std::size_t>(v.idx())));
  }
}

void colour(PolyLine& line, const std::vector<double>& values, double largest) {
  const ACG::ColorCoder coder(0.0f, largest > 0 ? static_cast<float>(largest) : 1.0f);
  const auto as_point = [](const ACG::Vec4f& c) { return PolyLine::Point(c[0], c[1], c[2]); };
  if (!line.vertex_colors_available()) line.request_vertex_colors();
  if (!line.edge_colors_available()) line.request_edge_colors();
  for (unsigned k = 0; k < values.size(); ++k) {
    line.vertex_color(k) = as_point(colour_of(coder, values[k]));
    if (k < line.n_edges()) line.edge_color(k) = line.vertex_color(k);
  }
}

}  // namespace talweg::openflipper
