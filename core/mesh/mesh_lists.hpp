// Mesh lists are a mesh as a file or a caller gives it: nothing is checked, nothing dropped.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "talweg/core/space/coordinate_frame.hpp"
#include "talweg/core/space/point.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

/// A face of a file that has more than three corners, n: it is n - 2 triangles that follow each
/// other.
struct Polygon {
  std::uint32_t first = 0;    ///< its first triangle
  std::uint32_t corners = 0;  ///< n
};

/// A corner of a polygon as one of its triangles has it.
struct PolygonCorner {
  std::uint32_t triangle = 0;
  std::uint32_t corner = 0;
};

/// Faces of any number of corners, each made of triangles of the lists.
struct FaceOutlines {
  std::vector<PolygonCorner> corners;   ///< of all faces, one face after the other
  std::vector<std::uint32_t> first{0};  ///< of each face its first corner, and the end

  [[nodiscard]] std::size_t size() const { return first.size() - 1; }
  [[nodiscard]] std::span<const PolygonCorner> face(std::size_t f) const {
    return std::span(corners).subspan(first[f], first[f + 1] - first[f]);
  }
  void add(std::span<const PolygonCorner> face) {
    corners.insert(corners.end(), face.begin(), face.end());
    first.push_back(static_cast<std::uint32_t>(corners.size()));
  }
};

/// What the polygons of a mesh look like. Faces are counted as the file does, from 0, triangles
/// too.
struct PolygonShapes {
  std::size_t concave = 0;          ///< that have a corner which turns inwards
  std::size_t crossing = 0;         ///< that cross themselves, or have no area
  std::size_t not_plane = 0;        ///< with a corner farther than 1e-5 of the size from the plane
  double largest_distance = 0;      ///< of a corner from its polygon's plane, in parts of the size
  std::uint32_t largest_face = 0;   ///< the file's face that has it
  std::uint32_t crossing_face = 0;  ///< the file's first face that crosses itself
};

/// Vertex and face numbers here are the numbers of all results. Polygons are triangulated when a
/// file is read: the triangles of one polygon follow each other.
struct MeshLists {
  std::vector<Point> points;           ///< mesh units
  std::vector<Triangle> triangles;     ///< counterclockwise, indices of points
  std::size_t polygon_count = 0;       ///< faces of the file that had more than three corners
  bool single_precision = false;       ///< the file stores its coordinates as 32-bit floats
  std::vector<Polygon> polygons = {};  ///< those, where the triangles are still the file's
  PolygonShapes polygon_shapes = {};
  std::optional<LengthUnit> unit = {};          ///< of the coordinates, if the file has one
  PatientSpace space = PatientSpace::kNotSaid;  ///< of the coordinates, if the file says it
  std::vector<std::string> notes =
      {};  ///< sentences: what a file has that was read otherwise or not

  /// The frame of the coordinates; millimetres if nothing is said.
  [[nodiscard]] CoordinateFrame frame() const { return {unit.value_or(LengthUnit()), space}; }
};

/// Triangulates the polygons inside themselves. In the lists they are fans from their first corner,
/// as every reader leaves them: triangles (0, k, k + 1). A fan stays where it covers its polygon,
/// as it does where the polygon is convex. Otherwise ears are clipped in the plane across Newell's
/// normal (the sum of the cross products of neighbouring corners), so the area of a plane polygon
/// stays. The first triangle then begins with the polygon's corners 0 and 1. Polygons that cross
/// themselves or have no area stay fans, too. Also sets `polygon_shapes`: a polygon's size is the
/// largest extent of its box, its plane goes through the mean of its corners across that normal.
/// Corners that are not finite leave a polygon as it is. O(corners log corners) as a rule.
void triangulate_polygons(MeshLists& lists);

}  // namespace talweg
