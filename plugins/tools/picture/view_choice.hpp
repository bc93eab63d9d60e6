// Chooses the direction and the centre of a view.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "tools/picture/camera.hpp"
#include "tools/picture/render.hpp"

namespace talweg::picture {

/// The upright direction of the scene: the caller's; otherwise for a flat, open sheet its mean
/// normal; otherwise y.
Point upright_of(const Scene& scene);

/// The best of a fixed set of directions around the mesh: most of the curves' length is visible and
/// not too foreshortened, with a slight preference for views from a little above. Without curves
/// most of the mesh is visible. O(faces).
Point best_direction(const Scene& scene, const std::vector<Eigen::Vector3f>& normals,
                     const Point& up);

/// The place where the first curve turns most within a window of its length, among its parts that
/// are visible from `direction`. Its normal is the direction of the view: the surface's normal, or
/// `direction` if the mesh hides the place along the normal. O(faces).
Detail most_turning_place(const Scene& scene, const std::vector<Eigen::Vector3f>& normals,
                          const Point& direction, const Point& up);

/// The direction that shows most of the curves within a ball: `normal`, unless another direction
/// shows clearly more. O(faces).
Point clear_direction(const Scene& scene, const std::vector<Eigen::Vector3f>& normals,
                      const Point& center, double radius, const Point& normal, const Point& up);
/// The mean of the normals within a ball; z if there are none. O(faces).
Point normal_around(const MeshLists& mesh, const std::vector<Eigen::Vector3f>& normals,
                    const Point& center, double radius);

/// The mesh's extent along the axes; vertices without faces do not count.
Extent mesh_extent(const MeshLists& mesh, const Eigen::Matrix3d& axes);
/// The extent of some of the scene's curves along the axes.
Extent curve_extent(const Scene& scene, const std::vector<std::size_t>& curves,
                    const Eigen::Matrix3d& axes);

}  // namespace talweg::picture
