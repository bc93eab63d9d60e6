#include "talweg/core/cutting/lid_sinking.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace talweg {
namespace {

/// Divides the triangles of a lid along the inner points of their sides.
class Divider {
 public:
  Divider(const LidClearance& clearance, const Lid& lid, std::uint32_t first)
      : clearance_(clearance),
        old_(lid),
        next_(first + static_cast<std::uint32_t>(lid.inner.size())) {
    lid_.inner = lid.inner;
    lid_.plane = lid.plane;
  }

  void add_point(const Chord& c) {
    middle_[c] = next_++;
    lid_.inner.push_back((clearance_.at(old_, c.first) + clearance_.at(old_, c.second)) / 2);
  }
  void divide(const Triangle& t) {
    std::array<std::uint32_t, 3> m{};
    std::size_t points = 0, with = 0, without = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto found = middle_.find(chord(t[k], t[(k + 1) % 3]));
      m[k] = found == middle_.end() ? kNone : found->second;
      (m[k] == kNone ? without : with) = k;
      if (m[k] != kNone) ++points;
    }
    const auto corner = [&](std::size_t k) { return t[k % 3]; };
    if (points == 0) {
      add(t);
    } else if (points == 1) {
      add({corner(with), m[with], corner(with + 2)});
      add({m[with], corner(with + 1), corner(with + 2)});
    } else if (points == 2) {
      // Cuts off the corner between the two sides with a point.
      const std::size_t a = without + 2;
      const std::uint32_t before = m[(a + 2) % 3], after = m[a % 3];
      add({corner(a), after, before});
      add({before, after, corner(a + 1)});
      add({before, corner(a + 1), corner(a + 2)});
    } else {
      for (std::size_t k = 0; k < 3; ++k) add({corner(k), m[k], m[(k + 2) % 3]});
      add({m[0], m[1], m[2]});
    }
  }
  void fan(const Triangle& t) {
    lid_.inner.push_back(
        (clearance_.at(old_, t[0]) + clearance_.at(old_, t[1]) + clearance_.at(old_, t[2])) / 3);
    for (std::size_t k = 0; k < 3; ++k) add({t[k], t[(k + 1) % 3], next_});
    ++next_;
  }
  Lid take() { return std::move(lid_); }

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
  void add(const Triangle& t) { lid_.triangles.push_back(t); }

  const LidClearance& clearance_;
  const Lid& old_;
  std::uint32_t next_;
  std::map<Chord, std::uint32_t> middle_;
  Lid lid_;
};

struct Plumb {
  double x, y, height;
};

/// The part of a triangle above or below another triangle, clipped in the projection along the
/// heights.
std::vector<Plumb> part_over(const std::array<Plumb, 3>& below,
                             const std::array<Plumb, 3>& triangle) {
  std::vector<Plumb> part(triangle.begin(), triangle.end());
  const double turn = (below[1].x - below[0].x) * (below[2].y - below[0].y) -
                      (below[1].y - below[0].y) * (below[2].x - below[0].x);
  for (std::size_t k = 0; k < 3 && !part.empty(); ++k) {
    const Plumb &a = below[k], &b = below[(k + 1) % 3];
    const auto inside = [&](const Plumb& p) {
      const double side = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
      return turn > 0 ? side : -side;
    };
    std::vector<Plumb> kept;
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Plumb &p = part[i], &q = part[(i + 1) % part.size()];
      const double s = inside(p), t = inside(q);
      if (s >= 0) kept.push_back(p);
      if ((s > 0 && t < 0) || (s < 0 && t > 0)) {
        const double u = s / (s - t);
        kept.push_back(
            {p.x + u * (q.x - p.x), p.y + u * (q.y - p.y), p.height + u * (q.height - p.height)});
      }
    }
    part = std::move(kept);
  }
  return part;
}

std::array<double, 3> barycentric(const std::array<Plumb, 3>& t, const Plumb& p) {
  const auto area = [](const Plumb& a, const Plumb& b, const Plumb& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  };
  const double whole = area(t[0], t[1], t[2]);
  std::array<double, 3> result{};
  for (std::size_t k = 0; k < 3; ++k) {
    result[k] = std::clamp(area(p, t[(k + 1) % 3], t[(k + 2) % 3]) / whole, 0.0, 1.0);
  }
  return result;
}

class Sinker {
 public:
  Sinker(Lid& lid, const LidClearance& clearance, const std::set<std::uint32_t>& parts,
         const std::optional<Point>& direction, double extent)
      : lid_(lid),
        clearance_(clearance),
        parts_(parts),
        direction_(direction),
        extent_(extent),
        start_(lid.inner) {}

  double run() {
    constexpr int kRounds = 64;
    constexpr std::size_t kMostFaces = 4'000'000;  // about a second
    const std::size_t most = clearance_.faces_seen() + kMostFaces;
    double moved = 0;
    for (int round = 0; round < kRounds && moved <= extent_; ++round) {
      if (clearance_.faces_seen() >= most || !move_once()) break;
      for (std::size_t i = 0; i < start_.size(); ++i) {
        moved = std::max(moved, (lid_.inner[i] - start_[i]).norm());
      }
    }
    return moved;
  }

 private:
  using Contacts = std::span<const LidClearance::Contact>;

  bool move_once() {
    const auto contacts = clearance_.contacts_with_piece(lid_, parts_);
    bool changed = false;
    for (auto at = contacts.begin(); at != contacts.end();) {
      const auto end = std::find_if(at, contacts.end(),
                                    [&](const auto& c) { return c.triangle != at->triangle; });
      if (choose_up({&*at, static_cast<std::size_t>(end - at)})) {
        for (auto contact = at; contact != end; ++contact) {
          changed = leave_behind(*contact) || changed;
        }
      }
      at = end;
    }
    return changed;
  }

  /// Chooses the direction in which a triangle moves away from its contacts. False if there is
  /// none.
  bool choose_up(Contacts contacts) {
    up_ = direction_.value_or(Point::Zero());
    if (!direction_) {
      for (const auto& [triangle, face] : contacts) {
        up_ -= (face[1] - face[0]).cross(face[2] - face[0]);
      }
      up_ = up_.stableNormalized();
    }
    if (!(up_.norm() > 0.5)) return false;
    x_ = up_.unitOrthogonal();
    y_ = up_.cross(x_);
    return true;
  }

  [[nodiscard]] Plumb plumb(const Point& p) const {
    const Point from = p - origin();
    return {from.dot(x_), from.dot(y_), from.dot(up_)};
  }
  [[nodiscard]] const Point& origin() const { return start_.front(); }
  [[nodiscard]] std::array<Plumb, 3> plumb(const PointTriangle& t) const {
    return {plumb(t[0]), plumb(t[1]), plumb(t[2])};
  }

  /// Lifts a triangle of the lid above the part of a contact that lies over or under it. Tells
  /// whether the triangle moved.
  bool leave_behind(const LidClearance::Contact& contact) {
    const Triangle& t = lid_.triangles[contact.triangle];
    std::array<Plumb, 3> own = plumb(clearance_.at(lid_, t));
    bool changed = false;
    for (const Plumb& p : part_over(own, plumb(contact.other))) {
      changed = lift(t, own, p) || changed;
    }
    return changed;
  }

  /// Lifts the inner corners until the triangle passes above `place`, with the least sum of squared
  /// moves.
  bool lift(const Triangle& t, std::array<Plumb, 3>& own, const Plumb& place) {
    constexpr double kMargin = 1e-3, kLeast = 1e-9;
    const std::array<double, 3> b = barycentric(own, place);
    const std::uint32_t first = clearance_.first_inner();
    double share = 0, squares = 0, height = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      height += b[k] * own[k].height;
      if (t[k] < first) continue;
      share += b[k];
      squares += b[k] * b[k];
    }
    const double missing = place.height + kMargin * extent_ * share - height;
    if (!(share > kLeast && missing > 1e-3 * kMargin * extent_ * share)) return false;
    for (std::size_t k = 0; k < 3; ++k) {
      if (t[k] < first) continue;
      const double by = missing * b[k] / squares;
      own[k].height += by;
      lid_.inner[t[k] - first] += by * up_;
    }
    return true;
  }

  Lid& lid_;
  const LidClearance& clearance_;
  const std::set<std::uint32_t>& parts_;
  std::optional<Point> direction_;
  double extent_;
  Point up_, x_, y_;
  std::vector<Point> start_;
};

}  // namespace

Lid with_inner_points(const LidClearance& clearance, const Lid& lid, std::span<const Loop> rims,
                      std::span<const Chord> chords) {
  Divider divider(clearance, lid, clearance.first_inner());
  if (lid.triangles.size() == 1) {
    divider.fan(lid.triangles[0]);
    return divider.take();
  }
  std::set<Chord> wanted(chords.begin(), chords.end());
  if (wanted.empty()) {
    for (const Triangle& t : lid.triangles) {
      for (std::size_t k = 0; k < 3; ++k) wanted.insert(chord(t[k], t[(k + 1) % 3]));
    }
    for (const Loop& rim : rims) {
      for (std::size_t i = 0; i < rim.size(); ++i) {
        wanted.erase(chord(rim[i], rim[(i + 1) % rim.size()]));
      }
    }
  }
  for (const Chord& c : wanted) divider.add_point(c);
  for (const Triangle& t : lid.triangles) divider.divide(t);
  return divider.take();
}

double sink(Lid& lid, const LidClearance& clearance, const std::set<std::uint32_t>& parts,
            const std::optional<Point>& direction, double extent) {
  if (lid.inner.empty()) return 0;
  return Sinker(lid, clearance, parts, direction, extent).run();
}

}  // namespace talweg
