// An orthographic camera.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg::picture {

/// Projects space to a raster. The axes are right, up, and from the scene towards the viewer.
struct Camera {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< one axis per row, orthonormal
  Point center = Point::Zero();                        ///< seen in the middle of the raster
  double scale = 1;                                    ///< raster units per mesh unit
  double width = 1;                                    ///< of the raster
  double height = 1;

  /// x to the right and y downwards in raster units from the top left; z towards the viewer, in
  /// the same unit.
  [[nodiscard]] Point project(const Point& p) const {
    const Point q = scale * (axes * (p - center));
    return {q.x() + 0.5 * width, 0.5 * height - q.y(), q.z()};
  }
};

/// Axes that look against `direction` (from the scene to the viewer, not zero) with `up` upright as
/// far as possible.
Eigen::Matrix3d axes_for(const Point& direction, const Point& up);

/// The smallest and largest coordinates of points along the axes.
struct Extent {
  Point low = Point::Constant(1e300);
  Point high = Point::Constant(-1e300);

  void add(const Point& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  [[nodiscard]] Point center() const { return 0.5 * (low + high); }
  [[nodiscard]] Point size() const { return high - low; }
};

/// A camera with these axes whose raster of width × height just holds the extent (measured along
/// the axes), with `margin` as a fraction of the raster free on each side.
Camera framed(const Eigen::Matrix3d& axes, const Extent& extent, double width, double height,
              double margin);

}  // namespace talweg::picture
