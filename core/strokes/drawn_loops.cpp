#include "talweg/core/strokes/drawn_loops.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace talweg {
namespace {

std::string told_of(const ClosedLoop& loop) {
  if (loop.cut > loop.gap) {
    return fmt::format(
        "A curve runs over its own beginning; {:.3g} mesh units at its ends were left out, and it "
        "is taken as a loop.",
        loop.cut);
  }
  return fmt::format("The ends of a curve lie {:.3g} mesh units apart; it is taken as a loop.",
                     loop.gap);
}

}  // namespace

SnappedDrawing with_loops_closed(const SurfaceMesh& mesh, SnappedDrawing drawing,
                                 StraightLines& lines, CurveEnds ends) {
  if (ends == CurveEnds::kOpen) return drawing;
  for (std::size_t c = 0; c < drawing.curves.size(); ++c) {
    const bool always = ends == CurveEnds::kClosed;
    if (!always && (c >= drawing.may_be_loop.size() || !drawing.may_be_loop[c])) continue;
    std::optional<ClosedLoop> loop = closed_loop(mesh, drawing.curves[c], lines, always);
    if (!loop) continue;
    drawing.curves[c] = std::move(loop->curve);
    drawing.told.push_back(told_of(*loop));
  }
  return drawing;
}

}  // namespace talweg
