#include "comb.hpp"

#include <algorithm>
#include <cmath>

namespace talweg::editing {
namespace {

/// Whether the point of a curve lies in a triangle or on its rim.
bool lies_in(const MeshArrays& mesh, const host::Curve& curve, std::size_t point,
             std::uint32_t face) {
  const auto& corners = mesh.triangles.at(face);
  for (std::size_t i = 0; i < 3; ++i) {
    if (curve.barycentrics[point][i] == 0) continue;
    const std::uint32_t v = mesh.triangles.at(curve.faces[point])[i];
    if (std::find(corners.begin(), corners.end(), v) == corners.end()) return false;
  }
  return true;
}

Vector unit(const Vector& a) {
  const double size = length(a);
  return size > 0 ? times(1 / size, a) : a;
}

Vector normal_of(const MeshArrays& mesh, std::uint32_t face) {
  const auto& t = mesh.triangles.at(face);
  const Vector& a = mesh.positions[t[0]];
  return unit(cross(minus(mesh.positions[t[1]], a), minus(mesh.positions[t[2]], a)));
}

/// A polyline on the surface, with the direction and the face normal of each segment.
class Line {
 public:
  Line(const MeshArrays& mesh, const host::Curve& curve) : curve_(curve) {
    const std::size_t n = curve.positions.size();
    for (std::size_t k = 0; k + (curve.closed ? 0 : 1) < n; ++k) {
      const std::size_t next = (k + 1) % n;
      const Vector step = minus(curve.positions[next], curve.positions[k]);
      starts_.push_back(length_);
      length_ += editing::length(step);
      along_.push_back(unit(step));
      const std::uint32_t face = curve.faces[k], other = curve.faces[next];
      normals_.push_back(lies_in(mesh, curve, next, face) ? normal_of(mesh, face)
                                                          : normal_of(mesh, other));
    }
  }
  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] std::size_t segment_at(double s) const {
    const auto after = std::upper_bound(starts_.begin(), starts_.end(), s);
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - starts_.begin() - 1, 0));
  }
  [[nodiscard]] Vector at(double s) const {
    const std::size_t k = segment_at(s);
    return plus(curve_.positions[k], times(s - starts_[k], along_[k]));
  }
  [[nodiscard]] Vector left(double s) const {
    const std::size_t k = segment_at(s);
    return unit(cross(normals_[k], along_[k]));
  }
  [[nodiscard]] double place(std::size_t point) const {
    return point < starts_.size() ? starts_[point] : length_;
  }
  /// 1 if the line turns left at a point, -1 if it turns right, 0 at the start of an open line. The
  /// sum of both normals decides: a straight line over an edge turns with the surface, not to a
  /// side.
  [[nodiscard]] double side(std::size_t point) const {
    const std::size_t n = along_.size();
    if (point == 0 && !curve_.closed) return 0;
    const std::size_t in = (point + n - 1) % n, out = point % n;
    return dot(plus(normals_[in], normals_[out]), cross(along_[in], along_[out])) < 0 ? -1 : 1;
  }

 private:
  const host::Curve& curve_;
  std::vector<double> starts_;
  std::vector<Vector> along_, normals_;
  double length_ = 0;
};

/// The sum of a curve's turns up to a place; left turns are positive.
class Turning {
 public:
  Turning(const Line& line, const host::Curve& curve, const std::vector<double>& turns)
      : total_length_(line.length()), closed_(curve.closed) {
    for (std::size_t k = 0; k < turns.size(); ++k) {
      places_.push_back(line.place(k));
      sums_.push_back((sums_.empty() ? 0 : sums_.back()) + line.side(k) * turns[k]);
    }
  }
  /// The mean curvature between two places. On an open curve, places beyond an end are moved to it.
  [[nodiscard]] double mean(double from, double to) const {
    if (!closed_) {
      from = std::max(from, 0.0);
      to = std::min(to, total_length_);
    }
    return (up_to(to) - up_to(from)) / (to - from);
  }

 private:
  [[nodiscard]] double up_to(double s) const {
    const double rounds = closed_ ? std::floor(s / total_length_) : 0;
    const auto after = std::upper_bound(places_.begin(), places_.end(), s - rounds * total_length_);
    const double within =
        after == places_.begin() ? 0 : sums_[static_cast<std::size_t>(after - places_.begin()) - 1];
    return rounds * sums_.back() + within;
  }

  std::vector<double> places_, sums_;
  double total_length_;
  bool closed_;
};

}  // namespace

std::vector<Tooth> comb_of(const MeshArrays& mesh, const host::Curve& curve, double spacing) {
  const auto turns = std::find_if(curve.fields.begin(), curve.fields.end(),
                                  [](const host::Field& f) { return f.name == "curvature"; });
  if (turns == curve.fields.end()) throw Error("The curvature of the curve is not known.");
  if (!(spacing > 0)) throw Error("The spacing of a comb must be more than 0.");
  const Line line(mesh, curve);
  std::vector<Tooth> teeth;
  if (!(line.length() > 0)) return teeth;
  const Turning turning(line, curve, turns->values);
  const auto gaps = static_cast<std::size_t>(std::max(1.0, std::ceil(line.length() / spacing)));
  const double gap = line.length() / static_cast<double>(gaps);
  for (std::size_t k = 0; k < gaps + (curve.closed ? 0 : 1); ++k) {
    const double s = static_cast<double>(k) * gap;
    const double curvature = turning.mean(s - gap, s + gap);
    teeth.push_back({line.at(s), times(curvature > 0 ? -1 : 1, line.left(s)), std::abs(curvature)});
  }
  return teeth;
}

}  // namespace talweg::editing
