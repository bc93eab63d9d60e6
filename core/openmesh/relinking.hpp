// A relinking is a change of a mesh's connectivity, as lists of handles.
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

  /// Numbers of elements.
  struct Counts {
    std::size_t vertices = 0, edges = 0, faces = 0;
  };
  Counts before, after;

  // The links to set: (element, its new value).
  Pairs<Halfedge, Vertex> heads;
  Pairs<Halfedge, Halfedge> nexts;
  Pairs<Halfedge, Face> faces;
  Pairs<Face, Halfedge> of_faces;
  Pairs<Vertex, Halfedge> of_vertices;

  // The sources of new elements: (source, new element).
  struct Mixed {
    Vertex vertex = Vertex();
    std::array<Vertex, 3> from = {Vertex(), Vertex(), Vertex()};  ///< two or three old vertices
    std::array<double, 3> weights{};
  };
  std::vector<Mixed> vertices;      ///< the new vertices on edges and in faces
  Pairs<Vertex, Vertex> copies;     ///< an old vertex and its new copy
  Pairs<Edge, Edge> halves;         ///< an old edge and a new part of it, or its new copy
  Pairs<Halfedge, Halfedge> inner;  ///< an old halfedge of the face, and a new one inside
  Pairs<Face, Face> face_parts;     ///< an old face and a new part of it
  /// A halfedge that is new or has a new head, and the old face's halfedges whose values are mixed
  /// at the corner there.
  struct Corner {
    Halfedge halfedge = Halfedge();
    std::array<Halfedge, 3> from = {Halfedge(), Halfedge(), Halfedge()};
    std::array<double, 3> weights{};
  };
  std::vector<Corner> corners;

  std::vector<std::vector<Halfedge>> chains;  ///< one list per curve
};

}  // namespace talweg
