// A curve input is a curve as a file or a host gives it.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "talweg/core/space/point.hpp"
#include "talweg/intrinsic/surface/ids.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// A point of a curve that is meant exactly, as a click is.
struct InputWayPoint {
  std::size_t point = 0;  ///< the index of the point
  double tolerance = 0;   ///< mesh units, >= 0: how far from it a result may pass
};

/// A point as the weighted mean of three vertices of a face; vertices with weight 0 may repeat.
struct CornerCoordinates {
  std::array<VertexId, 3> corners;
  std::array<double, 3> weights{};  ///< of the corners
};

/// A curve that has not been checked against a mesh; snap() does the check.
struct CurveInput {
  bool closed = false;  ///< the first point is then not repeated
  /// Vertices of the mesh, points in its faces, positions in space, or points between vertices.
  std::variant<std::vector<VertexId>, std::vector<FaceCoordinates>, std::vector<Point>,
               std::vector<CornerCoordinates>>
      points;
  std::vector<std::size_t> pins;          ///< indices of points that must stay, ascending
  std::vector<InputWayPoint> way_points;  ///< ascending
  /// Indices of points that were painted, ascending. Without way-points all points count as
  /// painted; between two way-points the curve is a stroke only if a painted point lies there.
  std::vector<std::size_t> painted;
  /// Whether the points are the control points of another program's curve. snap() makes them
  /// way-points if they can have been clicked, see why_no_clicks().
  bool control_points = false;
  /// Sentences on changes by the reader: positions turned or scaled, points left out.
  std::vector<std::string> notes;
};

}  // namespace talweg
