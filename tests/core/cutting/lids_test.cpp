// Lids do not repeat edges or triangles of the piece, and keep clear of it.
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "core/cutting/seam_pieces.hpp"
#include "core/generated_meshes.hpp"
#include "core/jagged_curves.hpp"
#include "core/mesh_numbers.hpp"
#include "talweg/core/cutting/loop_filling.hpp"
#include "talweg/core/cutting/mesh_cutting.hpp"
#include "talweg/core/cutting/seam_opening.hpp"
#include "talweg/core/mesh/mesh_inspection.hpp"
#include "talweg/core/space/triangle_contact.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

using test::piece;

using Rim = CutMesh::Chain;

/// The piece with the fewest faces.
std::size_t smallest(const OpenedSeams& seams) {
  std::vector<std::size_t> faces(seams.pieces, 0);
  for (const std::uint32_t k : seams.piece_of_face) ++faces[k];
  return static_cast<std::size_t>(std::min_element(faces.begin(), faces.end()) - faces.begin());
}

/// The number of pairs of a lid's triangle and another triangle where a side of one penetrates the
/// other.
std::size_t crossings(const Piece& part) {
  const auto at = [&](std::size_t f) {
    const auto& [a, b, c] = part.lists.triangles[f];
    return PointTriangle{part.lists.points[a], part.lists.points[b], part.lists.points[c]};
  };
  std::size_t count = 0;
  for (std::size_t f = 0; f < part.faces.size(); ++f) {
    if (part.faces[f] != kNoFace) continue;
    for (std::size_t g = 0; g < part.faces.size(); ++g) {
      if (g != f && (g < f || part.faces[g] != kNoFace) && crossing_depth(at(f), at(g)) > 1e-9) {
        ++count;
      }
    }
  }
  return count;
}

void expect_closed(const Piece& part) {
  const MeshInspection found = inspect(part.lists);
  EXPECT_EQ(found.verdict, MeshVerdict::kUsable) << found.reason;
  EXPECT_EQ(found.boundary_edges, 0U);
  EXPECT_FALSE(found.duplicate_faces.found());
  EXPECT_EQ(part.vertices.size(), part.lists.points.size());
  EXPECT_EQ(part.faces.size(), part.lists.triangles.size());
  EXPECT_EQ(crossings(part), 0U);
}

TEST(Lids, OverOneTriangleHaveAPointInside) {
  const MeshLists lists = test::sphere(3);
  const auto& [a, b, c] = lists.triangles[100];
  const Rim chain[] = {{true, {a, b, c}}};
  const OpenedSeams seams = open_seams(lists, chain);
  ASSERT_EQ(seams.pieces, 2U);
  Piece part = piece(seams, smallest(seams));
  ASSERT_EQ(part.lists.triangles.size(), 1U);
  const Lids lids = add_lids(part, seams, chain);
  EXPECT_EQ(lids.triangles, 3U);
  EXPECT_EQ(lids.inner, 1U);
  EXPECT_EQ(lids.with_inner, 1U);
  EXPECT_EQ(part.vertices.back(), kNoVertex);
  expect_closed(part);
  EXPECT_GT(test::volume(part.lists), 0);
  // The lid of the rest is the triangle that was cut out.
  Piece rest = piece(seams, 1 - smallest(seams));
  EXPECT_EQ(add_lids(rest, seams, chain).inner, 0U);
  expect_closed(rest);
  EXPECT_NEAR(test::volume(rest.lists), test::volume(lists), 1e-12);
}

TEST(Lids, DoNotUseADiagonalThatThePieceHas) {
  // Two faces form an arrowhead. Its only flat lid contains their common edge.
  MeshLists lists = test::sphere(2);
  const Surface surface = test::surface_of_lists(lists);
  const HalfedgeId h{0};
  const auto v = [](VertexId id) { return static_cast<std::uint32_t>(id.index()); };
  const std::uint32_t a = v(surface.tail(h)), b = v(surface.head(h));
  const std::uint32_t c = v(surface.head(surface.next(h)));
  const std::uint32_t d = v(surface.head(surface.next(twin(h))));
  const Point middle = (lists.points[c] + lists.points[d]) / 2;
  lists.points[a] = middle + 0.3 * (lists.points[b] - middle);
  const Rim chain[] = {{true, {a, d, b, c}}};
  const OpenedSeams seams = open_seams(lists, chain);
  ASSERT_EQ(seams.pieces, 2U);
  const std::uint32_t loop[] = {a, d, b, c};
  bool has_edge = false;
  for (const Triangle& t : fill_loop(lists.points, loop)) {
    has_edge =
        has_edge || (std::count(t.begin(), t.end(), a) + std::count(t.begin(), t.end(), b) == 2);
  }
  ASSERT_TRUE(has_edge);
  for (std::size_t k = 0; k < 2; ++k) {
    Piece part = piece(seams, k);
    add_lids(part, seams, chain);
    expect_closed(part);
  }
}

TEST(Lids, OfCurvesAlongEdgesAreClosedManifolds) {
  // Jagged loops about every 20th vertex of a rough ball.
  MeshLists lists = test::sphere(4);
  for (std::size_t v = 0; v < lists.points.size(); ++v) {
    lists.points[v] *= 1 + 0.03 * std::sin(37.0 * static_cast<double>(v));
  }
  const SurfaceMesh mesh = SurfaceMesh::open(lists);
  std::size_t pieces = 0;
  for (std::size_t v = 0; v < lists.points.size(); v += 20) {
    SCOPED_TRACE(v);
    const Point n = lists.points[v].normalized(), u = n.unitOrthogonal();
    const double r = 0.1 + 0.3 * static_cast<double>(v % 7) / 7;
    const SurfaceCurve loop =
        test::drawn_near(mesh, test::circle(n, r * u, r * n.cross(u), 12), true);
    const CutMesh cut = cut_along(mesh, std::span(&loop, 1));
    const OpenedSeams seams = open_seams(cut.lists, cut.chains);
    for (std::size_t k = 0; k < seams.pieces; ++k, ++pieces) {
      Piece part = piece(seams, k);
      const Lids lids = add_lids(part, seams, cut.chains);
      ASSERT_EQ(lids.left_open, 0U);
      expect_closed(part);
    }
  }
  EXPECT_GT(pieces, 100U);
}

TEST(Lids, OfAPatchOfHillsGoUnderIt) {
  const auto opened = OpenedMesh::open(test::hills(40));
  const auto points = test::circle({20, 20, 0}, {9, 0, 0}, {0, 9, 0}, 24);
  const SurfaceCurve ring =
      smooth_curve(opened, test::drawn_near(opened->mesh(), points, true)).curve();
  const CutMesh cut = cut_along(opened->mesh(), std::span(&ring, 1));
  const OpenedSeams seams = open_seams(cut.lists, cut.chains);
  Piece patch = piece(seams, seams.left[0][0]);
  const Lids lids = add_lids(patch, seams, cut.chains);
  EXPECT_EQ(lids.with_inner, 1U);
  EXPECT_GT(lids.sunk_by, 0);
  EXPECT_LT(lids.sunk_by, 9);
  expect_closed(patch);
  EXPECT_GT(test::volume(patch.lists), 0);  // all of the lid lies on the inner side
}

TEST(Lids, CancelledAtAnyQuestionLeaveThePieceAsItIs) {
  const auto opened = OpenedMesh::open(test::hills(40));
  const auto points = test::circle({20, 20, 0}, {9, 0, 0}, {0, 9, 0}, 24);
  const SurfaceCurve ring =
      smooth_curve(opened, test::drawn_near(opened->mesh(), points, true)).curve();
  const CutMesh cut = cut_along(opened->mesh(), std::span(&ring, 1));
  const OpenedSeams seams = open_seams(cut.lists, cut.chains);
  const Piece patch = piece(seams, seams.left[0][0]);
  const auto cap = [&](std::size_t yes, std::size_t& asked) {
    asked = 0;
    Piece part = patch;
    const Progress progress = [&](const char*, double) { return asked++ < yes; };
    try {
      add_lids(part, seams, cut.chains, LidKind::kAuto, progress);
    } catch (const Cancelled&) {
      EXPECT_EQ(part.lists.triangles, patch.lists.triangles);
      EXPECT_EQ(part.vertices, patch.vertices);
      return false;
    }
    return true;
  };
  std::size_t all = 0, asked = 0;
  ASSERT_TRUE(cap(SIZE_MAX, all));
  ASSERT_GT(all, 50U);
  for (std::size_t yes = 0; yes < all; yes += 1 + all / 20) {
    EXPECT_FALSE(cap(yes, asked));
    EXPECT_EQ(asked, yes + 1);  // none after that
  }
}

TEST(Lids, OfAFlatPieceEncloseALittle) {
  const MeshLists lists = test::grid(10, 10);
  const SurfaceMesh mesh = SurfaceMesh::open(lists);
  const SurfaceCurve loop =
      test::drawn_near(mesh, test::circle({5, 5, 0}, {3, 0, 0}, {0, 3, 0}, 12), true);
  const CutMesh cut = cut_along(mesh, std::span(&loop, 1));
  const OpenedSeams seams = open_seams(cut.lists, cut.chains);
  Piece patch = piece(seams, smallest(seams));
  EXPECT_EQ(add_lids(patch, seams, cut.chains).with_inner, 1U);
  expect_closed(patch);
  EXPECT_GT(test::volume(patch.lists), 0);
  // A plane lid lies on the piece, but repeats no edge or triangle.
  Piece flat = piece(seams, smallest(seams));
  EXPECT_EQ(add_lids(flat, seams, cut.chains, LidKind::kPlanar).planar, 1U);
  expect_closed(flat);
  EXPECT_NEAR(test::volume(flat.lists), 0, 1e-9);
}

TEST(Lids, OfBothSidesOfACutInOnePieceLieOnEachOther) {
  // A ring once around the tube of a torus: the two rims coincide, and are not plane.
  const MeshLists lists = test::torus(32, 64);
  Rim ring{true, {}};
  for (std::uint32_t i = 0; i < 32; ++i) {
    const auto shift =
        static_cast<std::uint32_t>(std::lround(3 * std::sin(std::numbers::pi * i / 16)));
    const std::uint32_t row = 10 + shift;
    if (!ring.vertices.empty()) {  // along the net's edges
      std::uint32_t last = ring.vertices.back() / 32;
      for (; last < row; ++last) ring.vertices.push_back((last + 1) * 32 + i - 1);
      for (; last > row; --last) ring.vertices.push_back((last - 1) * 32 + i - 1);
    }
    ring.vertices.push_back(row * 32 + i);
  }
  const OpenedSeams seams = open_seams(lists, std::span(&ring, 1));
  ASSERT_EQ(seams.pieces, 1U);
  Piece tube = piece(seams, 0);
  const Lids lids = add_lids(tube, seams, std::span(&ring, 1));
  EXPECT_EQ(lids.filled, 2U);
  const MeshInspection found = inspect(tube.lists);
  EXPECT_EQ(found.verdict, MeshVerdict::kUsable) << found.reason;
  EXPECT_EQ(found.boundary_edges, 0U);
  EXPECT_EQ(test::euler(tube.lists), 2);
  EXPECT_NEAR(test::volume(tube.lists), test::volume(lists), 1e-12);
}

/// A strip around with a full twist: two sides, and borders that go through each other.
MeshLists twisted(std::uint32_t length, std::uint32_t width) {
  MeshLists lists;
  for (std::uint32_t j = 0; j <= width; ++j) {
    for (std::uint32_t i = 0; i < length; ++i) {
      const double u = 2 * std::numbers::pi * i / length;
      const double w = (2.0 * j / width - 1), r = 2 + w * std::cos(u);
      lists.points.emplace_back(r * std::cos(u), r * std::sin(u), w * std::sin(u));
    }
  }
  test::add_net(lists, length, width + 1, false);
  return lists;
}

TEST(Lids, AreRefusedIfEveryLidWouldMeetTheMesh) {
  // The strip between the two borders penetrates every lid of either border.
  const std::uint32_t n = 60;
  const MeshLists lists = twisted(n, 6);
  Rim low{true, {}}, high{true, {}};
  for (std::uint32_t i = 0; i < n; ++i) {
    low.vertices.push_back(n + i);
    high.vertices.push_back(5 * n + i);
  }
  const Rim both[] = {low, high};
  const OpenedSeams seams = open_seams(lists, both);
  ASSERT_EQ(seams.pieces, 3U);
  Piece strip = piece(seams, seams.left[0][0]);
  if (strip.lists.triangles.size() < 4 * n) strip = piece(seams, seams.right[0][0]);
  const std::size_t faces = strip.lists.triangles.size(), points = strip.lists.points.size();
  try {
    add_lids(strip, seams, both);
    ADD_FAILURE() << "lids through the strip";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadCurve);
    const std::string text = error.what();
    EXPECT_NE(text.find("The rim of 60 points at ("), std::string::npos) << text;
    EXPECT_NE(text.find("on curve "), std::string::npos) << text;
    EXPECT_NE(text.find("cannot be closed"), std::string::npos) << text;
  }
  EXPECT_EQ(strip.lists.triangles.size(), faces);
  EXPECT_EQ(strip.lists.points.size(), points);
}

TEST(Lids, DoNotGoThroughAWallExactlyAtItsVertices) {
  // A torus is cut along its outermost ring. A plane lid would pass exactly through the vertices of
  // the innermost ring, which lie in the plane of the rim.
  const MeshLists lists = test::torus(32, 16);
  Rim ring{true, {}};
  for (std::uint32_t v = 0; v < lists.points.size(); v += 32) ring.vertices.push_back(v);
  const OpenedSeams seams = open_seams(lists, std::span(&ring, 1));
  for (const LidKind kind : {LidKind::kPlanar, LidKind::kAuto, LidKind::kLeastArea}) {
    Piece tube = piece(seams, 0);
    try {
      add_lids(tube, seams, std::span(&ring, 1), kind);
      ADD_FAILURE() << "a lid through the wall";
    } catch (const Error& error) {
      const std::string text = error.what();
      EXPECT_NE(text.find("on curve 0 cannot be closed: every"), std::string::npos) << text;
    }
  }
}

TEST(FillLoop, UsesNoChordThatIsLeftOut) {
  const std::vector<Point> points = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  const std::uint32_t loop[] = {0, 1, 2, 3};
  const auto without = [&](std::uint32_t a, std::uint32_t b) {
    LeftOut left_out;
    left_out.chord = [=](std::uint32_t p, std::uint32_t q) {
      return std::minmax(p, q) == std::minmax(a, b);
    };
    return fill_loop(points, loop, left_out);
  };
  for (const auto& [a, b] : {std::pair(0U, 2U), std::pair(1U, 3U)}) {
    const auto lid = without(a, b);
    ASSERT_TRUE(lid.has_value());
    ASSERT_EQ(lid->size(), 2U);
    for (const Triangle& t : *lid) {
      EXPECT_FALSE(std::count(t.begin(), t.end(), a) == 1 &&
                   std::count(t.begin(), t.end(), b) == 1);
    }
  }
  LeftOut none;
  none.chord = [](std::uint32_t, std::uint32_t) { return true; };
  EXPECT_FALSE(fill_loop(points, loop, none).has_value());
  LeftOut triangles{[](std::uint32_t, std::uint32_t) { return false; }, {{0, 1, 2}, {0, 1, 3}}};
  EXPECT_FALSE(fill_loop(points, loop, triangles).has_value());
}

}  // namespace
}  // namespace talweg
