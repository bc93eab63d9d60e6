// A line through a strip of faces is the shortest curve between two points in the isotopy class of
// the strip.
#pragma once

#include <cstddef>
#include <vector>

#include "talweg/intrinsic/lines/face_frame.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The halfedges that a curve crosses, in order, each from the face that the curve leaves.
using FaceStrip = std::vector<HalfedgeId>;

/// Appends a crossing. A crossing back over the last halfedge removes that halfedge instead. The
/// crossings before index `first` stay.
void add_crossing(FaceStrip& strip, HalfedgeId crossed, std::size_t first = 0);

/// A straight line between two points. It may bend at vertices whose angle on either side is at
/// least π, and at the boundary.
struct StripLine {
  FaceCoordinates from, to;
  double length = 0;      ///< mesh units
  PlanePoint start, end;  ///< unit directions in the frames of the faces of `from` and `to`
  bool found = false;
  std::vector<VertexId> bends;
  std::vector<double> turns;  ///< at the bends, within the strip; radians, positive to the left
  double to_first_bend = 0, from_last_bend = 0;  ///< lengths; the whole length if nothing bends
};

/// Finds the geodesic between two points that is isotopic to a strip with fixed ends, and updates
/// the strip to the faces of the geodesic. A funnel straightens the line, and the strip is flipped
/// to the other side of a vertex wherever the flip shortens the line. A point on the edge with
/// which the strip begins or ends passes to the next face, so `from` and `to` of the result may be
/// other coordinates of the same points. `found` is false where coordinates are not finite (faces
/// without area) or the strip does not settle. O(faces of the strip) for each flip of the strip to
/// another side of a vertex.
class StripLines {
 public:
  explicit StripLines(const Surface& surface) : surface_(&surface) {}

  StripLine join(const FaceCoordinates& from, const FaceCoordinates& to, FaceStrip& strip);
  /// The crossings of the last traced line with the halfedges of its strip, as fractions in [0, 1]
  /// from their tails.
  [[nodiscard]] const std::vector<double>& parts() const { return parts_; }
  /// Like join(), for a strip that join() has returned: the strip stays as it is, and parts() are
  /// computed.
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
  // The layout of the last unfolded strip, in the frame of its first face.
  std::vector<Portal> portals_;
  std::vector<Bend> bends_;
  PlanePoint from_, to_;
  PlanePoint turn_;  // the rotation of the last face's frame, as a complex number
  FaceStrip other_;
  std::vector<double> parts_;
};

}  // namespace talweg
