#include "talweg/core/strokes/strand_gap.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "talweg/core/space/nearest_segment.hpp"
#include "talweg/core/strokes/even_stroke.hpp"

namespace talweg {
namespace {

constexpr double kParallel = 0.82;  // the least cosine between strands: 35 degrees
constexpr double kBeside = 0.57;    // the largest cosine between a strand and the way across
constexpr double kDrawsTogether = 1.0 / 3;  // the largest change of the gap, per length
constexpr std::size_t kOn = 8;              // steps back and forth at which the gap is compared

class Strands {
 public:
  Strands(const SurfaceMesh& mesh, const SurfaceCurve& stroke, double step)
      : stroke_(even_stroke(mesh, stroke, step)),
        at_(stroke_.at),
        closed_(stroke.closed),
        step_(stroke_.step) {}

  [[nodiscard]] std::size_t size() const { return at_.size(); }
  [[nodiscard]] const std::vector<Point>& points() const { return at_; }
  [[nodiscard]] bool on_one_side(std::size_t i, std::size_t j) const {
    return stroke_.normal[i].dot(stroke_.normal[j]) > 0;
  }
  [[nodiscard]] bool has_neighbours(std::size_t i) const {
    return closed_ || (i >= kOn && i + kOn < size());
  }
  [[nodiscard]] double way_between(std::size_t i, std::size_t j) const {
    const std::size_t steps = i > j ? i - j : j - i;
    return step_ * static_cast<double>(closed_ ? std::min(steps, size() - steps) : steps);
  }
  [[nodiscard]] double gap(std::size_t i, std::size_t j) const { return (at_[j] - at_[i]).norm(); }

  [[nodiscard]] bool run_beside(std::size_t i, std::size_t j) const {
    const Point a = direction(i), b = direction(j);
    const double along = a.dot(b), gap = this->gap(i, j);
    if (std::abs(along) < kParallel) return false;
    const Point across = (at_[j] - at_[i]) / gap;
    if (std::max(std::abs(across.dot(a)), std::abs(across.dot(b))) > kBeside) return false;
    const bool same_way = along > 0;
    const double most = kDrawsTogether * step_ * static_cast<double>(kOn);
    return std::abs(this->gap(moved(i, true), moved(j, same_way)) - gap) < most &&
           std::abs(this->gap(moved(i, false), moved(j, !same_way)) - gap) < most;
  }

 private:
  [[nodiscard]] std::size_t moved(std::size_t i, bool on) const {
    return (i + (on ? kOn : size() - kOn)) % size();
  }
  [[nodiscard]] Point direction(std::size_t i) const {
    return (at_[moved(i, true)] - at_[moved(i, false)]).normalized();
  }

  EvenStroke stroke_;
  const std::vector<Point>& at_;
  bool closed_;
  double step_;
};

}  // namespace

double strand_gap(const SurfaceMesh& mesh, const SurfaceCurve& stroke, double step, double apart,
                  double least, double most) {
  const Strands strands(mesh, stroke, step);
  double gap = HUGE_VAL;
  if (strands.size() < 2 * kOn + 2) return gap;
  const NearestSegment segments(segments_of(strands.points(), stroke.closed));
  for (std::size_t i = 0; i < strands.size(); ++i) {
    if (!strands.has_neighbours(i)) continue;
    const Point &at = strands.points()[i], reach = Point::Constant(most);
    const SpaceBox box{at - reach, at + reach};
    segments.visit_near(box, [&](std::size_t j) {
      if (j <= i || !strands.has_neighbours(j)) return;
      const double here = strands.gap(i, j);
      if (here < least || here > most || here >= gap) return;
      if (strands.way_between(i, j) >= apart && strands.on_one_side(i, j) &&
          strands.run_beside(i, j)) {
        gap = here;
      }
    });
  }
  return gap;
}

}  // namespace talweg
