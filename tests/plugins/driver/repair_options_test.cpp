// --repair as users see it: results in the numbers of their own file.
#include <array>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/generated_meshes.hpp"
#include "core/small_meshes.hpp"
#include "plugins/driver_runs.hpp"
#include "talweg/core/io/mesh_writer.hpp"

namespace talweg {
namespace {

using nlohmann::json;

class RepairOption : public test::DriverRuns {
 protected:
  [[nodiscard]] json read(const std::string& name) const {
    return json::parse(bytes_of(file(name)));
  }
  void succeed(const std::string& arguments) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 0) << arguments << "\n" << outcome.err;
  }
  /// Every point lies where its face of the file and its barycentrics say.
  void expect_on(const MeshLists& lists, const std::string& curves) const {
    const json written = read(curves);
    for (const json& curve : written["curves"]) {
      for (const json& p : curve["points"]) {
        const Triangle& t = lists.triangles.at(p["face"].get<std::size_t>());
        Point at = Point::Zero();
        for (std::size_t k = 0; k < 3; ++k) {
          at += p["barycentric"][k].get<double>() * lists.points[t[k]];
        }
        const auto xyz = p["xyz"].get<std::array<double, 3>>();
        EXPECT_LT((at - Point(xyz.data())).norm(), 1e-12) << p;
      }
    }
  }
};

TEST_F(RepairOption, EverythingInTheNumbersOfTheFile) {
  // Three faces turned, two dropped, and a bow-tie between two sheets.
  MeshLists lists = test::with_bow_tie(test::grid(12, 8), 50);
  for (const std::size_t f : {40U, 95U, 101U}) lists = test::with_turned_face(lists, f);
  lists.triangles.insert(lists.triangles.begin() + 3, {7, 7, 8});
  lists.triangles.insert(lists.triangles.begin() + 60, lists.triangles[10]);
  write_mesh(file("mesh.ply"), lists);
  expect_failure("draw mesh.ply --through 0,50,116 -o no.json", 2, {"face"});
  succeed("draw mesh.ply --repair --through 0,50,116 --points rough -o drawn.json -o drawn.txt");
  expect_on(lists, "drawn.json");
  EXPECT_NE(bytes_of(file("drawn.txt")).find("50"), std::string::npos);
  for (const char* drawn : {"drawn.json", "drawn.txt"}) {
    expect_failure(std::string("smooth mesh.ply -o no.json --curve ") + drawn, 2, {"face"});
    succeed(std::string("smooth mesh.ply --repair=drop,orient,split --pin 50 -o s.json "
                        "--report r.json --curve ") +
            drawn);
    expect_on(lists, "s.json");
    const json report = read("r.json");
    EXPECT_EQ(report["termination"], "converged");
    EXPECT_EQ(report["warnings"].size(), 4U) << report["warnings"];
    EXPECT_NE(report["warnings"].dump().find("3 faces were turned around (face 41, 97, 103)"),
              std::string::npos)
        << report["warnings"];
  }
  succeed("measure mesh.ply s.json drawn.txt --repair --report m.json");
  EXPECT_LT(read("m.json")["deviation_to_other_max"].get<double>(), 2);
}

TEST_F(RepairOption, RunTakesItToo) {
  MeshLists lists = test::with_turned_face(test::with_bow_tie(test::grid(12, 8), 50), 40);
  lists.triangles.insert(lists.triangles.begin() + 3, {7, 7, 8});
  write_mesh(file("mesh.ply"), lists);
  succeed("draw mesh.ply --repair --through 0,50,116 --points rough -o drawn.json -o drawn.txt");
  expect_failure("run talweg.smooth mesh.ply --curve drawn.txt -o no.json", 2, {"face"});
  succeed("smooth mesh.ply --repair --curve drawn.txt -o s.json");
  for (const char* drawn : {"drawn.json", "drawn.txt"}) {
    succeed(std::string("run talweg.smooth mesh.ply --repair -o r.json --curve ") + drawn);
    expect_on(lists, "r.json");
    EXPECT_EQ(read("r.json"), read("s.json"));
  }
  const Outcome distance =
      run("run talweg.distance mesh.ply --repair --curve drawn.txt --write-distance d.txt");
  EXPECT_EQ(distance.code, 0) << distance.err;
  EXPECT_NE(distance.out.find("1 face was turned around"), std::string::npos) << distance.out;
  // One number per vertex of the file, and 0 on the drawing.
  std::istringstream numbers(bytes_of(file("d.txt")));
  std::vector<double> values;
  for (std::string word; numbers >> word;) values.push_back(std::stod(word));  // inf, too
  ASSERT_EQ(values.size(), lists.points.size());
  EXPECT_LT(values[50], 0.3);
  EXPECT_GT(values[12], 2);
}

TEST_F(RepairOption, PositionsStayOnTheirSheet) {
  // The vertex that both sheets share has two copies at one position.
  write_mesh(file("mesh.ply"), test::with_bow_tie(test::grid(12, 8), 50));
  for (const char* through : {"49,50,51", "166,50,168"}) {
    succeed("draw mesh.ply --repair -o d.obj -o d.txt --through " + std::string(through));
    succeed("smooth mesh.ply --repair --curve d.obj -o from_obj.json");
    succeed("smooth mesh.ply --repair --curve d.txt -o from_txt.json");
    EXPECT_EQ(read("from_obj.json"), read("from_txt.json"));
  }
}

TEST_F(RepairOption, SoupOfTriangles) {
  const MeshLists whole = test::sphere(3);
  MeshLists soup;
  for (const Triangle& t : whole.triangles) {
    const auto n = static_cast<std::uint32_t>(soup.points.size());
    for (const std::uint32_t v : t) soup.points.push_back(whole.points[v]);
    soup.triangles.push_back({n, n + 1, n + 2});
  }
  write_mesh(file("soup.obj"), soup);
  expect_failure("draw soup.obj --through 0,900 -o no.txt", 2, {"components"});
  succeed("draw soup.obj --repair=weld --through 0,900 --points rough -o drawn.json");
  succeed("smooth soup.obj --repair=weld --curve drawn.json -o s.json");
  expect_on(soup, "s.json");
}

TEST_F(RepairOption, SeamsAreNamedAndWeldedWithinATolerance) {
  MeshLists plates;  // two of 10 x 10; vertices 1 and 2 lie 1e-6 away from 4 and 7
  plates.points = {{0, 0, 0},         {10, 0, 0}, {10, 10, 0}, {0, 10, 0},
                   {10.000001, 0, 0}, {20, 0, 0}, {20, 10, 0}, {10, 9.999999, 0}};
  plates.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  write_mesh(file("seam.obj"), plates);
  expect_failure("draw seam.obj --through 0,6 --repair -o no.json", 2,
                 {"different components", "4 vertices lie within 1e-06 of others",
                  "repair=weld=1e-06", "1 part instead of 2"});
  succeed("draw seam.obj --through 0,6 --repair=weld=1e-6 -o drawn.json");
  succeed("run talweg.smooth seam.obj --curve drawn.json --repair=all,weld=1e-4 -o ran.json");
  expect_failure("draw seam.obj --through 0,6 --repair=weld=-1 -o no.json", 1,
                 {"length above 0 in mesh units"});
  EXPECT_NE(run("info seam.obj").out.find("4 vertices that nearly coincide with others"),
            std::string::npos);
}

TEST_F(RepairOption, InfoTellsWhatItWouldDo) {
  write_mesh(file("mesh.ply"), test::with_turned_face(test::sphere(2), 17));
  const Outcome text = run("info mesh.ply --repair");
  EXPECT_EQ(text.code, 0);
  EXPECT_NE(text.out.find("Repair: 1 face was turned around (face 17).\nAfter the repair: usable."),
            std::string::npos)
      << text.out;
  succeed("info mesh.ply --repair=weld --json");
  const json told = json::parse(bytes_of(file("out.log")));
  EXPECT_EQ(told["repair"]["turned_faces"]["count"], 0);
  EXPECT_EQ(told["repair"]["verdict"], "repairable");
}

TEST_F(RepairOption, RefusesBadUse) {
  write_mesh(file("turned.ply"), test::with_turned_face(test::sphere(2), 17));
  write_mesh(file("band.ply"), test::moebius(8));
  for (const char* command : {"info turned.ply", "draw turned.ply --through 1,2 -o no.txt"}) {
    expect_failure(command + std::string(" --repair=flip"), 1, {"\"flip\"", "weld"});
  }
  expect_failure("draw turned.ply --repair=weld --through 1,2 -o no.txt", 2,
                 {"repaired", "opposite orientation"});
  expect_failure("draw band.ply --repair --through 1,2 -o no.txt", 2, {"one-sided"});
}

TEST_F(RepairOption, InALineOfABatch) {
  write_mesh(file("mesh.ply"), test::with_turned_face(test::sphere(2), 17));
  succeed("draw mesh.ply --repair --through 0,1 --points rough -o d.json");
  write("list.csv", "mesh,curve,repair,name\nmesh.ply,d.json,,a\nmesh.ply,d.json,orient,b\n");
  EXPECT_EQ(run("smooth --batch list.csv -o '{name}.json'").code, 2);
  EXPECT_EQ(bytes_of(file("err.log")).find("line 3"), std::string::npos);
  expect_on(test::with_turned_face(test::sphere(2), 17), "b.json");
}

}  // namespace
}  // namespace talweg
