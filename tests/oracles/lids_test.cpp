// Pieces of a cut with lids, against CGAL: closed manifolds without self-intersections if the mesh
// had none; and the predicate for two triangles.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/jagged_curves.hpp"
#include "core/reference_data.hpp"
#include "polygon_soup.hpp"
#include "stress/random.hpp"
#include "talweg/core/cutting/loop_filling.hpp"
#include "talweg/core/cutting/mesh_cutting.hpp"
#include "talweg/core/cutting/seam_opening.hpp"
#include "talweg/core/mesh/mesh_inspection.hpp"
#include "talweg/core/space/triangle_contact.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

using stress::Random;
using test::Soup;

/// A jagged loop around a vertex, along edges.
std::optional<SurfaceCurve> loop_about(const SurfaceMesh& mesh, Random& random) {
  const VertexId v{random.below(mesh.points().size())};
  const FaceId face = faces_at(mesh.surface(), SurfacePoint::at_vertex(mesh.surface(), v)).front();
  const auto c = mesh.surface().corners(face);
  const Point n =
      (mesh.point(c[1]) - mesh.point(c[0])).cross(mesh.point(c[2]) - mesh.point(c[0])).normalized();
  const Point u = n.unitOrthogonal();
  const double r = random.scale(1.5, 12) * mesh.mean_edge_length();
  const double stretch = random.uniform(0.5, 1);
  try {
    return test::drawn_near(
        mesh, test::circle(mesh.point(v), r * u, stretch * r * n.cross(u), 5 + random.below32(10)),
        true);
  } catch (const Error&) {
    return std::nullopt;  // fewer than three different vertices, or vertices of other parts
  }
}

struct Count {
  std::size_t pieces = 0, closed = 0, touching = 0, refused = 0, lids_with_points = 0;
};

/// The number of pairs of intersecting faces, one of them with a number from `first` on.
std::size_t meetings(const Soup::Mesh& mesh, std::size_t first) {
  std::vector<std::pair<Soup::Mesh::Face_index, Soup::Mesh::Face_index>> pairs;
  CGAL::Polygon_mesh_processing::self_intersections<CGAL::Sequential_tag>(
      mesh, std::back_inserter(pairs));
  return static_cast<std::size_t>(std::count_if(pairs.begin(), pairs.end(), [&](const auto& pair) {
    return pair.first.idx() >= first || pair.second.idx() >= first;
  }));
}

void check_pieces(const SurfaceMesh& mesh, const SurfaceCurve& curve, Count& count) {
  const CutMesh cut = cut_along(mesh, std::span(&curve, 1));
  const OpenedSeams seams = open_seams(cut.lists, cut.chains);
  for (std::size_t k = 0; k < seams.pieces; ++k) {
    std::vector<bool> wanted(seams.pieces, false);
    wanted[k] = true;
    Piece part = piece_of(seams, wanted);
    const std::size_t faces = part.lists.triangles.size();
    const std::size_t old_boundary = inspect(part.lists).boundary_edges;
    ++count.pieces;
    Lids lids;
    try {
      lids = add_lids(part, seams, cut.chains);
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("on curve 0 cannot be closed"), std::string::npos);
      ++count.refused;
      continue;
    }
    const Soup soup(part.lists);
    ASSERT_EQ(soup.polygons.size(), part.lists.triangles.size());
    ASSERT_TRUE(soup.is_mesh());
    const Soup::Mesh theirs = soup.mesh();
    EXPECT_EQ(inspect(part.lists).verdict, MeshVerdict::kUsable);
    if (lids.left_open == 0 && old_boundary == cut.chains[0].vertices.size()) {
      EXPECT_TRUE(CGAL::is_closed(theirs));
      ++count.closed;
    }
    if (lids.with_inner > 0) ++count.lids_with_points;
    // Two lids of one cut lie on each other, which CGAL counts as an intersection.
    if (lids.filled == 1 && meetings(theirs, faces) > 0) ++count.touching;
  }
}

void report(const Count& count) {
  std::printf("  %zu pieces, %zu closed, %zu lids with points inside, %zu refused, %zu touch\n",
              count.pieces, count.closed, count.lids_with_points, count.refused, count.touching);
}

/// Adds waves without symmetries to a surface.
MeshLists rough(MeshLists lists, double height, double wavelength) {
  for (Point& p : lists.points) {
    const Point q = p / wavelength;
    p += height * Point(std::sin(3 * q.y() + q.z()), std::sin(2.7 * q.z() + 1.1 * q.x()),
                        std::sin(3.1 * q.x() + 0.9 * q.y()));
  }
  return lists;
}

TEST(LidsOracle, CloseManifoldsThatDoNotCrossThemselves) {
  const std::pair<const char*, MeshLists> meshes[] = {
      {"ball", test::sphere(4)},      {"rough ball", rough(test::sphere(4), 0.03, 0.1)},
      {"torus", test::torus(24, 60)}, {"tube", test::tube(40, 40, 5)},
      {"hills", test::hills(40)},     {"sheet", test::grid(30, 30)}};
  Count all;
  for (const auto& [name, lists] : meshes) {
    SCOPED_TRACE(name);
    const auto opened = OpenedMesh::open(lists);
    Count count;
    for (std::uint64_t seed = 0; seed < 16; ++seed) {
      SCOPED_TRACE(seed);
      Random random(seed);
      const auto loop = loop_about(opened->mesh(), random);
      if (!loop) continue;
      check_pieces(opened->mesh(), *loop, count);
      SmoothingOptions options;
      options.tau = random.scale(0.1, 4);
      options.deviation = DeviationMeasure::kNone;
      try {
        check_pieces(opened->mesh(), smooth_curve(opened, *loop, options).curve(), count);
      } catch (const Error&) {
        continue;  // the loop runs back along its own edges
      }
    }
    std::printf("%s:\n", name);
    report(count);
    EXPECT_EQ(count.touching, 0U);
    for (auto member : {&Count::pieces, &Count::closed, &Count::refused}) {
      all.*member += count.*member;
    }
  }
  EXPECT_GE(all.pieces, 300U);
  EXPECT_LE(all.refused, all.pieces / 20);
}

TEST(LidsOracle, OfRealMeshes) {
  const char* const runs = std::getenv("TALWEG_LID_RUNS");
  const int loops = runs != nullptr ? std::atoi(runs) : 1;
  const char* const names[] = {"aneurysm_14k", "fandisk_14k", "terrain_utm_21k", "armadillo_86k"};
  Count all;
  for (const char* name : names) {
    SCOPED_TRACE(name);
    const auto file = test::mesh_folder() / (std::string(name) + ".ply");
    if (!std::filesystem::exists(file)) GTEST_SKIP() << test::missing(file.filename().string());
    const auto opened = OpenedMesh::open(test::read_reference_mesh(file));
    Count count;
    for (int seed = 0; seed < loops; ++seed) {
      Random random(static_cast<std::uint64_t>(seed) + 1000);
      const auto loop = loop_about(opened->mesh(), random);
      if (!loop) continue;
      check_pieces(opened->mesh(), *loop, count);
      for (const double tau : {0.5, 2.0}) {
        SmoothingOptions options;
        options.tau = tau;
        options.deviation = DeviationMeasure::kNone;
        try {
          check_pieces(opened->mesh(), smooth_curve(opened, *loop, options).curve(), count);
        } catch (const Error&) {
          break;
        }
      }
    }
    std::printf("%s:\n", name);
    report(count);
    EXPECT_EQ(count.touching, 0U);
  }
}

/// On a lattice triangles often touch, overlap and share corners.
TEST(TriangleContactOracle, IsCertainOnlyOfTrianglesThatAreApart) {
  using K = Soup::Kernel;
  std::size_t apart = 0, said = 0;
  for (std::uint64_t seed = 0; seed < 200000; ++seed) {
    Random random(seed);
    const std::size_t size = random.one_in(3) ? 2 + random.below(3) : 1000000;
    PointTriangle s, t;
    for (PointTriangle* triangle : {&s, &t}) {
      for (Point& p : *triangle) {
        for (Eigen::Index k = 0; k < 3; ++k) p[k] = static_cast<double>(random.below(size));
      }
    }
    const std::size_t shared = random.below(3);
    for (std::size_t k = 0; k < shared; ++k) t[k] = s[k];
    Soup::Mesh mesh;
    std::vector<Soup::Mesh::Vertex_index> corners;
    std::map<std::array<double, 3>, Soup::Mesh::Vertex_index> at;
    for (const PointTriangle* triangle : {&s, &t}) {
      for (const Point& p : *triangle) {
        const auto [place, is_new] = at.try_emplace({p.x(), p.y(), p.z()});
        if (is_new) place->second = mesh.add_vertex(K::Point_3(p.x(), p.y(), p.z()));
        corners.push_back(place->second);
      }
    }
    const auto collinear = [&](std::size_t k) {
      return CGAL::collinear(mesh.point(corners[k]), mesh.point(corners[k + 1]),
                             mesh.point(corners[k + 2]));
    };
    if (collinear(0) || collinear(3)) continue;
    if (!mesh.add_face(corners[0], corners[1], corners[2]).is_valid()) continue;
    if (!mesh.add_face(corners[3], corners[4], corners[5]).is_valid() &&
        !mesh.add_face(corners[3], corners[5], corners[4]).is_valid()) {
      continue;
    }
    const bool exact =
        !CGAL::Polygon_mesh_processing::does_self_intersect<CGAL::Sequential_tag>(mesh);
    const bool ours = certainly_apart(s, t);
    EXPECT_TRUE(exact || !ours) << "seed " << seed;
    EXPECT_EQ(ours, certainly_apart(t, s)) << "seed " << seed;
    apart += exact ? 1U : 0U;
    said += ours ? 1U : 0U;
  }
  std::printf("  %zu pairs apart, %zu said to be\n", apart, said);
  EXPECT_GT(apart, 50000U);
  EXPECT_EQ(said, apart);  // on these lattices rounding leaves no doubt
}

}  // namespace
}  // namespace talweg
