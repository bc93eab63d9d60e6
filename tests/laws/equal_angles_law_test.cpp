// Renumbering on surfaces with many equal angles. Rounding depends on the numbers of vertices and
// faces, so it must not decide which of the equal angles is cleared first.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "laws/subjects.hpp"

namespace talweg {
namespace {

using Cell = std::array<int, 3>;

/// The two sheets of a gyroid in a cube of `cells` cells per side. Each cell is cut into six
/// tetrahedra, and the surface passes through the midpoints of edges between lattice points inside
/// and outside. The surface has many handles and only a few shapes of triangles.
class LatticeSurface {
 public:
  LatticeSurface(int cells, double periods) : cells_(cells), periods_(periods) {
    for (int i = 0; i < cells; ++i) {
      for (int j = 0; j < cells; ++j) {
        for (int k = 0; k < cells; ++k) add_cube({i, j, k});
      }
    }
  }
  [[nodiscard]] const MeshLists& lists() const { return lists_; }

 private:
  [[nodiscard]] bool is_inside(const Cell& at) const {
    for (const int c : at) {
      if (c < 2 || c > cells_ - 2) return false;
    }
    const double turn = 2 * std::numbers::pi * periods_ / cells_;
    const double x = turn * at[0], y = turn * at[1], z = turn * at[2];
    const double gyroid =
        std::sin(x) * std::cos(y) + std::sin(y) * std::cos(z) + std::sin(z) * std::cos(x);
    return gyroid * gyroid < 0.35;
  }

  std::uint32_t middle(const Cell& a, const Cell& b) {
    const auto [at, fresh] =
        middles_.emplace(std::minmax(a, b), static_cast<std::uint32_t>(lists_.points.size()));
    if (fresh) lists_.points.push_back((point(a) + point(b)) / 2);
    return at->second;
  }

  static Point point(const Cell& c) { return {double(c[0]), double(c[1]), double(c[2])}; }

  /// Adds a triangle that faces away from a corner inside.
  void add_triangle(Triangle t, const Cell& inside) {
    const auto& p = lists_.points;
    const Point normal = (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]);
    if (normal.dot(p[t[0]] - point(inside)) < 0) std::swap(t[1], t[2]);
    lists_.triangles.push_back(t);
  }

  void add_cube(const Cell& origin) {
    std::array<std::size_t, 3> axes = {0, 1, 2};
    do {
      std::array<Cell, 4> corners = {origin, origin, origin, origin};
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t later = k + 1; later < 4; ++later) ++corners[later][axes[k]];
      }
      add_tetrahedron(corners);
    } while (std::next_permutation(axes.begin(), axes.end()));
  }

  void add_tetrahedron(const std::array<Cell, 4>& corners) {
    std::vector<Cell> in, out;
    for (const Cell& c : corners) (is_inside(c) ? in : out).push_back(c);
    if (in.empty() || out.empty()) return;
    std::vector<std::uint32_t> cut;
    for (const Cell& a : in) {
      for (const Cell& b : out) cut.push_back(middle(a, b));
    }
    add_triangle({cut[0], cut[1], cut[2]}, in.front());
    if (cut.size() == 4) add_triangle({cut[1], cut[3], cut[2]}, in.front());
  }

  int cells_;
  double periods_;
  MeshLists lists_;
  std::map<std::pair<Cell, Cell>, std::uint32_t> middles_;
};

/// A mesh with renumbered vertices, and faces in another order with other first corners.
struct Renumbered {
  MeshLists lists;
  std::vector<std::uint32_t> fresh;

  explicit Renumbered(const MeshLists& from) : lists(from), fresh(from.points.size()) {
    std::mt19937 random(11);
    for (std::uint32_t v = 0; v < fresh.size(); ++v) fresh[v] = v;
    std::shuffle(fresh.begin(), fresh.end(), random);
    for (std::size_t v = 0; v < fresh.size(); ++v) lists.points[fresh[v]] = from.points[v];
    for (Triangle& t : lists.triangles) {
      for (std::uint32_t& v : t) v = fresh[v];
      std::rotate(t.begin(), t.begin() + random() % 3, t.end());
    }
    std::shuffle(lists.triangles.begin(), lists.triangles.end(), random);
  }
};

long handles_of(const SurfaceMesh& mesh) {
  const auto count = [](std::size_t n) { return static_cast<long>(n); };
  const Surface& surface = mesh.surface();
  return 1 - (count(surface.vertex_count()) - count(surface.edge_count()) +
              count(surface.face_count())) /
                 2;
}

TEST(EqualAnglesLaw, RenumberingChangesNoGeodesicAndNoResultOfThePapersMethod) {
  for (const auto& [cells, periods] : {std::pair(14, 1.0), std::pair(18, 1.5)}) {
    const LatticeSurface lattice(cells, periods);
    const Renumbered other(lattice.lists());
    const auto opened = OpenedMesh::open(lattice.lists());
    ASSERT_GE(handles_of(opened->mesh()), 6);
    CurveSmoother own(opened), renumbered(OpenedMesh::open(other.lists));
    std::mt19937 random(3);
    for (int k = 0; k < 24; ++k) {
      const bool closed = k % 2 == 0;
      std::vector<VertexId> ways;
      for (int i = 0; i < (closed ? 3 : 2); ++i) {
        ways.emplace_back(random() % lattice.lists().points.size());
      }
      const test::Subject::Drawing drawn{draw_edge_path(opened->surface(), ways, closed), closed};
      test::Subject::Drawing renamed = drawn;
      for (VertexId& v : renamed.path) v = VertexId{other.fresh[v.index()]};
      own.set_curve(test::curve_of(opened->surface(), drawn), test::kPapers);
      renumbered.set_curve(test::curve_of(renumbered.opened().surface(), renamed), test::kPapers);
      for (const double tau : {0.0, 0.1, 1.0}) {
        const SmoothingResult expected = own.smooth(tau), found = renumbered.smooth(tau);
        EXPECT_EQ(found.report().termination, expected.report().termination);
        EXPECT_LE(test::curve_gap(positions_of(renumbered.opened().mesh(), found.curve()),
                                  positions_of(opened->mesh(), expected.curve()), closed),
                  1e-9 * test::diameter_of(lattice.lists()))
            << "drawing " << k << ", tau = " << tau;
      }
    }
  }
}

}  // namespace
}  // namespace talweg
