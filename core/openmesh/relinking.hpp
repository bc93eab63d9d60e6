// A relinking is what a division plan changes in the connectivity of a mesh, as lists of handles.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include <OpenMesh/Core/Mesh/Handles.hh>

namespace talweg {

struct Relinking {
  using Vertex = OpenMesh::VertexHandle;
  using Halfedge = OpenMesh::HalfedgeHandle;
  using Edge = OpenMesh::EdgeHandle;
  using Face = OpenMesh::FaceHandle;
  template <class From, class To>
  using Pairs = std::vector<std::pair<From, To>>;

  /// How many elements there are before and after.
  struct Counts {
    std::size_t vertices = 0, edges = 0, faces = 0;
  };
  Counts before, after;

  // What is set.
  Pairs<Halfedge, Vertex> heads;
  Pairs<Halfedge, Halfedge> nexts;
  Pairs<Halfedge, Face> faces;
  Pairs<Face, Halfedge> of_faces;
  Pairs<Vertex, Halfedge> of_vertices;

  // What new elements are made of.
  struct Mixed {
    Vertex vertex = Vertex();
    std::array<Vertex, 3> from = {Vertex(), Vertex(), Vertex()};  ///< the first so many
    std::array<double, 3> weights{};
  };
  std::vector<Mixed> vertices;      ///< the new ones
  Pairs<Vertex, Vertex> copies;     ///< an old one, and a new one that is like it
  Pairs<Edge, Edge> halves;         ///< an old edge, and a new one that is a part of it
  Pairs<Halfedge, Halfedge> inner;  ///< one of the face whose head is nearest, and the new one
  Pairs<Face, Face> face_parts;     ///< an old face, and a new one that is a part of it
  /// A halfedge that is new or has a new head, and those of its face to mix the corner there from.
  struct Corner {
    Halfedge halfedge = Halfedge();
    std::array<Halfedge, 3> from = {Halfedge(), Halfedge(), Halfedge()};
    std::array<double, 3> weights{};
  };
  std::vector<Corner> corners;

  std::vector<std::vector<Halfedge>> chains;  ///< one list per curve
};

}  // namespace talweg
