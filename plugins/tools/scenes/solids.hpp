// Implicit solids: functions that are negative inside and grow like a distance.
#pragma once

#include <functional>
#include <vector>

#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg::scenes {

using Field = std::function<double(const Point&)>;

/// The union of two solids whose seam is rounded over the length k > 0.
double smooth_union(double a, double b, double k);

/// A bent tube: balls of varying radius along a polyline.
class Tube {
 public:
  struct Ball {
    Point center;
    double radius;
  };
  /// The balls are joined by a smooth curve (Catmull-Rom) with `steps` pieces between consecutive
  /// balls.
  explicit Tube(const std::vector<Ball>& balls, int steps = 6);
  [[nodiscard]] double operator()(const Point& p) const;

 private:
  std::vector<Ball> chain_;
  Point low_, high_;  // box of the tube, to answer quickly far away
};

/// An ellipsoid along the axes; close to a distance near its surface.
double ellipsoid(const Point& p, const Point& center, const Point& radii);

}  // namespace talweg::scenes
