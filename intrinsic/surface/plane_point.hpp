// Plane points are points and directions of faces that are laid out in the plane.
#pragma once

#include <cmath>

namespace talweg {

struct PlanePoint {
  double x = 0;
  double y = 0;
};

inline PlanePoint operator+(PlanePoint a, PlanePoint b) { return {a.x + b.x, a.y + b.y}; }
inline PlanePoint operator-(PlanePoint a, PlanePoint b) { return {a.x - b.x, a.y - b.y}; }
inline PlanePoint operator*(double s, PlanePoint a) { return {s * a.x, s * a.y}; }
inline double dot(PlanePoint a, PlanePoint b) { return a.x * b.x + a.y * b.y; }
/// Positive where b points to the left of a.
inline double cross(PlanePoint a, PlanePoint b) { return a.x * b.y - a.y * b.x; }
inline double norm(PlanePoint a) { return std::sqrt(dot(a, a)); }
/// The direction turned by a right angle to the left.
inline PlanePoint turned_left(PlanePoint a) { return {-a.y, a.x}; }

}  // namespace talweg
