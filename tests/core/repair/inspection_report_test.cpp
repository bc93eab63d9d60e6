#include "talweg/core/repair/inspection_report.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/generated_meshes.hpp"
#include "talweg/core/repair/weld_hint.hpp"

namespace talweg {
namespace {

using nlohmann::json;

json json_of(const std::vector<ReportEntry>& entries) { return json::parse(to_json(entries, {})); }

TEST(InspectionReport, DescribesASoundMesh) {
  const json found = json_of(entries_of(inspect(test::grid(3, 2))));
  EXPECT_EQ(found["faces"], 12);
  EXPECT_EQ(found["vertices"], 12);
  EXPECT_EQ(found["edges"], 23);
  EXPECT_EQ(found["euler_characteristic"], 1);
  EXPECT_EQ(found["genus"], 0);
  EXPECT_EQ(found["box_max"], json({3, 2, 0}));
  EXPECT_EQ(found["verdict"], "usable");
  EXPECT_EQ(found["defects"].size(), 12U);
  EXPECT_EQ(found["defects_found"], json::array());
  for (const json& defect : found["defects"]) {
    EXPECT_EQ(defect, json({{"count", 0}, {"first", json::array()}}));
  }
}

TEST(InspectionReport, TellsTheFirstPlacesOfDefects) {
  const MeshLists twice = test::with_duplicate_face(test::grid(3, 2), 4, false);
  const json found = json_of(entries_of(inspect(twice)));
  EXPECT_EQ(found["defects"]["duplicate_faces"],
            json({{"count", 1}, {"first", {{{"id", 12}, {"repeats", 4}}}}}));
  // Face 4 has the vertices 2, 3, 7; only its side 2-7 is shared, with face 5.
  EXPECT_EQ(found["defects_found"],
            json({"1 face that repeats another face: face 12 (repeats 4)",
                  "1 edge with more than two faces: vertices 2-7 (faces 4, 5, 12)",
                  "2 edges between faces of opposite orientation: vertices 2-3 (faces 4, 12), 3-7 "
                  "(faces 4, 12)"}));
  const json out = json_of(entries_of(inspect(test::with_index_out_of_range(test::grid(3, 2), 7))));
  EXPECT_EQ(out["defects"]["indices_out_of_range"]["first"][0]["face"], 7);
  EXPECT_EQ(out["verdict"], "not_usable");
  const json isolated =
      json_of(entries_of(inspect(test::with_isolated_vertices(test::grid(3, 2), 7))));
  EXPECT_EQ(isolated["defects"]["isolated_vertices"],
            json({{"count", 7}, {"first", {12, 13, 14, 15, 16}}}));
  EXPECT_EQ(isolated["defects_found"],
            json({"7 vertices without a face: vertex 12, 13, 14, 15, 16, ..."}));
  MeshLists stray = test::with_isolated_vertices(test::grid(3, 2), 2);
  stray.points.back().x() = NAN;
  EXPECT_EQ(json_of(entries_of(inspect(stray)))["defects_found"],
            json({"2 vertices without a face: vertex 12, 13",
                  "1 vertex without a face, with coordinates that are not finite or too large: "
                  "vertex 13"}));
}

TEST(InspectionReport, EdgesHaveTheirFaces) {
  MeshLists fin = test::grid(1, 1);  // faces 0, 1, 3 and 0, 3, 2
  fin.points.emplace_back(0, 0, 1);
  fin.triangles.push_back({0, 3, 4});
  const json found = json_of(entries_of(inspect(fin)));
  EXPECT_EQ(found["defects"]["non_manifold_edges"],
            json({{"count", 1}, {"first", {{{"vertices", {0, 3}}, {"faces", {0, 1, 2}}}}}}));
  EXPECT_EQ(found["defects_found"],
            json({"1 edge with more than two faces: vertices 0-3 (faces 0, 1, 2)"}));
  EXPECT_TRUE(found["genus"].is_null());
}

TEST(InspectionReport, ListsTheChangesOfARepair) {
  const MeshLists twice = test::with_duplicate_face(test::grid(3, 2), 4, false);
  const RepairedMesh repaired = repair(twice);
  const json found = json_of(entries_of(repaired.changes, inspect(repaired.lists)))["repair"];
  EXPECT_EQ(found["duplicate_faces"],
            json({{"count", 1}, {"first", {{{"id", 12}, {"repeats", 4}}}}}));
  EXPECT_EQ(found["turned_faces"], json({{"count", 0}, {"first", json::array()}}));
  EXPECT_EQ(found["vertex_copies"], 0);
  EXPECT_EQ(found["weld_tolerance"], repaired.changes.weld_tolerance);
  EXPECT_EQ(found["verdict"], "usable");
}

TEST(InspectionReport, TellsTheEffectOfWelding) {
  MeshLists soup;  // two triangles of one square, apart
  for (const Triangle& t : test::grid(1, 1).triangles) {
    for (const std::uint32_t v : t) soup.points.push_back(test::grid(1, 1).points[v]);
  }
  soup.triangles = {{0, 1, 2}, {3, 4, 5}};
  const MeshInspection before = inspect(soup);
  const json weld = json_of(entries_of(try_weld(soup, before), before))["weld"];
  EXPECT_EQ(weld["steps"], "weld");
  EXPECT_EQ(weld["vertices"], 2);
  EXPECT_EQ(weld["components"], 1);
  EXPECT_EQ(
      weld["sentence"],
      "2 vertices lie at the place of others: with repair=weld the mesh has 1 part instead of "
      "2 and 1 boundary loop instead of 2 boundary loops.");
  EXPECT_EQ(weld_hint(soup), " " + weld["sentence"].get<std::string>());
  const MeshLists whole = test::grid(1, 1);
  const MeshInspection fine = inspect(whole);
  EXPECT_TRUE(json_of(entries_of(try_weld(whole, fine), fine))["weld"].is_null());
}

}  // namespace
}  // namespace talweg
