// Corner normals make shading smooth.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg::picture {

/// Unit normals per corner (3 per face, in the order of the face's vertices): the area-weighted
/// mean over those faces at the vertex whose normals differ by less than the crease angle from the
/// face's own, so that sharp edges stay sharp. Faces without area get (0, 0, 1). O(faces).
std::vector<Eigen::Vector3f> corner_normals(const MeshLists& mesh, double crease_angle = 0.9);

}  // namespace talweg::picture
