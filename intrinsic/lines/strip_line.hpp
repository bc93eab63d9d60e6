// A line through a strip of faces is the shortest way between two points among those that can be
// reached without leaving their isotopy class.
#pragma once

#include <cstddef>
#include <vector>

#include "talweg/intrinsic/lines/face_frame.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The halfedges that a curve crosses one after the other, each in the face that is left.
using FaceStrip = std::vector<HalfedgeId>;

/// Appends a crossing; one that goes back over the last crossing takes it away instead.
void add_crossing(FaceStrip& strip, HalfedgeId crossed, std::size_t first = 0);

/// A straight line between two points. It may bend at vertices whose angle on either side is at
/// least π, and at the boundary.
struct StripLine {
  FaceCoordinates from, to;
  double length = 0;      ///< mesh units
  PlanePoint start, end;  ///< unit directions in the frames of the faces of `from` and `to`
  bool found = false;
  std::vector<VertexId> bends;
  std::vector<double> turns;           ///< at these, in the strip: radians, to the left positive
  double first_leg = 0, last_leg = 0;  ///< to the first bend, and from the last; else the length
};

/// Finds the geodesic that is isotopic to the strip between the points with their ends fixed, and
/// its strip: the line is straightened by a funnel, and the strip is flipped to the other side of
/// every vertex around which that is shorter. Points on the edges that the strip begins or ends
/// with pass to the next face, so that `from` and `to` may be other coordinates of the same points.
/// `found` is false where coordinates are not finite (faces without area) or the strip does not
/// settle. O(faces of the strip) for each flip of the strip to another side of a vertex.
class StripLines {
 public:
  explicit StripLines(const Surface& surface) : surface_(&surface) {}

  StripLine join(const FaceCoordinates& from, const FaceCoordinates& to, FaceStrip& strip);
  /// Where the last line crosses the halfedges of its strip: parts in [0, 1] from their tails.
  [[nodiscard]] const std::vector<double>& parts() const { return parts_; }
  /// As join() for a strip that is that of a line already; finds parts() again.
  StripLine trace(const FaceCoordinates& from, const FaceCoordinates& to, const FaceStrip& strip);

 private:
  struct Portal {
    PlanePoint left, right;
    VertexId left_vertex, right_vertex;
  };
  struct Bend {
    std::size_t portal = 0;
    bool left = false;
    PlanePoint at;
    VertexId vertex;
  };
  void trim(FaceCoordinates& from, FaceCoordinates& to, FaceStrip& strip) const;
  void unfold(const FaceCoordinates& from, const FaceCoordinates& to, const FaceStrip& strip);
  [[nodiscard]] bool is_straight() const;
  void pull_funnel();
  [[nodiscard]] double length() const;
  bool flip(const FaceStrip& strip, const Bend& bend, FaceStrip& other) const;
  void fill(StripLine& line) const;
  void find_parts();

  const Surface* surface_;
  // Of the strip that was unfolded last, in the frame of its first face.
  std::vector<Portal> portals_;
  std::vector<Bend> bends_;
  PlanePoint from_, to_;
  PlanePoint turn_;  // the rotation of the last face's frame, as a complex number
  FaceStrip other_;
  std::vector<double> parts_;
};

}  // namespace talweg
