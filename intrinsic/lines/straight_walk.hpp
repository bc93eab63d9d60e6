// A straight walk follows a straight line over the faces, from a point in a direction for a given
// distance.
#pragma once

#include <vector>

#include "talweg/intrinsic/lines/face_frame.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

struct WalkEnd {
  FaceCoordinates at;
  PlanePoint direction;  ///< unit, in the frame of the last face
  double walked = 0;     ///< mesh units; less than the given distance at the boundary
};

/// Walks from a point of a face in a unit direction of its frame. Appends the crossed halfedges to
/// `crossed`, each from the face that the walk leaves. The walk ends inside a face: barycentrics
/// are at least 1e-9, also where it stops at the boundary. `walked` is -1 where no straight line is
/// found (faces without area, or more than 2,000 faces). O(faces crossed).
WalkEnd walk_straight(const Surface& surface, const FaceCoordinates& from, PlanePoint direction,
                      double distance, std::vector<HalfedgeId>& crossed);

/// The same point, or a point close to it, with barycentrics of at least 1e-9.
FaceCoordinates moved_inside(FaceCoordinates at);

}  // namespace talweg
