// A surface point lies at a vertex, on an edge or in a face; its coordinates are intrinsic.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <variant>
#include <vector>

#include "talweg/intrinsic/surface/ids.hpp"

namespace talweg {

class Surface;

struct AtVertex {
  VertexId vertex;
  friend bool operator==(const AtVertex&, const AtVertex&) = default;
};

/// Inside an edge: t in (0, 1) from the tail to the head of halfedge_of(edge).
struct OnEdge {
  EdgeId edge;
  double t = 0.5;
  friend bool operator==(const OnEdge&, const OnEdge&) = default;
};

/// Inside a face: barycentrics > 0, summing to 1, in the order of Surface::corners(face).
struct InFace {
  FaceId face;  ///< the face that contains the point
  std::array<double, 3> barycentric{};
  friend bool operator==(const InFace&, const InFace&) = default;
};

/// A point at a vertex, inside an edge or inside a face; no other values can be built.
class SurfacePoint {
 public:
  /// Throws Error(kBadCurve) when the element does not exist or a coordinate is out of its range.
  static SurfacePoint at_vertex(const Surface& surface, VertexId vertex);
  static SurfacePoint on_edge(const Surface& surface, EdgeId edge, double t);
  static SurfacePoint in_face(const Surface& surface, FaceId face,
                              const std::array<double, 3>& barycentric);

  /// The point with these barycentrics of a face: coordinates of at most `tolerance` count as 0, so
  /// the result is at a corner, on a side or inside. Throws Error(kBadCurve) when a coordinate is
  /// below -tolerance or the sum is not 1 within 1e-6.
  static SurfacePoint from_barycentric(const Surface& surface, FaceId face,
                                       const std::array<double, 3>& barycentric,
                                       double tolerance = 1e-12);

  [[nodiscard]] const std::variant<AtVertex, OnEdge, InFace>& where() const { return where_; }
  [[nodiscard]] bool is_vertex() const { return std::holds_alternative<AtVertex>(where_); }

  friend bool operator==(const SurfacePoint&, const SurfacePoint&) = default;

 private:
  explicit SurfacePoint(std::variant<AtVertex, OnEdge, InFace> where) : where_(where) {}
  std::variant<AtVertex, OnEdge, InFace> where_;
};

/// The vertex, edge or face that contains a point. Elements are ordered, so points can be sorted
/// and looked up by element.
struct SurfaceElement {
  enum class Kind { kVertex, kEdge, kFace };
  Kind kind = Kind::kVertex;
  std::size_t index = 0;  ///< of the VertexId, EdgeId or FaceId
  friend auto operator<=>(const SurfaceElement&, const SurfaceElement&) = default;
};
SurfaceElement element_of(const SurfacePoint& point);

/// Barycentrics of a point with respect to one face that contains it.
struct FaceCoordinates {
  FaceId face;
  std::array<double, 3> barycentric{};  ///< in the order of Surface::corners(face)
};

/// All faces that contain the point: the faces around a vertex, one or two at an edge, one inside a
/// face.
std::vector<FaceId> faces_at(const Surface& surface, const SurfacePoint& point);
/// The point's coordinates in `face`. Throws Error(kBadCurve) if the face does not contain the
/// point.
FaceCoordinates coordinates_in(const Surface& surface, const SurfacePoint& point, FaceId face);
/// The face of smallest id that contains both points; invalid if there is none.
FaceId common_face(const Surface& surface, const SurfacePoint& p, const SurfacePoint& q);
/// The face of smallest id that contains the point; invalid for an isolated vertex.
FaceId any_face(const Surface& surface, const SurfacePoint& point);
/// Distance of two points of one face, measured in the face's plane. O(1).
double distance_in_face(const Surface& surface, const FaceCoordinates& p, const FaceCoordinates& q);

/// A piecewise straight curve: each point and the next lie in one common face.
/// A closed curve does not repeat its first point.
struct SurfaceCurve {
  bool closed = false;
  std::vector<SurfacePoint> points;
};

}  // namespace talweg
