// Cutting turns curves into edges; the surface is unchanged up to rounding.
#include "talweg/core/cutting/mesh_cutting.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/jagged_curves.hpp"
#include "core/mesh_numbers.hpp"
#include "core/reference_data.hpp"
#include "talweg/core/cutting/attribute_transfer.hpp"
#include "talweg/core/cutting/face_triangulation.hpp"
#include "talweg/core/cutting/seam_opening.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/core/mesh/closest_point.hpp"
#include "talweg/core/repair/mesh_repair.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

using test::area;
using test::euler;
using test::volume;

__extension__ using Wide = __int128;

/// The properties of every cut.
void expect_good(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                 const CutMesh& cut) {
  const MeshLists old = {{mesh.points().begin(), mesh.points().end()}, [&] {
                           std::vector<Triangle> triangles;
                           for (std::size_t f = 0; f < mesh.surface().face_count(); ++f) {
                             const auto c = mesh.surface().corners(FaceId{f});
                             triangles.push_back({static_cast<std::uint32_t>(c[0].index()),
                                                  static_cast<std::uint32_t>(c[1].index()),
                                                  static_cast<std::uint32_t>(c[2].index())});
                           }
                           return triangles;
                         }()};
  const SurfaceMesh now = SurfaceMesh::open(cut.lists);  // throws unless it is a surface
  EXPECT_EQ(euler(now.surface()), euler(mesh.surface()));
  EXPECT_NEAR(area(cut.lists), area(old), 1e-12 * area(old));
  double size = 0;
  for (const Point& p : old.points) size = std::max(size, p.norm());
  EXPECT_NEAR(volume(cut.lists), volume(old), 1e-12 * size * area(old));
  for (std::size_t v = 0; v < old.points.size(); ++v) {
    ASSERT_EQ(cut.lists.points[v], old.points[v]);
  }
  ASSERT_EQ(cut.vertex_from.size(), cut.lists.points.size());
  ASSERT_EQ(cut.face_from.size(), cut.lists.triangles.size());
  for (std::size_t f = 0; f < cut.face_from.size(); ++f) {
    for (const std::uint32_t v : cut.lists.triangles[f]) {
      const FaceId from{cut.face_from[f]};
      EXPECT_NO_THROW(coordinates_in(mesh.surface(), cut.vertex_from[v], from));
    }
  }
  ASSERT_EQ(cut.chains.size(), curves.size());
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const auto& chain = cut.chains[c].vertices;
    EXPECT_EQ(cut.chains[c].closed, curves[c].closed);
    double length = 0;
    const std::size_t n = chain.size();
    for (std::size_t i = 0; i + (curves[c].closed ? 0 : 1) < n; ++i) {
      const VertexId a{chain[i]}, b{chain[(i + 1) % n]};
      ASSERT_TRUE(now.surface().find_halfedge(a, b).valid()) << "curve " << c << " at " << i;
      length += (now.point(a) - now.point(b)).norm();
    }
    const double drawn = curve_length(mesh.surface(), curves[c]);
    EXPECT_NEAR(length, drawn, 1e-9 * drawn + 4 * cut.largest_move * static_cast<double>(n));
    // Every point of the curve is a vertex, or was merged with one.
    const auto points = positions_of(mesh, curves[c]);
    for (const Point& p : points) {
      double nearest = HUGE_VAL;
      for (const std::uint32_t v : chain) {
        nearest = std::min(nearest, (cut.lists.points[v] - p).norm());
      }
      EXPECT_LE(nearest, 1e-12 * size + cut.largest_move);
    }
  }
}

/// The distance between two meshes in both directions, at vertices and points inside faces.
double hausdorff(const SurfaceMesh& a, const SurfaceMesh& b) {
  double largest = 0;
  for (const auto& [from, to] : {std::pair{&a, &b}, {&b, &a}}) {
    const ClosestPoint closest(*to);
    for (const Point& p : from->points()) {
      largest = std::max(largest, closest.nearest(p).distance);
    }
    for (std::size_t f = 0; f < from->surface().face_count(); ++f) {
      const auto [i, j, k] = from->surface().corners(FaceId{f});
      for (const auto& [x, y] : {std::pair{1.0 / 3, 1.0 / 3}, {0.1, 0.2}, {0.5, 0.45}}) {
        const Point p = x * from->point(i) + y * from->point(j) + (1 - x - y) * from->point(k);
        largest = std::max(largest, closest.nearest(p).distance);
      }
    }
  }
  return largest;
}

/// A cut mesh that is opened along its chains and welded again has its old connectivity, and lies
/// on the old mesh.
void expect_the_old_surface_when_welded(const SurfaceMesh& mesh, const CutMesh& cut) {
  const OpenedSeams open = open_seams(cut.lists, cut.chains);
  const MeshLists welded = repair(open.lists).lists;
  const SurfaceMesh now = SurfaceMesh::open(welded);
  std::int64_t unused = 0;  // the copies that were welded onto others
  for (std::size_t v = 0; v < welded.points.size(); ++v) {
    if (!now.surface().halfedge(VertexId{v}).valid()) ++unused;
  }
  EXPECT_EQ(unused, static_cast<std::int64_t>(open.lists.points.size() - cut.lists.points.size()));
  EXPECT_EQ(euler(now.surface()) - unused, euler(mesh.surface()));
  EXPECT_NEAR(area(welded), area(cut.lists), 1e-12 * area(cut.lists));
  double size = 0;
  for (const Point& p : mesh.points()) size = std::max(size, (p - mesh.points()[0]).norm());
  EXPECT_LE(hausdorff(mesh, now), 1e-12 * size);
}

class MeshCutting : public testing::Test {
 protected:
  static SurfaceMesh open(const MeshLists& lists) { return SurfaceMesh::open(lists); }
};

TEST_F(MeshCutting, AlongASmoothedCurve) {
  const auto opened = OpenedMesh::open(test::hills(40));
  const SurfaceCurve drawn = test::wave_on_hills(opened->mesh());
  const SurfaceCurve smooth = smooth_curve(opened, drawn).curve();
  const CutMesh cut = cut_along(opened->mesh(), std::span(&smooth, 1));
  expect_good(opened->mesh(), std::span(&smooth, 1), cut);
  EXPECT_GT(cut.new_vertices, smooth.points.size() / 2);
  EXPECT_EQ(cut.crossings, 0U);
}

TEST_F(MeshCutting, AlongEdgesChangesNothing) {
  const SurfaceMesh mesh = open(test::hills(40));
  const SurfaceCurve drawn = test::wave_on_hills(mesh);
  const CutMesh cut = cut_along(mesh, std::span(&drawn, 1));
  expect_good(mesh, std::span(&drawn, 1), cut);
  EXPECT_EQ(cut.new_vertices, 0U);
  EXPECT_EQ(cut.cut_faces, 0U);
  EXPECT_EQ(cut.chains[0].vertices.size(), drawn.points.size());
}

TEST_F(MeshCutting, WhereCurvesCrossThereIsAVertexOfBoth) {
  const SurfaceMesh mesh = open(test::grid(10, 10));
  StraightLines lines(mesh.surface());
  const auto at = [&](std::uint32_t v) {
    return SurfacePoint::at_vertex(mesh.surface(), VertexId{v});
  };
  const std::vector<SurfaceCurve> curves = {
      lines.join(std::vector{at(0), at(10 * 11 + 7)}, false),
      lines.join(std::vector{at(10), at(10 * 11 + 2)}, false),
      lines.join(std::vector{at(5 * 11), at(5 * 11 + 10)}, false)};  // along edges
  const CutMesh cut = cut_along(mesh, curves);
  expect_good(mesh, curves, cut);
  const std::set<std::uint32_t> first(cut.chains[0].vertices.begin(), cut.chains[0].vertices.end());
  const auto common = [&](const CutMesh::Chain& other) {
    return std::count_if(other.vertices.begin(), other.vertices.end(),
                         [&](std::uint32_t v) { return first.count(v) > 0; });
  };
  EXPECT_EQ(common(cut.chains[1]), 1);
  EXPECT_EQ(common(cut.chains[2]), 1);
}

TEST_F(MeshCutting, MergesPointsNearVertices) {
  const SurfaceMesh mesh = open(test::grid(4, 4));
  const Surface& surface = mesh.surface();
  const SurfacePoint near = test::between(surface, 6, 7, 1e-11);
  SurfaceCurve curve;
  curve.points = {SurfacePoint::at_vertex(surface, VertexId{0}), near,
                  SurfacePoint::at_vertex(surface, VertexId{12})};
  const CutMesh cut = cut_along(mesh, std::span(&curve, 1));
  EXPECT_EQ(cut.merged, 1U);
  EXPECT_GT(cut.largest_move, 0);
  EXPECT_LT(cut.largest_move, 1e-10);
  EXPECT_EQ(cut.new_vertices, 0U);
  EXPECT_EQ(cut.chains[0].vertices, (std::vector<std::uint32_t>{0, 6, 12}));
}

TEST_F(MeshCutting, CarriesFieldsLinearly) {
  const SurfaceMesh mesh = open(test::grid(10, 10));
  StraightLines lines(mesh.surface());
  const std::vector<SurfacePoint> ends = {test::between(mesh.surface(), 0, 1, 0.3),
                                          test::between(mesh.surface(), 118, 119, 0.6)};
  const SurfaceCurve curve = lines.join(ends, false);
  const CutMesh cut = cut_along(mesh, std::span(&curve, 1));
  std::vector<double> field;
  for (const Point& p : mesh.points()) field.push_back(3 * p.x() - 2 * p.y() + 1);
  const std::vector<double> carried = carried_to(cut, mesh.surface(), field);
  ASSERT_EQ(carried.size(), cut.lists.points.size());
  for (std::size_t v = 0; v < carried.size(); ++v) {
    const Point& p = cut.lists.points[v];
    EXPECT_NEAR(carried[v], 3 * p.x() - 2 * p.y() + 1, 1e-12);
  }
  field.pop_back();
  EXPECT_THROW(carried_to(cut, mesh.surface(), field), Error);
}

/// A curve of straight lines between random points, of all kinds.
SurfaceCurve random_curve(const SurfaceMesh& mesh, StraightLines& lines, std::mt19937& random,
                          bool closed) {
  const Surface& surface = mesh.surface();
  std::uniform_real_distribution<double> part(0, 1);
  std::vector<SurfacePoint> points;
  for (int k = 0; k < 5; ++k) {
    const FaceId f{random() % surface.face_count()};
    const double a = part(random), b = (1 - a) * part(random);
    switch (random() % 3) {
      case 0:
        points.push_back(SurfacePoint::at_vertex(surface, surface.corners(f)[0]));
        break;
      case 1:
        points.push_back(
            SurfacePoint::on_edge(surface, edge_of(surface.halfedge(f)), 0.1 + 0.8 * a));
        break;
      default:
        points.push_back(SurfacePoint::from_barycentric(surface, f, {a, b, 1 - a - b}));
    }
  }
  return lines.join(points, closed);
}

/// A curve of straight lines between points a few steps apart, also for large meshes.
SurfaceCurve local_curve(const SurfaceMesh& mesh, StraightLines& lines, std::mt19937& random,
                         bool closed) {
  const Surface& surface = mesh.surface();
  std::vector<SurfacePoint> points;
  FaceId f{random() % surface.face_count()};
  for (int k = 0; k < 6; ++k) {
    for (int step = 0; step < 12; ++step) {
      HalfedgeId h = surface.halfedge(f);
      for (std::size_t turn = random() % 3; turn > 0; --turn) h = surface.next(h);
      if (surface.has_face(twin(h))) f = surface.face(twin(h));
    }
    const HalfedgeId h = surface.halfedge(f);
    if (k % 3 == 0) {
      points.push_back(SurfacePoint::at_vertex(surface, surface.tail(h)));
    } else if (k % 3 == 1) {
      points.push_back(SurfacePoint::on_edge(surface, edge_of(h), 0.5));
    } else {
      points.push_back(SurfacePoint::from_barycentric(surface, f, {0.25, 0.25, 0.5}));
    }
  }
  return lines.join(points, closed);
}

TEST_F(MeshCutting, RandomCurvesOnManyMeshes) {
  const MeshLists meshes[] = {test::hills(20), test::sphere(3), test::torus(24, 12), test::box(),
                              test::tube(16, 12, 4)};
  std::mt19937 random(11);
  int runs = 0, crossed = 0;
  for (const MeshLists& lists : meshes) {
    const SurfaceMesh mesh = open(lists);
    StraightLines lines(mesh.surface());
    for (int k = 0; k < 20; ++k) {
      SCOPED_TRACE(testing::Message() << lists.triangles.size() << " faces, run " << k);
      std::vector<SurfaceCurve> curves;
      const std::size_t count = 1 + random() % 3;
      try {
        while (curves.size() < count) {
          curves.push_back(random_curve(mesh, lines, random, random() % 2 == 0));
        }
      } catch (const Error&) {
        continue;  // two points coincide or nearly coincide
      }
      const CutMesh cut = cut_along(mesh, curves);
      expect_good(mesh, curves, cut);
      ++runs;
      if (cut.crossings > 0) ++crossed;
    }
  }
  EXPECT_GT(runs, 80);
  EXPECT_GT(crossed, 40);
}

TEST_F(MeshCutting, CutAndWeldedMeshesHaveTheOldSurface) {
  const MeshLists meshes[] = {test::hills(20), test::sphere(3), test::torus(24, 12)};
  std::mt19937 random(23);
  int runs = 0;
  for (const MeshLists& lists : meshes) {
    const SurfaceMesh mesh = open(lists);
    StraightLines lines(mesh.surface());
    for (int k = 0; k < 4; ++k) {
      SCOPED_TRACE(testing::Message() << lists.triangles.size() << " faces, run " << k);
      std::vector<SurfaceCurve> curves;
      try {
        for (int c = 0; c < 2; ++c) curves.push_back(random_curve(mesh, lines, random, c == 0));
      } catch (const Error&) {
        continue;
      }
      expect_the_old_surface_when_welded(mesh, cut_along(mesh, curves));
      ++runs;
    }
  }
  EXPECT_GT(runs, 8);
}

/// TALWEG_CUT_RUNS: how many curves on each mesh, 3 by default.
TEST_F(MeshCutting, RandomCurvesOnRealMeshes) {
  const char* given = std::getenv("TALWEG_CUT_RUNS");
  const int runs = given != nullptr ? std::atoi(given) : 3;
  std::mt19937 random(7);
  int meshes = 0, done = 0;
  for (const char* name : {"aneurysm_14k", "armadillo_86k", "brain_icbm_164k", "bunny_isolated_69k",
                           "cylinder_varying_16k", "degenerate_13k", "elephant_106holes_tiny_4k",
                           "fandisk_14k", "skull_100k", "terrain_utm_21k", "tooth_ct_119k"}) {
    const auto path = test::mesh_folder() / (std::string(name) + ".ply");
    if (!std::filesystem::exists(path)) {
      std::printf("%s\n", test::missing(name).c_str());
      continue;
    }
    const MeshLists lists = read_mesh(path);
    const SurfaceMesh mesh = open(lists);
    const bool is_small_and_whole = lists.triangles.size() < 30000 && !repair(lists).changes.any();
    ++meshes;
    StraightLines lines(mesh.surface());
    for (int k = 0; k < runs; ++k) {
      SCOPED_TRACE(testing::Message() << name << ", run " << k);
      std::vector<SurfaceCurve> curves;
      try {
        curves.push_back(local_curve(mesh, lines, random, k % 2 == 0));
        if (k % 3 == 0) curves.push_back(local_curve(mesh, lines, random, k % 2 != 0));
      } catch (const Error&) {
        continue;  // random points too near to each other, or not connected
      }
      const CutMesh cut = cut_along(mesh, curves);
      expect_good(mesh, curves, cut);
      // Welding also joins vertices that coincide in the file, so only some meshes are tested.
      if (k == 0 && is_small_and_whole) expect_the_old_surface_when_welded(mesh, cut);
      ++done;
    }
  }
  if (meshes == 0) GTEST_SKIP() << test::missing("meshes");
  RecordProperty("curves", done);
  EXPECT_GT(done, meshes);
}

TEST_F(MeshCutting, RefusesBadCurvesAndMergeTolerances) {
  const SurfaceMesh mesh = open(test::grid(10, 10));
  SurfaceCurve jump;
  jump.points = {SurfacePoint::at_vertex(mesh.surface(), VertexId{0}),
                 SurfacePoint::at_vertex(mesh.surface(), VertexId{50})};
  EXPECT_THROW(cut_along(mesh, std::span(&jump, 1)), Error);
  EXPECT_THROW(cut_along(mesh, {}, {.merge = 0}), Error);
  EXPECT_EQ(cut_along(mesh, {}).new_vertices, 0U);
}

/// The triangles fill the face without overlap, and segments are edges.
void expect_cut_up(const FaceTriangulation& face, const std::vector<std::size_t>& segments) {
  constexpr std::int64_t kOne = FaceTriangulation::kOne;
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  Wide sum = 0;
  for (const auto& [a, b, c] : face.triangles()) {
    const auto &p = face.places()[a], &q = face.places()[b], &r = face.places()[c];
    const Wide twice = Wide{q[1] - p[1]} * (r[2] - p[2]) - Wide{q[2] - p[2]} * (r[1] - p[1]);
    EXPECT_TRUE(twice > 0);
    sum += twice;
    for (const auto& [u, v] : {std::pair{a, b}, {b, c}, {c, a}})
      EXPECT_TRUE(edges.insert({u, v}).second);
  }
  EXPECT_TRUE(sum == Wide{kOne} * kOne);
  for (const std::size_t s : segments) {
    const auto chain = face.chain(s);
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      EXPECT_TRUE(edges.count({chain[i], chain[i + 1]}) + edges.count({chain[i + 1], chain[i]}) >
                  0);
    }
  }
}

std::vector<std::size_t> connect_some(FaceTriangulation& face,
                                      const std::vector<std::uint32_t>& points, int count,
                                      std::mt19937_64& random) {
  std::vector<std::size_t> segments;
  for (int k = 0; k < count; ++k) {
    const std::uint32_t a = points[random() % points.size()], b = points[random() % points.size()];
    if (a != b) segments.push_back(face.connect(a, b));
  }
  return segments;
}

TEST(FaceTriangulation, CutsUpAFaceFullOfCrossingSegments) {
  constexpr std::int64_t kOne = FaceTriangulation::kOne;
  std::mt19937_64 random(5);
  for (int run = 0; run < 50; ++run) {
    FaceTriangulation face({PlanePoint{0, 0}, PlanePoint{3, 0}, PlanePoint{1, 2}});
    std::vector<std::uint32_t> points = {0, 1, 2};
    for (int k = 0; k < 12; ++k) {
      std::int64_t a = static_cast<std::int64_t>(random() % (kOne / 2));
      std::int64_t b = static_cast<std::int64_t>(random() % (kOne / 2));
      if (k % 3 == 0) a = 0;
      points.push_back(face.insert({kOne - a - b, a, b}));
    }
    const auto segments = connect_some(face, points, 10, random);
    face.improve();
    expect_cut_up(face, segments);
  }
}

// Segments that cross hundreds of edges: among points without order, in rows (where many lie on one
// line), and where no flips have made the triangles better.
TEST(FaceTriangulation, CutsUpAFaceFullOfPoints) {
  constexpr std::int64_t kOne = FaceTriangulation::kOne;
  std::mt19937_64 random(6);
  for (int run = 0; run < 12; ++run) {
    FaceTriangulation face({PlanePoint{0, 0}, PlanePoint{3, 0}, PlanePoint{1, 2}});
    const std::int64_t rows = std::int64_t{1} << (run % 3 == 0 ? 39 : 3 + run % 6);
    const int count = run % 2 == 0 ? 3000 : 900;
    std::vector<std::uint32_t> points = {0, 1, 2};
    for (int k = 0; k < count; ++k) {
      const std::int64_t step = kOne / 2 / rows;
      const auto a = static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(rows)) * step;
      const auto b = static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(rows)) * step;
      points.push_back(face.insert({kOne - a - b, a, b}));
    }
    const auto segments = connect_some(face, points, 20, random);
    expect_cut_up(face, segments);
    face.improve();
    expect_cut_up(face, segments);
  }
}

}  // namespace
}  // namespace talweg
