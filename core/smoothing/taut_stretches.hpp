// Taut stretches are the parts of a straightened curve that stay while the rest of it is made fair.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "talweg/core/measure/curve_segments.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// Where a stretch of a curve begins and ends.
using StretchEnds = std::array<SurfacePoint, 2>;

/// A curve with stretches that stay.
struct HeldCurve {
  SurfaceCurve curve;                 ///< the same course with more points; a loop begins elsewhere
  std::vector<std::size_t> fixed;     ///< points that stay, ascending: all turns of the stretches
  std::vector<SurfacePoint> corners;  ///< those of them inside stretches: their turns cost nothing
  std::vector<StretchEnds> ends;      ///< of the stretches, in their order
  double share = 0;                   ///< of the curve's length that they have, in [0, 1]
  SurfacePoint middle;                ///< of the longest
};

/// Places along a curve are arc lengths from its first point, mesh units.
class TautStretches {
 public:
  /// Refers to both. Throws Error(kBadCurve) where two neighbours have no common face.
  TautStretches(const Surface& surface, const SurfaceCurve& curve);

  /// Adds what lies within this margin (mesh units, > 0) of a place.
  void add(double arc, double margin);
  [[nodiscard]] bool any() const { return !parts_.empty(); }
  [[nodiscard]] bool contain(double arc) const;
  /// The curve with its stretches held by points at most this far apart (mesh units, > 0). They
  /// grow until they begin and end where the curve is straight, so that its direction there stays,
  /// too. None where nothing would be left outside. Only for any().
  std::optional<HeldCurve> held(double spacing);

 private:
  struct Part {
    double from = 0, to = 0;
  };
  struct Course;
  struct Mark;
  static void merge(std::vector<Part>& parts);
  [[nodiscard]] std::size_t first_outside() const;
  [[nodiscard]] Course course_from(std::size_t first) const;
  [[nodiscard]] std::vector<Part> settled(const Course& course, double spacing) const;
  [[nodiscard]] std::vector<Mark> marks_on(const Course& course, const std::vector<Part>& parts,
                                           double spacing) const;
  [[nodiscard]] HeldCurve marked(const Course& course, const std::vector<Mark>& marks,
                                 double spacing) const;
  [[nodiscard]] SurfacePoint at(const Course& course, double arc) const;

  const Surface* surface_;
  const SurfaceCurve* curve_;
  double length_ = 0;
  std::vector<CurveSegment> segments_;
  std::vector<double> arcs_;  // of the points
  std::vector<Part> parts_;   // ascending, in [0, length]
};

}  // namespace talweg
