// Mesh lists hold the mesh of a file or a caller, unchecked and complete.
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

/// A face of a file with n > 3 corners, stored as n - 2 consecutive triangles.
struct Polygon {
  std::uint32_t first = 0;    ///< index of the first triangle
  std::uint32_t corners = 0;  ///< n
};

/// A corner of a polygon, named by one of its triangles.
struct PolygonCorner {
  std::uint32_t triangle = 0;
  std::uint32_t corner = 0;
};

/// The outlines of faces with any number of corners, which consist of triangles of the lists.
struct FaceOutlines {
  std::vector<PolygonCorner> corners;   ///< of the first face, of the second, ...
  std::vector<std::uint32_t> first{0};  ///< per face, the index of its first corner; then the end

  [[nodiscard]] std::size_t size() const { return first.size() - 1; }
  [[nodiscard]] std::span<const PolygonCorner> face(std::size_t f) const {
    return std::span(corners).subspan(first[f], first[f + 1] - first[f]);
  }
  void add(std::span<const PolygonCorner> face) {
    corners.insert(corners.end(), face.begin(), face.end());
    first.push_back(static_cast<std::uint32_t>(corners.size()));
  }
};

/// Statistics of the shapes of a mesh's polygons. Face numbers are those of the file, from 0,
/// triangles included.
struct PolygonShapes {
  std::size_t concave = 0;      ///< polygons with a reflex corner
  std::size_t crossing = 0;     ///< polygons that cross themselves or have no area
  std::size_t not_plane = 0;    ///< polygons with a corner farther than 1e-5 · size from the plane
  double largest_distance = 0;  ///< of a corner from the polygon's plane, as a fraction of the size
  std::uint32_t largest_face = 0;   ///< the file's face with this distance
  std::uint32_t crossing_face = 0;  ///< the file's first face that crosses itself
};

/// The vertex and face numbers of the lists are the ids in all results. Readers triangulate
/// polygons; the triangles of one polygon are consecutive.
struct MeshLists {
  std::vector<Point> points;           ///< mesh units
  std::vector<Triangle> triangles;     ///< counterclockwise, indices of points
  std::size_t polygon_count = 0;       ///< faces of the file with more than three corners
  bool single_precision = false;       ///< the file stores its coordinates as 32-bit floats
  std::vector<Polygon> polygons = {};  ///< faces of more than three corners; none after a repair
  PolygonShapes polygon_shapes = {};
  std::optional<LengthUnit> unit = {};          ///< of the coordinates, if the file has it
  PatientSpace space = PatientSpace::kNotSaid;  ///< of the coordinates, if the file has it
  std::vector<std::string> notes =
      {};  ///< sentences about content of the file that was not read, or changed

  /// The frame of the coordinates; the default unit is the millimetre.
  [[nodiscard]] CoordinateFrame frame() const { return {unit.value_or(LengthUnit()), space}; }
};

/// Triangulates polygons so that the triangles do not overlap or leave the polygon. On input a
/// polygon is a fan from its first corner: triangles (0, k, k + 1), as every reader makes it. A fan
/// that covers its polygon stays, as for convex polygons. Otherwise ears are clipped in the plane
/// perpendicular to Newell's normal (the sum of the cross products of consecutive corners), which
/// keeps the area of a plane polygon; the first triangle then begins with the corners 0 and 1 of
/// the polygon. Polygons that cross themselves, have no area or have a corner that is not finite
/// stay fans. Also sets `polygon_shapes`: the size of a polygon is the largest extent of its box,
/// its plane is perpendicular to Newell's normal through the mean of the corners. O(corners log
/// corners) on typical polygons.
void triangulate_polygons(MeshLists& lists);

}  // namespace talweg
