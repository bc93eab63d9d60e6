#include "talweg/core/space/triangle_contact.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace talweg {
namespace {

/// Relative to the product of the lengths of two vectors: far above the rounding of their product.
constexpr double kRounding = 1e-14;
/// Radians: an angle must exceed its rounding by at least this much to count.
constexpr double kAngle = 1e-12;

/// The corners of two triangles; corners at equal positions come first, in the same order.
struct TrianglePair {
  PointTriangle s, t;
  std::size_t shared = 0;

  TrianglePair(const PointTriangle& first, const PointTriangle& second) : s(first), t(second) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = shared; k < 3; ++k) {
        if (s[i] != t[k]) continue;
        std::swap(s[i], s[shared]);
        std::swap(t[k], t[shared]);
        ++shared;
        break;
      }
    }
  }
};

/// The range of a triangle's corners along an axis.
struct Interval {
  double low, high;
  Interval(const Point& axis, const Point& origin, const PointTriangle& t) {
    const double a = axis.dot(t[0] - origin), b = axis.dot(t[1] - origin),
                 c = axis.dot(t[2] - origin);
    low = std::min({a, b, c});
    high = std::max({a, b, c});
  }
};

/// Whether a plane separates two triangles without common corners.
class Separation {
 public:
  Separation(const PointTriangle& s, const PointTriangle& t) : s_(s), t_(t) {
    for (const PointTriangle* triangle : {&s, &t}) {
      for (const Point& p : *triangle) reach_ = std::max(reach_, (p - s[0]).norm());
    }
  }

  [[nodiscard]] bool found() const {
    PointTriangle e, f;
    for (std::size_t k = 0; k < 3; ++k) {
      e[k] = s_[(k + 1) % 3] - s_[k];
      f[k] = t_[(k + 1) % 3] - t_[k];
    }
    const Point m = e[0].cross(e[1]), n = f[0].cross(f[1]);
    if (across(m) || across(n)) return true;
    for (const Point& a : e) {
      for (const Point& b : f) {
        if (across(a.cross(b))) return true;
      }
    }
    // Axes for two triangles in one plane.
    return std::any_of(e.begin(), e.end(), [&](const Point& a) { return across(m.cross(a)); }) ||
           std::any_of(f.begin(), f.end(), [&](const Point& b) { return across(n.cross(b)); });
  }

 private:
  [[nodiscard]] bool across(const Point& axis) const {
    const double rounding = kRounding * axis.norm() * reach_;
    const Interval a(axis, s_[0], s_), b(axis, s_[0], t_);
    return b.low - a.high > rounding || a.low - b.high > rounding;
  }

  const PointTriangle& s_;
  const PointTriangle& t_;
  double reach_ = 0;
};

/// Whether a plane through the common corner separates the rest of two triangles. Each triangle
/// lies in the cone of its sides at the corner, so directions suffice.
class ConeSeparation {
 public:
  explicit ConeSeparation(const TrianglePair& pair) {
    for (std::size_t k = 0; k < 2; ++k) {
      p_[k] = (pair.s[k + 1] - pair.s[0]).normalized();
      q_[k] = (pair.t[k + 1] - pair.t[0]).normalized();
    }
  }

  [[nodiscard]] bool found() const {
    const Point m = p_[0].cross(p_[1]), n = q_[0].cross(q_[1]);
    if (over(p_, m, q_) || over(q_, n, p_)) return true;
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t k = 0; k < 2; ++k) {
        if (through(p_[i].cross(q_[k]), p_[1 - i], q_[1 - k])) return true;
      }
      if (beside(m, p_[i], p_[1 - i], q_) || beside(n, q_[i], q_[1 - i], p_)) return true;
    }
    return false;
  }

 private:
  using Two = std::array<Point, 2>;

  /// The side of the plane with normal `axis` on which a direction lies: 1, -1, or 0 in doubt.
  /// `axis` comes from a product of unit vectors that has lost accuracy by a factor 1 / `width`.
  static int side(const Point& axis, double width, const Point& direction) {
    const double length = axis.norm();
    if (!(length > 0 && width > 0)) return 0;
    const double slope = axis.dot(direction) / length;
    const double doubt = kAngle + kRounding / width;
    return slope > doubt ? 1 : slope < -doubt ? -1 : 0;
  }
  /// Whether the plane of the triangle `flat` separates. The other triangle lies on one side of the
  /// plane; a side of the other triangle may lie in the plane, outside `flat`.
  static bool over(const Two& flat, const Point& normal, const Two& other) {
    const int a = side(normal, normal.norm(), other[0]), b = side(normal, normal.norm(), other[1]);
    if (a != 0 && b != 0) return a == b;
    if (a == 0 && b == 0) return false;
    const Point& in_plane = a == 0 ? other[0] : other[1];
    for (std::size_t k = 0; k < 2; ++k) {
      const Point axis = normal.cross(flat[k]);
      const int own = side(axis, normal.norm(), flat[1 - k]);
      if (own != 0 && side(axis, normal.norm(), in_plane) == -own) return true;
    }
    return false;
  }
  /// Whether the plane through a side of each triangle separates; `p` and `q` are the other sides.
  static bool through(const Point& axis, const Point& p, const Point& q) {
    const int a = side(axis, axis.norm(), p);
    return a != 0 && a == -side(axis, axis.norm(), q);
  }
  /// Whether the plane through the side `flat`, perpendicular to its triangle, separates: `own`,
  /// the other side of the triangle, lies on one side of the plane and the other triangle beyond
  /// it. A side of the other triangle may lie in the plane if it points away from `flat`.
  static bool beside(const Point& normal, const Point& flat, const Point& own, const Two& other) {
    const Point axis = normal.cross(flat);
    const int a = side(axis, normal.norm(), own);
    if (a == 0) return false;
    int beyond = 0;
    for (const Point& q : other) {
      const int b = side(axis, normal.norm(), q);
      if (b == a || (b == 0 && !(q.dot(flat) < 0))) return false;
      beyond += b;
    }
    return beyond != 0;
  }

  Two p_, q_;
};

/// Whether two triangles with a common side do not fold onto each other.
bool fold_apart(const TrianglePair& pair) {
  const Point along = (pair.s[1] - pair.s[0]).normalized();
  const Point p = pair.s[2] - pair.s[0], q = pair.t[2] - pair.t[0];
  const Point across_p = p - p.dot(along) * along, across_q = q - q.dot(along) * along;
  const double width_p = across_p.norm() / p.norm(), width_q = across_q.norm() / q.norm();
  if (!(width_p > 0 && width_q > 0)) return false;
  const double doubt = kAngle + kRounding / width_p + kRounding / width_q;
  const Point a = across_p.normalized(), b = across_q.normalized();
  return a.dot(b) < -doubt || a.cross(b).norm() > doubt;
}

/// The place where a segment pierces a triangle: the distances of the ends of the segment from the
/// plane, and of the place from the nearest side. All zero if the segment does not pierce the
/// triangle.
struct Piercing {
  double before = 0, after = 0, inside = 0;

  Piercing(const Point& p, const Point& q, const PointTriangle& t) {
    const Point normal = (t[1] - t[0]).cross(t[2] - t[0]).stableNormalized();
    const double above = (p - t[0]).dot(normal), below = (q - t[0]).dot(normal);
    if (!((above > 0 && below < 0) || (above < 0 && below > 0))) return;
    const Point at = p + above / (above - below) * (q - p);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
      const Point inwards = normal.cross(t[(k + 1) % 3] - t[k]).stableNormalized();
      least = std::min(least, (at - t[k]).dot(inwards));
    }
    if (!(least > 0)) return;
    before = std::abs(above);
    after = std::abs(below);
    inside = least;
  }
};

}  // namespace

bool certainly_apart(const PointTriangle& s, const PointTriangle& t) {
  const TrianglePair pair(s, t);
  switch (pair.shared) {
    case 0:
      return Separation(s, t).found();
    case 1:
      return ConeSeparation(pair).found();
    case 2:
      return fold_apart(pair);
    default:
      return false;
  }
}

double piercing_depth(const Point& p, const Point& q, const PointTriangle& t) {
  const Piercing found(p, q, t);
  return std::max(0.0, std::min({found.before, found.after, found.inside}));
}

double crossing_depth(const PointTriangle& s, const PointTriangle& t) {
  double depth = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    depth = std::max(depth, piercing_depth(s[k], s[(k + 1) % 3], t));
    depth = std::max(depth, piercing_depth(t[k], t[(k + 1) % 3], s));
  }
  return depth;
}

double crossing_reach(const PointTriangle& s, const PointTriangle& t) {
  double reach = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    for (const Piercing& found :
         {Piercing(s[k], s[(k + 1) % 3], t), Piercing(t[k], t[(k + 1) % 3], s)}) {
      reach = std::max(reach, std::min(std::max(found.before, found.after), found.inside));
    }
  }
  return reach;
}

}  // namespace talweg
