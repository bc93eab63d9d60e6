// OpenMesh meshes with properties of every kind, for changes in place.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Utils/MeshCheckerT.hh>

#include "core/small_meshes.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/openmesh/openmesh_adaptor.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::test {

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;  // normals stay float
};
using FloatMesh = OpenMesh::TriMesh_ArrayKernelT<>;
using DoubleMesh = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

template <class Mesh>
Mesh openmesh_of(const MeshLists& lists) {
  using P = typename Mesh::Point;
  using S = typename P::value_type;
  Mesh mesh;
  for (const Point& p : lists.points) mesh.add_vertex(P(S(p.x()), S(p.y()), S(p.z())));
  for (const Triangle& t : lists.triangles) {
    mesh.add_face(mesh.vertex_handle(t[0]), mesh.vertex_handle(t[1]), mesh.vertex_handle(t[2]));
  }
  return mesh;
}

template <class Mesh>
bool is_sound(const Mesh& mesh, std::string* why = nullptr) {
  std::ostringstream text;
  const bool sound = OpenMesh::Utils::MeshCheckerT<Mesh>(mesh).check(
      OpenMesh::Utils::MeshCheckerT<Mesh>::CHECK_ALL, text);
  if (why != nullptr) *why = text.str();
  return sound;
}

template <class Mesh>
void request_status(Mesh& mesh) {
  mesh.request_vertex_status();
  mesh.request_halfedge_status();
  mesh.request_edge_status();
  mesh.request_face_status();
}

/// Deletes some vertices and their faces such that the rest is a surface. Garbage is not collected.
template <class Mesh>
void delete_some(Mesh& mesh, std::mt19937& random, int count) {
  request_status(mesh);
  for (int k = 0; k < count; ++k) {
    Mesh tried = mesh;
    tried.delete_vertex(tried.vertex_handle(static_cast<unsigned>(random() % mesh.n_vertices())),
                        true);
    try {
      static_cast<void>(surface_of(tried));
    } catch (const Error&) {
      continue;  // a vertex with two fans
    }
    mesh = tried;
  }
}

/// The caller's own properties, numbers and text, for each kind of element.
struct OwnProperties {
  OpenMesh::VPropHandleT<int> v_number;
  OpenMesh::HPropHandleT<int> h_number;
  OpenMesh::EPropHandleT<int> e_number;
  OpenMesh::FPropHandleT<int> f_number;
  OpenMesh::VPropHandleT<std::string> v_text;
  OpenMesh::HPropHandleT<std::string> h_text;
  OpenMesh::EPropHandleT<std::string> e_text;
  OpenMesh::FPropHandleT<std::string> f_text;

  template <class Mesh>
  void add_to(Mesh& mesh, std::mt19937& random) {
    const auto fill = [&](auto& number, auto& text, std::size_t count, const char* kind) {
      mesh.add_property(number, std::string(kind) + " number");
      mesh.add_property(text, std::string(kind) + " text");
      for (std::size_t k = 0; k < count; ++k) {
        mesh.property(number).data_vector()[k] = static_cast<int>(random());
        mesh.property(text).data_vector()[k] = std::string(random() % 40, 'x') + std::to_string(k);
      }
    };
    fill(v_number, v_text, mesh.n_vertices(), "vertex");
    fill(h_number, h_text, mesh.n_halfedges(), "halfedge");
    fill(e_number, e_text, mesh.n_edges(), "edge");
    fill(f_number, f_text, mesh.n_faces(), "face");
  }
};

/// The kernel's own attributes, filled with random values.
template <class Mesh>
void add_attributes(Mesh& mesh, std::mt19937& random) {
  std::uniform_real_distribution<float> part(-1, 1);
  const auto byte = [&] { return static_cast<unsigned char>(random() % 256); };
  mesh.request_vertex_normals();
  mesh.request_vertex_colors();
  mesh.request_vertex_texcoords2D();
  mesh.request_halfedge_texcoords2D();
  mesh.request_halfedge_normals();
  mesh.request_face_colors();
  for (const auto v : mesh.all_vertices()) {
    mesh.set_normal(v, {part(random), part(random), part(random)});
    mesh.set_color(v, {byte(), byte(), byte()});
    mesh.set_texcoord2D(v, {part(random), part(random)});
  }
  for (const auto h : mesh.all_halfedges()) {
    mesh.set_texcoord2D(h, {part(random), part(random)});
    mesh.set_normal(h, {part(random), part(random), part(random)});
  }
  for (const auto f : mesh.all_faces()) mesh.set_color(f, {byte(), byte(), byte()});
}

/// All data of a mesh, element by element, as text. Equal texts mean bitwise equal meshes.
template <class Mesh>
struct Written {
  std::vector<std::string> vertices, halfedges, edges, faces;

  Written(const Mesh& mesh, const OwnProperties& own) {
    const auto bits = [](std::ostringstream& text, const auto& value) {
      const auto* bytes = reinterpret_cast<const unsigned char*>(&value);
      for (std::size_t k = 0; k < sizeof value; ++k) text << int{bytes[k]} << ' ';
    };
    for (const auto v : mesh.all_vertices()) {
      std::ostringstream text;
      text << mesh.halfedge_handle(v).idx() << ' ';
      bits(text, mesh.point(v));
      text << mesh.property(own.v_number, v) << mesh.property(own.v_text, v);
      if (mesh.has_vertex_status()) text << ' ' << mesh.status(v).bits() << ' ';
      if (mesh.has_vertex_normals()) bits(text, mesh.normal(v));
      if (mesh.has_vertex_colors()) bits(text, mesh.color(v));
      if (mesh.has_vertex_texcoords2D()) bits(text, mesh.texcoord2D(v));
      vertices.push_back(text.str());
    }
    for (const auto h : mesh.all_halfedges()) {
      std::ostringstream text;
      text << mesh.to_vertex_handle(h).idx() << ' ' << mesh.next_halfedge_handle(h).idx() << ' '
           << mesh.prev_halfedge_handle(h).idx() << ' ' << mesh.face_handle(h).idx() << ' '
           << mesh.property(own.h_number, h) << mesh.property(own.h_text, h);
      if (mesh.has_halfedge_status()) text << ' ' << mesh.status(h).bits() << ' ';
      if (mesh.has_halfedge_normals()) bits(text, mesh.normal(h));
      if (mesh.has_halfedge_texcoords2D()) bits(text, mesh.texcoord2D(h));
      halfedges.push_back(text.str());
    }
    for (const auto e : mesh.all_edges()) {
      std::ostringstream text;
      text << mesh.property(own.e_number, e) << mesh.property(own.e_text, e);
      if (mesh.has_edge_status()) text << ' ' << mesh.status(e).bits();
      edges.push_back(text.str());
    }
    for (const auto f : mesh.all_faces()) {
      std::ostringstream text;
      text << mesh.halfedge_handle(f).idx() << ' ' << mesh.property(own.f_number, f)
           << mesh.property(own.f_text, f);
      if (mesh.has_face_status()) text << ' ' << mesh.status(f).bits() << ' ';
      if (mesh.has_face_colors()) bits(text, mesh.color(f));
      faces.push_back(text.str());
    }
  }
  friend bool operator==(const Written&, const Written&) = default;
};

/// A curve of straight lines between random points, at vertices, on edges and in faces.
inline SurfaceCurve random_curve(const SurfaceMesh& mesh, std::mt19937& random, bool closed) {
  const Surface& surface = mesh.surface();
  std::uniform_real_distribution<double> part(0.05, 0.9);
  std::vector<SurfacePoint> points;
  for (int k = 0; k < 4; ++k) {
    const FaceId f{random() % surface.face_count()};
    const double a = part(random), b = (1 - a) * part(random);
    if (random() % 3 == 0) {
      points.push_back(SurfacePoint::at_vertex(surface, surface.corners(f)[0]));
    } else if (random() % 2 == 0) {
      points.push_back(SurfacePoint::on_edge(surface, edge_of(surface.halfedge(f)), a));
    } else {
      points.push_back(SurfacePoint::from_barycentric(surface, f, {a, b, 1 - a - b}));
    }
  }
  return StraightLines(surface).join(points, closed);
}
/// One to three random curves. Curves that cannot be drawn are left out: two points may be equal or
/// in different components.
inline std::vector<SurfaceCurve> random_curves(const SurfaceMesh& mesh, std::mt19937& random) {
  std::vector<SurfaceCurve> curves;
  const std::size_t count = 1 + random() % 3;
  for (int tries = 0; curves.size() < count && tries < 50; ++tries) {
    try {
      curves.push_back(random_curve(mesh, random, random() % 2 == 0));
    } catch (const Error&) {
      continue;
    }
  }
  return curves;
}

}  // namespace talweg::test
