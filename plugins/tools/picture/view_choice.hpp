// The choice of a view tells where to look from, and at what.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "tools/picture/camera.hpp"
#include "tools/picture/render.hpp"

namespace talweg::picture {

/// The scene's upright: what the caller chose; else for a sheet (flat, open) its mean normal; else
/// y.
Point upright_of(const Scene& scene);

/// Of a fixed set of directions around the mesh the one from which most of the curves' length is
/// visible and not too foreshortened, with a slight preference for views a little from above; of
/// the mesh itself where there are no curves. O(faces).
Point best_direction(const Scene& scene, const std::vector<Eigen::Vector3f>& normals,
                     const Point& up);

/// Where the first curve turns most within a window of its length, among the parts of it that can
/// be seen from `direction`. Its normal is the direction to look from: the surface's, or
/// `direction` where something is in the way of that. O(faces).
Detail most_turning_place(const Scene& scene, const std::vector<Eigen::Vector3f>& normals,
                          const Point& direction, const Point& up);

/// The direction from which the parts of the curves within a ball are seen best: `normal`, unless
/// another shows clearly more of them. O(faces).
Point clear_direction(const Scene& scene, const std::vector<Eigen::Vector3f>& normals,
                      const Point& center, double radius, const Point& normal, const Point& up);
/// The mean of the normals within a ball; z where there are none. O(faces).
Point normal_around(const MeshLists& mesh, const std::vector<Eigen::Vector3f>& normals,
                    const Point& center, double radius);

/// The mesh's extent along the axes; vertices without faces do not count.
Extent mesh_extent(const MeshLists& mesh, const Eigen::Matrix3d& axes);
/// The extent of some of the scene's curves along the axes.
Extent curve_extent(const Scene& scene, const std::vector<std::size_t>& curves,
                    const Eigen::Matrix3d& axes);

}  // namespace talweg::picture
