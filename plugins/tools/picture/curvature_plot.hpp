// A plot of curvature along curves shows whether they turn evenly or in kinks.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "talweg/core/measure/turning_windows.hpp"
#include "tools/picture/image.hpp"
#include "tools/picture/render.hpp"

namespace talweg::picture {

/// One curve of the plot.
struct PlotLine {
  std::string name;
  std::vector<CurvatureStep> steps;  ///< curvature_along(); covering the curve from 0 to its length
  Color color{0.1, 0.1, 0.1};
  double width = 1.6;   ///< pixels, > 0
  bool behind = false;  ///< pale; it does not affect the range, and is cut off outside
};

/// A part of the horizontal axis, in [0, 1].
struct Stretch {
  double from = 0, to = 0;
};

/// The parts of a curve within a ball.
std::vector<Stretch> stretches_in(const PictureCurve& curve, const Point& center, double radius);

/// Curves over a common axis: each is drawn over the whole width, by fractions of its own length.
struct CurvaturePlot {
  std::vector<PlotLine> lines;  ///< later ones are on top
  double edge = 0;              ///< h0, mesh units: curvature is shown in degrees per h0
  std::vector<Stretch> shown;   ///< shaded: parts that pictures beside the plot show
};

/// Draws axes, a legend and all lines. O(pixels + steps · width of a step). Deterministic. Throws
/// Error(kBadUsage) for a size outside [160, 16384] x [100, 8192], no edge length, or no line with
/// steps.
Image draw_curvature(const CurvaturePlot& plot, std::size_t width, std::size_t height,
                     const Color& background = RenderOptions().background);

}  // namespace talweg::picture
