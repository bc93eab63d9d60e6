// A point is a place in space.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>  // cross()

namespace talweg {

using Point = Eigen::Vector3d;  ///< mesh units

}  // namespace talweg
