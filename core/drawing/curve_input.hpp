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
  std::size_t point = 0;  ///< its index
  double tolerance = 0;   ///< mesh units, >= 0: how far from it a result may pass
};

/// A point between three vertices of a face; they may be the same where a weight is 0.
struct CornerCoordinates {
  std::array<VertexId, 3> corners;
  std::array<double, 3> weights{};  ///< of the corners
};

/// It has not been checked against a mesh; snap() does that.
struct CurveInput {
  bool closed = false;  ///< the first point is then not repeated
  /// Vertices of the mesh, points in its faces, positions in space, or points between vertices.
  std::variant<std::vector<VertexId>, std::vector<FaceCoordinates>, std::vector<Point>,
               std::vector<CornerCoordinates>>
      points;
  std::vector<std::size_t> pins;          ///< indices of points that must stay, ascending
  std::vector<InputWayPoint> way_points;  ///< ascending
  /// Indices of points that were painted, ascending. Without way-points all of them were; between
  /// two way-points, the curve is a stroke only if one of these lies there.
  std::vector<std::size_t> painted;
  /// Whether the points are those that a program's curve is controlled by. snap() makes them
  /// way-points if they can have been clicked, see why_no_clicks().
  bool control_points = false;
  /// Sentences on what reading did to it: positions were turned or scaled, points left out.
  std::vector<std::string> told;
};

}  // namespace talweg
