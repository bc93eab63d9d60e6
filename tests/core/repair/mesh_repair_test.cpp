#include "talweg/core/repair/mesh_repair.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/reference_data.hpp"
#include "core/small_meshes.hpp"
#include "talweg/core/drawing/snapping.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::test {
namespace {

/// The number of changes of each kind.
struct Counts {
  std::size_t welded = 0, collapsed = 0, duplicates = 0, zero_area = 0, turned = 0, edges = 0,
              vertices = 0, copies = 0;
  friend bool operator==(const Counts&, const Counts&) = default;
  friend void PrintTo(const Counts& c, std::ostream* out) {
    *out << "welded " << c.welded << ", collapsed " << c.collapsed << ", duplicates "
         << c.duplicates << ", zero area " << c.zero_area << ", turned " << c.turned << ", edges "
         << c.edges << ", vertices " << c.vertices << ", copies " << c.copies;
  }
};

Counts counts_of(const MeshChanges& c) {
  return {c.welded_vertices.count, c.collapsed_faces.count, c.duplicate_faces.count,
          c.zero_area_faces.count, c.turned_faces.count,    c.split_edges.count,
          c.split_vertices.count,  c.vertex_copies};
}

/// Properties of every repair: corners keep their positions, faces keep their order, and the maps
/// agree with the lists.
void check_map(const MeshLists& file, const RepairedMesh& repaired) {
  const RepairMap& map = repaired.map;
  ASSERT_EQ(map.file_vertex_count(), file.points.size());
  ASSERT_EQ(map.file_face_count(), file.triangles.size());
  const std::vector<Triangle>& triangles = repaired.lists.triangles;
  for (std::size_t r = 0; r < triangles.size(); ++r) {
    const FaceId f = map.file_face(FaceId{r});
    EXPECT_TRUE(r == 0 || map.file_face(FaceId{r - 1}) < f);
    ASSERT_EQ(map.image(f).face, r);
    for (std::size_t k = 0; k < 3; ++k) {
      const Point& before = file.points[file.triangles[f.index()][k]];
      const Point& after = repaired.lists.points[triangles[r][map.image(f).corner[k]]];
      EXPECT_LE((after - before).norm(), repaired.changes.weld_distance);
    }
  }
  for (std::size_t v = 0; v < repaired.lists.points.size(); ++v) {
    const VertexId in_file = map.file_vertex(VertexId{v});
    EXPECT_TRUE(v >= file.points.size() || in_file.index() == v);
    EXPECT_EQ(repaired.lists.points[v], file.points[in_file.index()]);
  }
}

RepairedMesh repaired_and_usable(const MeshLists& file, const RepairSteps& steps = {}) {
  RepairedMesh repaired = repair(file, steps);
  check_map(file, repaired);
  const MeshInspection after = inspect(repaired.lists);
  EXPECT_EQ(after.verdict, MeshVerdict::kUsable) << after.reason;
  EXPECT_NO_THROW(SurfaceMesh::open(repaired.lists));
  const RepairedMesh again = repair(repaired.lists, steps);
  EXPECT_EQ(counts_of(again.changes), Counts{}) << "a second repair changes something";
  EXPECT_EQ(again.lists.triangles, repaired.lists.triangles);
  return repaired;
}

/// The mesh with separate vertices for every face.
MeshLists soup(const MeshLists& lists) {
  MeshLists result;
  for (const Triangle& t : lists.triangles) {
    const auto n = static_cast<std::uint32_t>(result.points.size());
    for (const std::uint32_t v : t) result.points.push_back(lists.points[v]);
    result.triangles.push_back({n, n + 1, n + 2});
  }
  return result;
}

std::string refusal(std::string_view list) {
  try {
    repair_steps(list);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadUsage);
    return error.what();
  }
  return "";
}

TEST(MeshRepair, CleanMeshesStayAsTheyAre) {
  for (const MeshLists& file :
       {sphere(2), torus(8, 6), tube(7, 4, 2), grid(3, 4), box(),
        with_isolated_vertices(sphere(1), 3), with_needle(grid(2, 2), 0, Point(0, 0, 1e-4))}) {
    ASSERT_EQ(inspect(file).verdict, MeshVerdict::kUsable);
    const RepairedMesh repaired = repaired_and_usable(file);
    EXPECT_EQ(counts_of(repaired.changes), Counts{});
    EXPECT_EQ(repaired.lists.triangles, file.triangles);
    EXPECT_EQ(repaired.lists.points.size(), file.points.size());
    EXPECT_TRUE(sentences(repaired.changes).empty());
  }
}

TEST(MeshRepair, SoupIsWelded) {
  for (const MeshLists& whole : {sphere(2), torus(8, 6), tube(7, 4, 2), grid(3, 4)}) {
    const MeshLists file = soup(whole);
    const RepairedMesh repaired = repaired_and_usable(file);
    EXPECT_EQ(counts_of(repaired.changes),
              (Counts{.welded = file.points.size() - whole.points.size()}));
    EXPECT_EQ(repaired.changes.weld_distance, 0);
    const MeshInspection before = inspect(whole), after = inspect(repaired.lists);
    EXPECT_EQ(after.edges, before.edges);
    EXPECT_EQ(after.components, before.components);
    EXPECT_EQ(after.boundary_loops, before.boundary_loops);
    EXPECT_EQ(after.genus, before.genus);
    EXPECT_EQ(after.isolated_vertices.count, repaired.changes.welded_vertices.count);
  }
}

TEST(MeshRepair, WeldingFollowsThePrecisionOfTheCoordinates) {
  for (const double unit : {1e-6, 1.0, 1e6}) {
    for (const bool single : {true, false}) {
      const MeshLists whole = sphere(2);
      MeshLists file = soup(whole);
      const double ulp = single ? 0x1p-23 : 0x1p-52;
      for (std::size_t v = 0; v < file.points.size(); ++v) {
        file.points[v] *= unit;
        // Corners of one vertex differ by up to half of an ulp of the largest coordinate each way.
        file.points[v].x() += unit * ulp / 2 * (static_cast<double>(v % 3) - 1);
      }
      file.single_precision = single;
      const RepairedMesh repaired = repaired_and_usable(file);
      EXPECT_EQ(inspect(repaired.lists).edges, inspect(whole).edges);
      EXPECT_EQ(repaired.changes.welded_vertices.count, file.points.size() - whole.points.size());
      EXPECT_LE(repaired.changes.weld_distance, repaired.changes.weld_tolerance);
      EXPECT_LT(repaired.changes.weld_tolerance, 5 * ulp * unit);
    }
  }
}

TEST(MeshRepair, NeighboursOnACoarseGridStayApart) {
  // Far from the origin 32-bit floats are half a unit apart, and the vertices one unit.
  MeshLists file = grid(6, 6);
  for (Point& p : file.points) p += Point(5e6, 5e6, 0);
  file.single_precision = true;
  const RepairedMesh repaired = repaired_and_usable(file);
  EXPECT_EQ(counts_of(repaired.changes), Counts{});
  EXPECT_GE(repaired.changes.weld_tolerance, 1);
}

TEST(MeshRepair, RepeatedVertices) {
  const RepairedMesh repaired = repaired_and_usable(with_repeated_vertex(sphere(1)));
  EXPECT_EQ(counts_of(repaired.changes), (Counts{.collapsed = 1}));
  EXPECT_EQ(repaired.changes.collapsed_faces.first, std::vector<std::uint32_t>{32});
  EXPECT_EQ(repaired.map.image(FaceId{32}).face, RepairMap::kDropped);
}

TEST(MeshRepair, DuplicateFaces) {
  for (const bool reversed : {false, true}) {
    const MeshLists file = with_duplicate_face(sphere(1), 5, reversed);
    const RepairedMesh repaired = repaired_and_usable(file);
    EXPECT_EQ(counts_of(repaired.changes), (Counts{.duplicates = 1}));
    EXPECT_EQ(repaired.changes.duplicate_faces.first[0].element, 32U);
    EXPECT_EQ(repaired.changes.duplicate_faces.first[0].earlier, 5U);
    const RepairMap::FaceImage& image = repaired.map.image(FaceId{32});
    EXPECT_EQ(image.face, 5U);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(repaired.lists.triangles[5][image.corner[k]], file.triangles[32][k]);
    }
  }
}

TEST(MeshRepair, ZeroAreaFacesGoWhereNoGapIsLeft) {
  // On the boundary of a sheet, a flat face is attached by one edge.
  const RepairedMesh flap = repaired_and_usable(with_zero_area_face(grid(2, 2), 0));
  EXPECT_EQ(counts_of(flap.changes), (Counts{.zero_area = 1}));
  // In the middle of a sheet, removal would leave a gap, so the flat face stays.
  MeshLists inside = grid(2, 2);
  inside.points.emplace_back(0.5, 0.5, 0);
  inside.triangles[0] = {4, 9, 1};
  inside.triangles.insert(inside.triangles.end(), {{9, 0, 1}, {4, 0, 9}});
  ASSERT_EQ(inspect(inside).zero_area_faces.count, 1U);
  EXPECT_EQ(counts_of(repaired_and_usable(inside).changes), Counts{});
}

TEST(MeshRepair, AChainOfFlatFlapsGoesWhole) {
  MeshLists file = grid(1, 1);
  file.points.emplace_back(0.5, 0, 0);
  file.triangles.push_back({1, 0, 4});
  file.points.emplace_back(0.25, 0, 0);
  file.triangles.insert(file.triangles.begin(), {4, 0, 5});  // attached to the last flap
  EXPECT_EQ(counts_of(repaired_and_usable(file).changes), (Counts{.zero_area = 2}));
}

TEST(MeshRepair, ACollapsedEdgeClosesUp) {
  // The two vertices of an edge have the same position: they are welded, and the two faces of the
  // edge are dropped.
  MeshLists file = sphere(2);
  const Triangle t = file.triangles[10];
  file.points[t[1]] = file.points[t[0]];
  const RepairedMesh repaired = repaired_and_usable(file);
  EXPECT_EQ(counts_of(repaired.changes), (Counts{.welded = 1, .collapsed = 2}));
  EXPECT_EQ(inspect(repaired.lists).genus, 0);
  EXPECT_EQ(inspect(repaired.lists).boundary_loops, 0U);
}

TEST(MeshRepair, Orientation) {
  const RepairedMesh one = repaired_and_usable(with_turned_face(torus(8, 6), 17));
  EXPECT_EQ(counts_of(one.changes), (Counts{.turned = 1}));
  EXPECT_EQ(one.changes.turned_faces.first, std::vector<std::uint32_t>{17});
  EXPECT_EQ(one.lists.triangles, torus(8, 6).triangles);

  MeshLists most = sphere(1);
  for (std::size_t f = 3; f < most.triangles.size(); ++f) most = with_turned_face(most, f);
  EXPECT_EQ(repaired_and_usable(most).changes.turned_faces.first,
            (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(MeshRepair, OneSidedSurfacesStay) {
  const MeshLists file = moebius(8);
  const RepairedMesh repaired = repair(file);
  EXPECT_EQ(counts_of(repaired.changes), Counts{});
  EXPECT_EQ(inspect(repaired.lists).verdict, MeshVerdict::kUnusable);
}

TEST(MeshRepair, AFinBecomesASheet) {
  const MeshLists file = with_fin(sphere(2), 40);
  const RepairedMesh repaired = repaired_and_usable(file);
  EXPECT_EQ(counts_of(repaired.changes), (Counts{.edges = 1, .vertices = 2, .copies = 2}));
  const MeshInspection after = inspect(repaired.lists);
  EXPECT_EQ(after.components, 2U);
  EXPECT_EQ(after.boundary_loops, 1U);  // the sphere stays closed: the flattest pair is joined
  const Triangle t = file.triangles[40];
  EXPECT_EQ(repaired.map.images(VertexId{t[0]}).size(), 2U);
}

TEST(MeshRepair, TwoBoxesWithACommonEdge) {
  // The second box begins where the first ends, in the opposite corner: they share an edge.
  MeshLists file = box();
  const MeshLists other = box();
  std::vector<std::uint32_t> number;
  for (const Point& p : other.points) {
    const Point moved = p + Point(1, 1, 0);
    std::uint32_t v = 0;
    while (v < file.points.size() && file.points[v] != moved) ++v;
    if (v == file.points.size()) file.points.push_back(moved);
    number.push_back(v);
  }
  for (const Triangle& t : other.triangles) {
    file.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  }
  ASSERT_EQ(inspect(file).non_manifold_edges.count, 1U);
  const RepairedMesh repaired = repaired_and_usable(file);
  EXPECT_EQ(counts_of(repaired.changes).edges, 1U);
  EXPECT_EQ(inspect(repaired.lists).boundary_loops, 0U);
}

TEST(MeshRepair, ManyFacesAtOneEdge) {
  // A book of n pages: pages that run along the back in opposite ways are joined in pairs.
  for (const std::uint32_t n : {3U, 8U, 16U, 17U, 500U}) {
    MeshLists file;
    file.points = {Point(0, 0, 0), Point(0, 0, 1)};
    for (std::uint32_t k = 0; k < n; ++k) {
      file.points.emplace_back(std::cos(6.0 * k / n), std::sin(6.0 * k / n), 0.5);
      if (k % 2 == 0) file.triangles.push_back({0, 1, k + 2});
      if (k % 2 == 1) file.triangles.push_back({1, 0, k + 2});
    }
    const std::size_t sheets = n > 16 ? n : n - n / 2;
    const RepairedMesh repaired = repaired_and_usable(file);
    EXPECT_EQ(counts_of(repaired.changes),
              (Counts{.edges = 1, .vertices = 2, .copies = 2 * (sheets - 1)}));
    EXPECT_EQ(inspect(repaired.lists).components, sheets);
  }
}

TEST(MeshRepair, BowTiesArePartedAndIsolatedVerticesStay) {
  const MeshLists file = with_bow_tie(sphere(1), 3);
  const RepairedMesh repaired = repaired_and_usable(file);
  EXPECT_EQ(counts_of(repaired.changes), (Counts{.vertices = 1, .copies = 1}));
  EXPECT_EQ(repaired.changes.split_vertices.first, std::vector<std::uint32_t>{3});
  EXPECT_EQ(repaired.lists.points.size(), file.points.size() + 1);
  EXPECT_EQ(inspect(repaired.lists).isolated_vertices.count, 1U);
}

TEST(MeshRepair, AMeshWhoseWeldIsSplitAgainIsUnchanged) {
  // Two spheres that touch in a point, with separate vertices there.
  const MeshLists file = together(sphere(1), sphere(1), 2);
  ASSERT_EQ(inspect(file).duplicate_positions.count, 1U);
  EXPECT_EQ(counts_of(repaired_and_usable(file).changes), Counts{});
}

TEST(MeshRepair, StepsAreDoneOneByOne) {
  const MeshLists file = with_turned_face(with_bow_tie(with_repeated_vertex(sphere(1)), 3), 4);
  EXPECT_EQ(counts_of(repair(file, repair_steps("orient")).changes), (Counts{.turned = 1}));
  EXPECT_EQ(counts_of(repair(file, repair_steps("split")).changes),
            (Counts{.vertices = 1, .copies = 1}));
  EXPECT_EQ(counts_of(repair(file, repair_steps("drop")).changes), (Counts{.collapsed = 2}));
  EXPECT_EQ(counts_of(repair(file, repair_steps("weld")).changes), Counts{});
  EXPECT_EQ(counts_of(repaired_and_usable(file, repair_steps("drop,split,orient")).changes),
            (Counts{.collapsed = 2, .turned = 1, .vertices = 1, .copies = 1}));
}

TEST(MeshRepair, TheListOfSteps) {
  const RepairSteps all = repair_steps("all");
  EXPECT_TRUE(all.weld && all.drop && all.orient && all.split);
  const RepairSteps two = repair_steps("split,weld");
  EXPECT_TRUE(two.weld && !two.drop && !two.orient && two.split);
  EXPECT_NE(refusal("weld,flip").find("\"flip\""), std::string::npos);
  for (const char* list : {"", ",", "weld,", " weld", "Weld"}) {
    EXPECT_NE(refusal(list), "") << list;
  }
}

TEST(MeshRepair, DefectsThatNoRepairMends) {
  EXPECT_THROW(repair(MeshLists{}), Error);
  EXPECT_THROW(repair(with_index_out_of_range(sphere(1), 3)), Error);
  EXPECT_THROW(repair(with_coordinate(sphere(1), 3, std::nan(""))), Error);
}

TEST(MeshRepair, SentencesNameCountsAndPlaces) {
  const std::vector<std::string> told =
      sentences(repair(with_turned_face(with_bow_tie(sphere(1), 3), 4)).changes);
  EXPECT_EQ(told,
            (std::vector<std::string>{"Repair: 1 face was turned around (face 4).",
                                      "Repair: 1 vertex was split, 1 was added (vertex 3)."}));
  // 1800 faces with 3 vertices each become a grid of 31 x 31 vertices; 5400 - 961 are welded.
  const std::vector<std::string> welded = sentences(repair(soup(grid(30, 30))).changes);
  ASSERT_EQ(welded.size(), 1);
  EXPECT_TRUE(welded[0].starts_with("Repair: 4,439 vertices were welded onto others")) << welded[0];
}

TEST(MeshRepair, CurvesGoThereAndBack) {
  // A face is turned, its double dropped, and a vertex split.
  MeshLists file = with_bow_tie(sphere(2), 3);
  file = with_duplicate_face(with_turned_face(file, 7), 9, true);
  const RepairedMesh repaired = repaired_and_usable(file);
  const SurfaceMesh mesh = SurfaceMesh::open(repaired.lists);
  const auto last = static_cast<std::uint32_t>(file.triangles.size() - 1);
  for (const std::uint32_t f : {0U, 7U, 9U, 200U, last}) {
    CurveInput input;
    input.points = std::vector<FaceCoordinates>{{FaceId{f}, {0.5, 0.25, 0.25}},
                                                {FaceId{f}, {0.125, 0.25, 0.625}}};
    const Triangle& t = file.triangles[f];
    const SnappedCurve there = snap(mesh, repaired.map.to_repaired(input, mesh.surface()));
    const Point expected =
        0.125 * file.points[t[0]] + 0.25 * file.points[t[1]] + 0.625 * file.points[t[2]];
    EXPECT_LT((mesh.position(there.points[1]) - expected).norm(), 1e-14);
    const PlacedCurve back = repaired.map.to_file(place(mesh, {false, there.points}));
    if (f == last) {  // its points are in the face that stays
      EXPECT_EQ(back.faces[1].face.index(), 9U);
    } else {
      EXPECT_EQ(back.faces[1].face.index(), f);
      EXPECT_EQ(back.faces[1].barycentric, (std::array<double, 3>{0.125, 0.25, 0.625}));
    }
  }
}

TEST(MeshRepair, VertexCurvesTakeTheSideTheyAreOn) {
  const MeshLists one = sphere(2);
  const MeshLists file = with_bow_tie(one, 3);
  const auto shift = static_cast<std::uint32_t>(one.points.size());
  const RepairedMesh repaired = repaired_and_usable(file);
  const SurfaceMesh mesh = SurfaceMesh::open(repaired.lists);
  // Two neighbours of vertex 3, in different faces.
  std::vector<VertexId> ring;
  for (const Triangle& t : one.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (t[k] == 3) ring.push_back(VertexId{t[(k + 1) % 3]});
    }
  }
  ASSERT_GE(ring.size(), 3U);
  for (const std::uint32_t side : {0U, shift}) {
    CurveInput input;
    input.points = std::vector<VertexId>{VertexId{ring[0].index() + side}, VertexId{3},
                                         VertexId{ring[2].index() + side}};
    const CurveInput there = repaired.map.to_repaired(input, mesh.surface());
    const SnappedCurve snapped = snap(mesh, there);  // throws unless they are neighbours
    const PlacedCurve back = repaired.map.to_file(place(mesh, {false, snapped.points}));
    EXPECT_EQ(back.vertices, std::get<std::vector<VertexId>>(input.points));
  }
  CurveInput beyond;
  beyond.points = std::vector<VertexId>{VertexId{0}, VertexId{file.points.size()}};
  EXPECT_THROW(static_cast<void>(repaired.map.to_repaired(beyond, mesh.surface())), Error);
}

TEST(MeshRepair, CornersOfADroppedDoubleAreThoseOfTheFaceThatStays) {
  // Face 1 repeats face 0 with a separate vertex 3 at the position of vertex 2; face 2 only touches
  // there.
  MeshLists lists;
  lists.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}, {-1, 2, 0}, {1, 3, 0}};
  lists.triangles = {{0, 1, 2}, {0, 1, 3}, {3, 5, 4}};
  const RepairedMesh repaired = repair(lists);
  ASSERT_EQ(repaired.changes.duplicate_faces.count, 1U);
  const RepairMap::FaceImage image = repaired.map.image(FaceId{1});
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t v = repaired.lists.triangles[image.face][image.corner[k]];
    const auto became = repaired.map.images(VertexId{lists.triangles[1][k]});
    EXPECT_NE(std::find(became.begin(), became.end(), v), became.end()) << "corner " << k;
  }
  EXPECT_EQ(repaired.map.images(VertexId{3}).size(), 2U);  // there, and of face 2
}

TEST(MeshRepair, VerdictsNameTheStepsAndTryingThemTellsWhereTheyDoNotHelp) {
  MeshLists turned = grid(4, 4);
  std::swap(turned.triangles[7][0], turned.triangles[7][1]);
  MeshInspection found = inspect(turned);
  EXPECT_EQ(found.steps, "orient");
  try_repair(turned, found);
  EXPECT_EQ(found.verdict, MeshVerdict::kRepairable);
  // A Moebius strip of five faces with the first face doubled. The doubled face makes edges of more
  // than two faces, so the strip is found to be one-sided only after the double is dropped.
  MeshLists strip;
  for (int k = 0; k < 5; ++k)
    strip.points.emplace_back(std::cos(1.3 * k), std::sin(1.3 * k), k % 2);
  strip.triangles = {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}};
  EXPECT_EQ(inspect(strip).verdict, MeshVerdict::kUnusable);
  strip.triangles.push_back(strip.triangles[0]);
  found = inspect(strip);
  EXPECT_EQ(found.verdict, MeshVerdict::kRepairable);
  EXPECT_EQ(found.steps, "drop,orient,split");
  try_repair(strip, found);
  EXPECT_EQ(found.verdict, MeshVerdict::kUnusable);
  EXPECT_NE(found.reason.find("does not help: The surface is one-sided"), std::string::npos)
      << found.reason;
  EXPECT_EQ(inspect(grid(3, 3)).steps, "");
}

TEST(MeshRepair, CurvesInDroppedFacesAreRefused) {
  const MeshLists file = with_repeated_vertex(sphere(1));
  const RepairedMesh repaired = repaired_and_usable(file);
  const SurfaceMesh mesh = SurfaceMesh::open(repaired.lists);
  CurveInput input;
  input.points =
      std::vector<FaceCoordinates>{{FaceId{0}, {0.5, 0.25, 0.25}}, {FaceId{32}, {0.5, 0.25, 0.25}}};
  try {
    static_cast<void>(repaired.map.to_repaired(input, mesh.surface()));
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "At position 1 of the curve: face 32 was dropped by the repair.");
  }
}

/// The mesh with separate vertices for every triangle, as in an STL file.
MeshLists soup_of(const MeshLists& mesh) {
  MeshLists soup;
  for (const Triangle& t : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for (const std::uint32_t v : t) soup.points.push_back(mesh.points[v]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

TEST(MeshRepair, TellsTheEffectOfWeldingASoup) {
  const MeshLists soup = soup_of(grid(4, 3));  // 20 vertices, 24 faces
  const MeshInspection before = inspect(soup);
  EXPECT_EQ(before.verdict, MeshVerdict::kUsable);
  EXPECT_EQ(before.components, 24U);
  const auto welded = try_weld(soup, before);
  ASSERT_TRUE(welded);
  EXPECT_EQ(welded->steps, "weld");
  EXPECT_EQ(welded->vertices, 3U * 24U - 20U);
  EXPECT_EQ(welded->after.components, 1U);
  EXPECT_EQ(welded->after.boundary_loops, 1U);
  EXPECT_EQ(welded->after.boundary_edges, 14U);

  // Faces that turn against each other when they are joined, and three of one edge.
  const MeshLists turned = soup_of(with_turned_face(grid(4, 3), 3));
  EXPECT_EQ(try_weld(turned, inspect(turned)).value().steps, "weld,orient");
  const MeshLists fin = soup_of(with_fin(sphere(1), 0));
  EXPECT_NE(try_weld(fin, inspect(fin)).value().steps.find("split"), std::string::npos);

  // No sentence if nothing is joined.
  EXPECT_FALSE(try_weld(grid(4, 3), inspect(grid(4, 3))));
  MeshLists isolated = grid(4, 3);
  isolated.points.push_back(isolated.points[5]);
  EXPECT_FALSE(try_weld(isolated, inspect(isolated)));
}

/// Programs write a vertex for each normal or texture coordinate that it has, and only a corner of
/// two faces may then be shared, which needs a repair of its own.
TEST(MeshRepair, TellsTheEffectOfWeldingTornFaces) {
  MeshLists fan;  // three triangles around the origin; the middle one has vertices of its own
  fan.points = {{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {-1, 1, 0}, {-2, 0, 0}};
  fan.points.insert(fan.points.end(), {fan.points[0], fan.points[2], fan.points[3]});
  fan.triangles = {{0, 1, 2}, {5, 6, 7}, {0, 3, 4}};
  const MeshInspection before = inspect(fan);
  EXPECT_EQ(before.verdict, MeshVerdict::kRepairable);
  EXPECT_EQ(before.components, 3U);
  const auto welded = try_weld(fan, before);
  ASSERT_TRUE(welded);
  EXPECT_EQ(welded->steps, "weld");
  EXPECT_EQ(welded->after.components, 1U);
  EXPECT_EQ(welded->after.boundary_loops, 1U);
}

/// The defects in the collection's table, and their repair.
TEST(MeshRepair, RealMeshes) {
  const std::filesystem::path folder = test::mesh_folder();
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << test::missing("real meshes");
  const Counts teeth =
      counts_of(repaired_and_usable(read_mesh(folder / "teeth_bowtie_10k.ply")).changes);
  EXPECT_EQ(teeth.vertices, 40U);
  EXPECT_EQ(
      counts_of(repaired_and_usable(read_mesh(folder / "car_nonmanifold_251k.ply")).changes).edges,
      33U);
  repaired_and_usable(read_mesh(folder / "misoriented_25k.ply"));
  const MeshLists buildings = read_mesh(folder / "buildings_needles_400k.ply");
  EXPECT_EQ(counts_of(repaired_and_usable(buildings).changes).welded, 27U);
}

}  // namespace
}  // namespace talweg::test
