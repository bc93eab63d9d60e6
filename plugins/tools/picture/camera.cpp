#include "tools/picture/camera.hpp"

#include <algorithm>
#include <limits>

#include <Eigen/Geometry>

namespace talweg::picture {

Eigen::Matrix3d axes_for(const Point& direction, const Point& up) {
  const Point forward = direction.normalized();
  Point right = up.normalized().cross(forward);
  if (right.norm() < 1e-6) {  // the view is along `up`: an axis serves as the upright direction
    int least = 0;
    forward.cwiseAbs().minCoeff(&least);
    right = Point::Unit(least).cross(forward);
  }
  right.normalize();
  Eigen::Matrix3d axes;
  axes.row(0) = right.transpose();
  axes.row(1) = forward.cross(right).transpose();
  axes.row(2) = forward.transpose();
  return axes;
}

Camera framed(const Eigen::Matrix3d& axes, const Extent& extent, double width, double height,
              double margin) {
  Camera camera;
  camera.axes = axes;
  camera.center = axes.transpose() * extent.center();
  camera.width = width;
  camera.height = height;
  const double free = 1 - 2 * margin;
  const Point size = extent.size().cwiseMax(std::numeric_limits<double>::min());
  camera.scale = std::min(free * width / size.x(), free * height / size.y());
  return camera;
}

}  // namespace talweg::picture
