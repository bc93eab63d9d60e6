#include "talweg/core/smoothing/taut_stretches.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "talweg/core/measure/measures.hpp"

namespace talweg {
namespace {

constexpr double kStraight = 1e-6;  // rad: less is rounding
constexpr double kSame = 1e-6;      // of the spacing

}  // namespace

/// The curve from one of its points on.
struct TautStretches::Course {
  std::vector<std::size_t> points;  // of the curve; of a loop the first one comes last, too
  std::vector<double> arcs;         // of these
  double begin = 0;                 // where it begins on the curve
  std::vector<double> bends;        // where it is not straight, ascending
};

/// A place of a stretch that stays.
struct TautStretches::Mark {
  double arc = 0;
  bool begins = false, ends = false;  // the stretch
};

TautStretches::TautStretches(const Surface& surface, const SurfaceCurve& curve)
    : surface_(&surface), curve_(&curve) {
  const std::size_t n = curve.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    arcs_.push_back(length_);
    if (i + 1 == n && !curve.closed) break;
    const SurfacePoint &p = curve.points[i], &q = curve.points[(i + 1) % n];
    segments_.push_back(segment_between(surface, p, q, common_face(surface, p, q)));
    length_ += segments_.back().length;
  }
}

void TautStretches::merge(std::vector<Part>& parts) {
  std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
    return a.from != b.from ? a.from < b.from : a.to < b.to;
  });
  std::vector<Part> merged;
  for (const Part& part : parts) {
    if (!merged.empty() && part.from <= merged.back().to) {
      merged.back().to = std::max(merged.back().to, part.to);
    } else {
      merged.push_back(part);
    }
  }
  parts = std::move(merged);
}

void TautStretches::add(double arc, double margin) {
  const double from = arc - margin, to = arc + margin;
  parts_.push_back({std::max(from, 0.0), std::min(to, length_)});
  if (curve_->closed && from < 0) parts_.push_back({std::max(from + length_, 0.0), length_});
  if (curve_->closed && to > length_) parts_.push_back({0, std::min(to - length_, length_)});
  merge(parts_);
}

bool TautStretches::contain(double arc) const {
  return std::any_of(parts_.begin(), parts_.end(),
                     [&](const Part& part) { return part.from <= arc && arc <= part.to; });
}

/// The point of a loop nearest to the middle of the longest way between two stretches.
std::size_t TautStretches::first_outside() const {
  if (!curve_->closed) return 0;
  double longest = 0, middle = 0;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const double next = k + 1 < parts_.size() ? parts_[k + 1].from : parts_[0].from + length_;
    const double gap = next - parts_[k].to;
    if (gap <= longest) continue;
    longest = gap;
    middle = std::fmod(parts_[k].to + gap / 2, length_);
  }
  const auto away = [&](double arc) {
    const double apart = std::abs(arc - middle);
    return std::min(apart, length_ - apart);
  };
  const auto nearest = std::min_element(arcs_.begin(), arcs_.end(),
                                        [&](double a, double b) { return away(a) < away(b); });
  return static_cast<std::size_t>(nearest - arcs_.begin());
}

TautStretches::Course TautStretches::course_from(std::size_t first) const {
  const std::vector<SurfacePoint>& points = curve_->points;
  const std::size_t n = points.size();
  Course course;
  course.begin = arcs_[first];
  for (std::size_t k = 0; k < n + (curve_->closed ? 1 : 0); ++k) {
    const std::size_t i = (first + k) % n;
    course.points.push_back(i);
    course.arcs.push_back(arcs_[i] - course.begin + (k > 0 && i <= first ? length_ : 0));
    const bool is_end = k == 0 || k == n || (!curve_->closed && k + 1 == n);
    if (is_end) continue;
    const double turn =
        turning_angle(*surface_, points[(i + n - 1) % n], points[i], points[(i + 1) % n]);
    if (points[i].is_vertex() || turn > kStraight) course.bends.push_back(course.arcs.back());
  }
  return course;
}

/// The stretches on a course, each grown until it is straight about its ends.
std::vector<TautStretches::Part> TautStretches::settled(const Course& course,
                                                        double spacing) const {
  std::vector<Part> parts;
  for (const Part& part : parts_) {
    const bool turned = part.from < course.begin;
    const double shift = (turned ? length_ : 0) - course.begin;
    parts.push_back({part.from + shift, part.to + shift});
  }
  merge(parts);
  for (Part& part : parts) {
    for (std::size_t k = course.bends.size(); k > 0; --k) {
      const double bend = course.bends[k - 1];
      if (bend < part.from + 2 * spacing && bend > part.from - spacing) {
        part.from = bend - 2 * spacing;
      }
    }
    for (const double bend : course.bends) {
      if (bend > part.to - 2 * spacing && bend < part.to + spacing) part.to = bend + 2 * spacing;
    }
    if (part.from < 2 * spacing) part.from = 0;
    if (part.to > length_ - 2 * spacing) part.to = length_;
  }
  merge(parts);
  return parts;
}

/// Between two of them the curve is straight, and there is no room for a free sample.
std::vector<TautStretches::Mark> TautStretches::marks_on(const Course& course,
                                                         const std::vector<Part>& parts,
                                                         double spacing) const {
  std::vector<Mark> marks;
  for (const Part& part : parts) {
    std::vector<double> places{part.from};
    for (const double bend : course.bends) {
      if (bend > part.from && bend < part.to) places.push_back(bend);
    }
    places.push_back(part.to);
    marks.push_back({part.from, true});
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
      const double from = places[k], to = places[k + 1];
      const double joins = std::max(1.0, std::ceil((to - from) / spacing));
      for (double i = 1; i < joins; ++i) marks.push_back({from + (to - from) * i / joins});
      marks.push_back({to, false, k + 2 == places.size()});
    }
  }
  return marks;
}

/// The course with a point at each mark; these points stay.
HeldCurve TautStretches::marked(const Course& course, const std::vector<Mark>& marks,
                                double spacing) const {
  HeldCurve result{{curve_->closed, {}}, {}, {}, {}, 0, curve_->points.front()};
  std::vector<SurfacePoint>& points = result.curve.points;
  const auto stay = [&](const Mark& mark) {
    if (result.fixed.empty() || result.fixed.back() + 1 < points.size()) {
      result.fixed.push_back(points.size() - 1);
    }
    if (mark.begins) result.ends.push_back({points.back(), points.back()});
    if (mark.ends) result.ends.back()[1] = points.back();
    if (!mark.begins && !mark.ends) result.corners.push_back(points.back());
  };
  const double same = kSame * spacing;
  const std::size_t n = curve_->points.size();
  for (std::size_t i = 0, m = 0; i < n; ++i) {
    points.push_back(curve_->points[course.points[i]]);
    for (; m < marks.size() && marks[m].arc <= course.arcs[i] + same; ++m) stay(marks[m]);
    if (i + 1 == course.points.size()) break;
    const CurveSegment& segment = segments_[course.points[i]];
    for (; m < marks.size() && marks[m].arc < course.arcs[i + 1] - same; ++m) {
      const double part = (marks[m].arc - course.arcs[i]) / segment.length;
      points.push_back(segment.point(*surface_, part));
      stay(marks[m]);
    }
  }
  return result;
}

/// The point at a place of the course.
SurfacePoint TautStretches::at(const Course& course, double arc) const {
  const auto after = std::upper_bound(course.arcs.begin(), course.arcs.end(), arc);
  const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(
      0, std::min(after - course.arcs.begin(), std::ssize(course.arcs) - 1) - 1));
  const CurveSegment& segment = segments_[course.points[i]];
  const double part = segment.length > 0 ? (arc - course.arcs[i]) / segment.length : 0;
  return segment.point(*surface_, std::clamp(part, 0.0, 1.0));
}

std::optional<HeldCurve> TautStretches::held(double spacing) {
  const Course course = course_from(first_outside());
  const std::vector<Part> parts = settled(course, spacing);
  const double first = parts.front().from, last = parts.back().to;
  const bool nothing_left =
      curve_->closed ? first <= 0 || last >= length_ : parts.size() == 1 && last - first >= length_;
  if (nothing_left) return std::nullopt;
  HeldCurve result = marked(course, marks_on(course, parts, spacing), spacing);
  double longest = 0;
  parts_.clear();
  for (const Part& part : parts) {
    const double size = part.to - part.from;
    add(std::fmod(course.begin + (part.from + part.to) / 2, length_), size / 2);
    result.share += size / length_;
    if (size <= longest) continue;
    longest = size;
    result.middle = at(course, (part.from + part.to) / 2);
  }
  return result;
}

}  // namespace talweg
