#include "stress/planted_defects.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/generated_meshes.hpp"
#include "core/small_meshes.hpp"

namespace talweg::stress {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::uint32_t size_of(const auto& list) { return static_cast<std::uint32_t>(list.size()); }

/// Displaces a mesh smoothly and without symmetries.
void disturb(MeshLists& lists, double amount) {
  for (Point& p : lists.points) {
    const Point q = p;
    p += amount * Point(std::sin(1.7 * q.y() + 0.3 * q.z() + 0.1) + 0.3 * std::sin(4.1 * q.x()),
                        std::sin(1.3 * q.z() - 0.8 * q.x() + 0.4) + 0.3 * std::cos(3.7 * q.y()),
                        std::sin(2.1 * q.x() + 1.1 * q.y() + 0.9) + 0.3 * std::sin(5.3 * q.x()));
  }
}

/// The unit box with faces cut into four `levels` times.
MeshLists divided_box(int levels) {
  MeshLists lists = test::box();
  for (int level = 0; level < levels; ++level) {
    MeshLists finer;
    for (const Triangle& t : lists.triangles) {
      const std::uint32_t first = size_of(finer.points);
      for (std::size_t k = 0; k < 3; ++k) finer.points.push_back(lists.points[t[k]]);
      for (std::size_t k = 0; k < 3; ++k) {
        finer.points.push_back((lists.points[t[k]] + lists.points[t[(k + 1) % 3]]) / 2);
      }
      const auto face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        finer.triangles.push_back({first + a, first + b, first + c});
      };
      face(0, 3, 5);
      face(3, 1, 4);
      face(5, 4, 2);
      face(3, 4, 5);
    }
    // Corners at equal positions become one vertex. Coordinates are sums of halves, so equal
    // positions are exactly equal.
    lists = {};
    std::vector<std::uint32_t> number(finer.points.size());
    for (std::size_t v = 0; v < finer.points.size(); ++v) {
      const auto same = std::find(lists.points.begin(), lists.points.end(), finer.points[v]);
      number[v] = static_cast<std::uint32_t>(same - lists.points.begin());
      if (same == lists.points.end()) lists.points.push_back(finer.points[v]);
    }
    for (Triangle t : finer.triangles) {
      for (std::uint32_t& v : t) v = number[v];
      lists.triangles.push_back(t);
    }
  }
  return lists;
}

Triangle& any_face(MeshLists& lists, Random& random) {
  return lists.triangles[random.below(lists.triangles.size())];
}
Point& any_point(MeshLists& lists, Random& random) {
  return lists.points[random.below(lists.points.size())];
}

/// Splits a face into three by a new vertex at these barycentrics.
void split_face(MeshLists& lists, std::size_t face, const std::array<double, 3>& at) {
  const Triangle t = lists.triangles[face];
  const std::uint32_t v = size_of(lists.points);
  lists.points.push_back(at[0] * lists.points[t[0]] + at[1] * lists.points[t[1]] +
                         at[2] * lists.points[t[2]]);
  lists.triangles[face] = {t[0], t[1], v};
  lists.triangles.push_back({t[1], t[2], v});
  lists.triangles.push_back({t[2], t[0], v});
}

void duplicate_vertex(MeshLists& lists, Random& random) {
  Triangle& t = any_face(lists, random);
  std::uint32_t& corner = t[random.below(3)];
  lists.points.push_back(Point(lists.points[corner]));
  corner = size_of(lists.points) - 1;
}
void soup(MeshLists& lists, Random& random) {
  MeshLists apart;
  const bool rounded = random.one_in(2);
  for (Triangle t : lists.triangles) {
    for (std::uint32_t& v : t) {
      Point p = lists.points[v];
      if (rounded) p *= 1 + random.uniform(-1, 1) * 1e-16;
      apart.points.push_back(p);
      v = size_of(apart.points) - 1;
    }
    apart.triangles.push_back(t);
  }
  lists = apart;
}
void isolated_vertex(MeshLists& lists, Random& random) {
  const Point p = any_point(lists, random);
  lists.points.push_back(random.one_in(2) ? p : Point(p + Point(3, -2, 5)));
}
/// Adds an isolated vertex at the front, so that all ids move.
void isolated_first(MeshLists& lists, Random& random) {
  lists.points.insert(lists.points.begin(), Point(any_point(lists, random)));
  for (Triangle& t : lists.triangles) {
    for (std::uint32_t& v : t) ++v;
  }
}
void zero_area_split(MeshLists& lists, Random& random) {
  split_face(lists, random.below(lists.triangles.size()), {0.5, 0.5, 0});
}
void point_on_corner(MeshLists& lists, Random& random) {
  split_face(lists, random.below(lists.triangles.size()), {1, 0, 0});
}
void needle_split(MeshLists& lists, Random& random) {
  const double e = random.scale(1e-16, 1e-2);
  split_face(lists, random.below(lists.triangles.size()), {0.5, 0.5 - e, e});
}
void cap_split(MeshLists& lists, Random& random) {
  const double e = random.scale(1e-16, 1e-2);
  split_face(lists, random.below(lists.triangles.size()), {1 - 2 * e, e, e});
}
/// Many needles in one place: a face is split repeatedly beside the same side.
void needle_fan(MeshLists& lists, Random& random) {
  const std::size_t face = random.below(lists.triangles.size());
  const double ratio = random.scale(1e-6, 0.5);
  for (int k = 0; k < 12; ++k) split_face(lists, face, {0.5 - ratio / 2, 0.5 - ratio / 2, ratio});
}
void flipped_face(MeshLists& lists, Random& random) {
  Triangle& t = any_face(lists, random);
  std::swap(t[0], t[1]);
}
void flipped_half(MeshLists& lists, Random& random) {
  const std::size_t from = random.below(lists.triangles.size());
  for (std::size_t f = from; f < lists.triangles.size(); ++f) {
    std::swap(lists.triangles[f][0], lists.triangles[f][1]);
  }
}
void duplicate_face(MeshLists& lists, Random& random) {
  Triangle t = any_face(lists, random);
  if (random.one_in(2)) std::swap(t[0], t[1]);
  std::rotate(t.begin(), t.begin() + 1, t.end());
  lists.triangles.push_back(t);
}
void bow_tie(MeshLists& lists, Random& random) {
  const std::uint32_t v = size_of(lists.points), w = random.below32(lists.points.size());
  const Point p = lists.points[w];
  lists.points.push_back(p + Point(0.3, 0.1, 0.4));
  lists.points.push_back(p + Point(-0.2, 0.3, 0.4));
  lists.triangles.push_back({w, v, v + 1});
}
void merged_vertices(MeshLists& lists, Random& random) {
  const std::uint32_t a = random.below32(lists.points.size());
  const std::uint32_t b = random.below32(lists.points.size());
  for (Triangle& t : lists.triangles) {
    for (std::uint32_t& v : t) v = v == a ? b : v;
  }
}
void fin(MeshLists& lists, Random& random) {
  const Triangle t = any_face(lists, random);
  lists.points.push_back(any_point(lists, random) + Point(0, 0, 1));
  const std::uint32_t tip = size_of(lists.points) - 1;
  lists.triangles.push_back(random.one_in(2) ? Triangle{t[0], t[1], tip}
                                             : Triangle{t[1], t[0], tip});
}
void holes(MeshLists& lists, Random& random) {
  for (std::size_t k = 1 + random.below(10); k > 0 && lists.triangles.size() > 2; --k) {
    lists.triangles.erase(lists.triangles.begin() +
                          static_cast<std::ptrdiff_t>(random.below(lists.triangles.size())));
  }
}
void scattered_faces(MeshLists& lists, Random& random) {
  std::erase_if(lists.triangles, [&](const Triangle&) { return random.one_in(3); });
}
void not_finite(MeshLists& lists, Random& random) {
  const std::array<double, 4> values = {kNan, kInfinity, -kInfinity, 1e308};
  any_point(lists, random)[static_cast<Eigen::Index>(random.below(3))] = values[random.below(4)];
}
void index_out_of_range(MeshLists& lists, Random& random) {
  any_face(lists, random)[random.below(3)] = random.one_in(2) ? size_of(lists.points) : 0xFFFFFFFFU;
}
void repeated_corner(MeshLists& lists, Random& random) {
  Triangle& t = any_face(lists, random);
  t[0] = t[1];
}
void second_component(MeshLists& lists, Random& random) {
  const double dx = random.one_in(3) ? 0 : random.scale(1e-3, 1e5);
  lists = test::together(std::move(lists), random_mesh(random), dx);
}
void large_offset(MeshLists& lists, Random& random) {
  Point shift;  // a loop fixes the order of the random numbers; argument evaluation does not
  for (double& x : shift) x = random.uniform(-5e6, 5e6);
  for (Point& p : lists.points) p += shift;
}
void other_unit(MeshLists& lists, Random& random) {
  const std::array<double, 6> units = {1e-6, 1e6, 1e-3, 25.4, 1e-30, 1e30};
  const double unit = units[random.below(units.size())];
  for (Point& p : lists.points) p *= unit;
}
void single_precision(MeshLists& lists, Random&) {
  for (Point& p : lists.points) p = p.cast<float>().cast<double>();
  lists.single_precision = true;
}
void flattened(MeshLists& lists, Random& random) {
  const double factor = random.one_in(2) ? 0 : random.scale(1e-16, 1e-3);
  for (Point& p : lists.points) p.z() *= factor;
}
/// Folds the surface: two sheets at almost no distance.
void fold(MeshLists& lists, Random& random) {
  const double x = any_point(lists, random).x(), width = random.scale(1e-13, 1e-6);
  for (Point& p : lists.points) {
    if (p.x() > x) p.x() = x - (p.x() - x) + width;
  }
}
void point_elsewhere(MeshLists& lists, Random& random) {
  const Point p = any_point(lists, random);
  any_point(lists, random) = p;
}
void far_point(MeshLists& lists, Random& random) {
  any_point(lists, random) *= random.scale(10, 1e9);
}
void shuffled(MeshLists& lists, Random& random) {
  for (std::size_t f = lists.triangles.size(); f > 1; --f) {
    std::swap(lists.triangles[f - 1], lists.triangles[random.below(f)]);
  }
}
void no_faces(MeshLists& lists, Random& random) {
  lists.triangles.clear();
  if (random.one_in(2)) lists.points.clear();
}

constexpr Defect kDefects[] = {
    {"duplicate vertex", duplicate_vertex},
    {"soup", soup},
    {"isolated vertex", isolated_vertex},
    {"isolated first vertex", isolated_first},
    {"zero-area face", zero_area_split},
    {"point on a corner", point_on_corner},
    {"needle", needle_split},
    {"cap", cap_split},
    {"needle fan", needle_fan},
    {"flipped face", flipped_face},
    {"half flipped", flipped_half},
    {"duplicate face", duplicate_face},
    {"bow-tie", bow_tie},
    {"merged vertices", merged_vertices},
    {"fin", fin},
    {"holes", holes},
    {"scattered faces", scattered_faces},
    {"not finite", not_finite},
    {"index out of range", index_out_of_range},
    {"repeated corner", repeated_corner},
    {"second component", second_component},
    {"large offset", large_offset},
    {"other unit", other_unit},
    {"single precision", single_precision},
    {"flattened", flattened},
    {"fold", fold},
    {"point elsewhere", point_elsewhere},
    {"far point", far_point},
    {"shuffled", shuffled},
    {"no faces", no_faces},
};

/// Whether defects can be planted: the planters use the indices of faces.
bool can_be_planted_into(const MeshLists& lists) {
  const std::uint32_t count = size_of(lists.points);
  return !lists.triangles.empty() && count > 0 &&
         std::all_of(lists.triangles.begin(), lists.triangles.end(), [&](const Triangle& t) {
           return t[0] < count && t[1] < count && t[2] < count;
         });
}

}  // namespace

MeshLists random_mesh(Random& random) {
  MeshLists lists;
  const auto size = [&](std::size_t least, std::size_t most) {
    return static_cast<std::uint32_t>(least + random.below(most - least + 1));
  };
  // Braces fix the order of evaluation, unlike parentheses.
  const auto sizes = [&](std::array<std::uint32_t, 4> b) {
    return std::array{size(b[0], b[1]), size(b[2], b[3])};
  };
  switch (random.below(8)) {
    case 0: {
      const auto [columns, rows] = sizes({4, 24, 4, 24});
      return test::grid(columns, rows);
    }
    case 1:
      return test::moebius(size(12, 60));
    case 2:
      lists = divided_box(static_cast<int>(size(2, 3)));
      if (random.one_in(2)) return lists;
      break;
    case 3: {
      const auto [around, along] = sizes({6, 20, 8, 30});
      lists = test::torus(around, along);
      break;
    }
    case 4: {
      const auto [around, along] = sizes({6, 24, 4, 30});
      lists = test::tube(around, along, random.uniform(1, 12));
      break;
    }
    case 5: {
      const auto [columns, rows] = sizes({6, 30, 6, 24});
      lists = test::grid(columns, rows);
      for (Point& p : lists.points) p /= 6;
      break;
    }
    default:
      lists = test::sphere(static_cast<int>(size(2, 3)));
  }
  disturb(lists, random.uniform(0, 0.2));
  return lists;
}

std::span<const Defect> defects() { return kDefects; }

std::string plant_some(MeshLists& lists, Random& random) {
  std::string names;
  for (std::size_t k = random.below(4); k > 0; --k) {
    if (!can_be_planted_into(lists)) break;
    const Defect& defect = kDefects[random.below(std::size(kDefects))];
    defect.plant(lists, random);
    names += (names.empty() ? "" : ", ") + std::string(defect.name);
  }
  return names.empty() ? "clean" : names;
}

}  // namespace talweg::stress
