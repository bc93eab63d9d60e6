// talweg cut as its users see it, on a ball and a plane.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/generated_meshes.hpp"
#include "core/jagged_curves.hpp"
#include "core/mesh_numbers.hpp"
#include "plugins/driver_runs.hpp"
#include "talweg/core/io/curve_file.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/core/io/mesh_writer.hpp"
#include "talweg/core/mesh/mesh_inspection.hpp"

namespace talweg {
namespace {

class CutCommand : public test::DriverRuns {
 protected:
  void SetUp() override {
    DriverRuns::SetUp();
    const MeshLists lists = test::sphere(4);
    write_mesh(file("ball.ply"), lists);
    const auto opened = OpenedMesh::open(lists);
    const auto points = test::circle({0, 0, 0.3}, {0.95, 0, 0}, {0, 0.95, 0}, 24);
    const SurfaceCurve ring =
        smooth_curve(opened, test::drawn_near(opened->mesh(), points, true)).curve();
    write_curves(file("ring.json"), opened->mesh(), std::span(&ring, 1));
    write_mesh(file("plane.ply"), test::grid(10, 10));
    write(file("line.txt"), "3\n14\n25\n36\n");
    write(file("other.txt"), "44\n45\n46\n");
  }
  static void write(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path) << text;
  }
  [[nodiscard]] nlohmann::json json(const std::string& name) const {
    return nlohmann::json::parse(bytes_of(file(name)));
  }
  [[nodiscard]] bool there(const std::string& name) const {
    return std::filesystem::exists(file(name));
  }
};

TEST_F(CutCommand, MakesTheCurveEdgesOfTheMesh) {
  const Outcome outcome = run("cut ball.ply --curve ring.json -o cut.ply --map map.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const MeshLists old = read_mesh(file("ball.ply")), cut = read_mesh(file("cut.ply"));
  EXPECT_GT(cut.points.size(), old.points.size());
  EXPECT_TRUE(std::equal(old.points.begin(), old.points.end(), cut.points.begin()));
  EXPECT_EQ(inspect(cut).verdict, MeshVerdict::kUsable);
  const nlohmann::json part = json("map.json")["parts"][0];
  ASSERT_EQ(part["vertices"].size(), cut.points.size());
  ASSERT_EQ(part["faces"].size(), cut.triangles.size());
  for (std::size_t v = 0; v < cut.points.size(); ++v) {
    const nlohmann::json& from = part["vertices"][v];
    Point at = Point::Zero();
    if (from.size() == 1) {
      at = old.points[from[0]];
    } else if (from.size() == 3) {
      const double t = from[2];
      at = (1 - t) * old.points[from[0]] + t * old.points[from[1]];
    } else {
      for (std::size_t k = 0; k < 3; ++k) at += double{from[3 + k]} * old.points[from[k]];
    }
    EXPECT_LT((at - cut.points[v]).norm(), 1e-14);
  }
  EXPECT_EQ(part["curves"].size(), 1U);
  EXPECT_TRUE(part["curves"][0]["closed"]);
}

TEST_F(CutCommand, SplitsAndCaps) {
  const Outcome outcome =
      run("cut ball.ply --curve ring.json -o half.ply --split --cap --map map.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("2 pieces"), std::string::npos) << outcome.out;
  EXPECT_FALSE(there("half.ply"));
  for (const char* name : {"half-0.ply", "half-1.ply"}) {
    const MeshInspection part = inspect(read_mesh(file(name)));
    EXPECT_EQ(part.verdict, MeshVerdict::kUsable);
    EXPECT_EQ(part.boundary_loops, 0U) << name;
  }
  EXPECT_FALSE(there("half-2.ply"));
  EXPECT_TRUE(json("map.json")["parts"][1]["faces"].back().is_null());  // a lid's
}

TEST_F(CutCommand, KeepsASide) {
  ASSERT_EQ(run("cut ball.ply --curve ring.json -o left.ply --keep left").code, 0);
  ASSERT_EQ(run("cut ball.ply --curve ring.json -o right.ply --keep right").code, 0);
  const auto lowest = [&](const char* name) {
    double low = 2;
    for (const Point& p : read_mesh(file(name)).points) low = std::min(low, p.z());
    return low;
  };
  EXPECT_NEAR(std::min(lowest("left.ply"), lowest("right.ply")), -1, 0.01);
  EXPECT_NEAR(std::max(lowest("left.ply"), lowest("right.ply")), 0.3, 0.1);
}

TEST_F(CutCommand, OpensSeamsOfOneAndOfMoreCurves) {
  const Outcome outcome =
      run("cut plane.ply --curve line.txt --curve other.txt -o open.ply --open");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const MeshLists open = read_mesh(file("open.ply"));
  // line.txt begins at the boundary, so three of its vertices are doubled. Of the other curve the
  // middle and the end at the boundary are doubled.
  EXPECT_EQ(open.points.size(), 121U + 3 + 2);
  EXPECT_EQ(open.triangles.size(), 200U);
}

TEST_F(CutCommand, CarriesAttributesOfVerticesAndFaces) {
  const MeshLists lists = read_mesh(file("ball.ply"));
  MeshAttributes attributes;
  AttributeColumn height{"height", NumberType::kFloat64, {}}, red{"red", NumberType::kUint8, {}};
  for (const Point& p : lists.points) {
    height.values.push_back(p.z());
    red.values.push_back(p.z() > 0 ? 255 : 0);
  }
  AttributeColumn label{"label", NumberType::kInt32, {}};
  for (std::size_t f = 0; f < lists.triangles.size(); ++f) {
    label.values.push_back(static_cast<double>(f));
  }
  attributes.vertices = {height, red};
  attributes.faces = {label};
  write_mesh(file("rich.ply"), lists, attributes);
  const Outcome outcome =
      run("cut rich.ply --curve ring.json -o part.ply --split --cap --map map.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out.find("Not carried"), std::string::npos) << outcome.out;
  const nlohmann::json map = json("map.json");
  for (std::size_t k = 0; k < 2; ++k) {
    MeshAttributes part;
    const MeshLists cut = read_mesh(file(k == 0 ? "part-0.ply" : "part-1.ply"), part);
    ASSERT_EQ(part.vertices.size(), 2U);
    EXPECT_EQ(part.vertices[1].type, NumberType::kUint8);
    for (std::size_t v = 0; v < cut.points.size(); ++v) {
      EXPECT_NEAR(part.vertices[0].values[v], cut.points[v].z(), 1e-14);  // linear
    }
    ASSERT_EQ(part.faces.size(), 1U);
    EXPECT_EQ(part.faces[0].type, NumberType::kInt32);
    const nlohmann::json& faces = map["parts"][k]["faces"];
    for (std::size_t f = 0; f < cut.triangles.size(); ++f) {
      EXPECT_EQ(part.faces[0].values[f], faces[f].is_null() ? 0 : faces[f].get<double>());
    }
  }
  const Outcome stl = run("cut rich.ply --curve ring.json -o part.stl");
  EXPECT_NE(stl.out.find("part.stl does not hold: 'height' of vertices, 'red' of vertices, 'label' "
                         "of faces."),
            std::string::npos)
      << stl.out;
}

TEST_F(CutCommand, TagsTheCurvesEdges) {
  for (const char* name : {"tagged.ply", "tagged.obj"}) {
    const Outcome outcome =
        run(std::string("cut ball.ply --curve ring.json --tag -o ") + name + " --map map.json");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    // The file of the mesh is then one of curves, too.
    const std::vector<CurveInput> curves = read_curves(file(name));
    ASSERT_EQ(curves.size(), 1U) << name;
    EXPECT_TRUE(curves[0].closed);
    const MeshLists cut = read_mesh(file(name));
    const nlohmann::json chain = json("map.json")["parts"][0]["curves"][0]["vertices"];
    const auto& points = std::get<std::vector<Point>>(curves[0].points);
    ASSERT_EQ(points.size(), chain.size());
    for (std::size_t i = 0; i < chain.size(); ++i) {
      EXPECT_EQ(points[i], cut.points[chain[i][0]]);
    }
  }
}

TEST_F(CutCommand, ClosesWithLidsOfAKind) {
  // Two parallels of a tube are plane; the ring on the ball is not.
  write_mesh(file("tube.ply"), test::tube(16, 9, 4));
  std::string ring;
  for (int k = 48; k < 64; ++k) ring += std::to_string(k) + "\n";
  write(file("parallel.txt"), ring + "48\n");
  const Outcome plane = run("cut tube.ply --curve parallel.txt -o t.ply --cap=planar");
  ASSERT_EQ(plane.code, 0) << plane.err;
  EXPECT_NE(plane.out.find("2 rims closed by 28 faces, 2 of them planar"), std::string::npos)
      << plane.out;
  const Outcome least = run("cut ball.ply --curve ring.json -o b.ply --cap");
  EXPECT_NE(least.out.find("0 of them planar"), std::string::npos) << least.out;
  expect_failure("cut ball.ply --curve ring.json -o c.ply --cap=planar", 2,
                 {"The rim of ", "is not planar"});
  expect_failure("cut ball.ply --curve ring.json -o c.ply --cap=round", 1,
                 {"--cap", "planar", "round"});
  expect_failure("cut ball.ply --curve ring.json -o c.stl --tag", 1,
                 {"--tag", ".ply, .obj, .vtk or .vtp"});
}

/// A parallel of a tube of 16 columns. Seen from outside, the part above is on its left.
std::string parallel(int row) {
  std::string ring;
  for (int k = 0; k <= 16; ++k) ring += std::to_string(16 * row + k % 16) + "\n";
  return ring;
}

TEST_F(CutCommand, KeepsThePiecesOnOneSideOfEveryCurve) {
  write_mesh(file("tube.ply"), test::tube(16, 9, 8));
  write(file("low.txt"), parallel(2));
  write(file("high.txt"), parallel(5));
  const auto heights = [&](const std::string& name) {
    double low = 9, high = -1;
    for (const Point& p : read_mesh(file(name)).points) {
      low = std::min(low, p.z());
      high = std::max(high, p.z());
    }
    return std::pair(low, high);
  };
  // The band between the two is on the left of one and on the right of the other.
  const std::string both = "cut tube.ply --curve low.txt --curve high.txt ";
  const Outcome left = run(both + "-o left.ply --keep left");
  ASSERT_EQ(left.code, 0) << left.err;
  EXPECT_NE(left.out.find("1 of them left out"), std::string::npos) << left.out;
  EXPECT_EQ(heights("left.ply"), std::pair(5.0, 8.0));
  ASSERT_EQ(run(both + "-o right.ply --keep right").code, 0);
  EXPECT_EQ(heights("right.ply"), std::pair(0.0, 2.0));
  // With one curve reversed, the band is on the left of both, and the rest on the right.
  std::string turned;
  for (int k = 16; k >= 0; --k) turned += std::to_string(80 + k % 16) + "\n";
  write(file("turned.txt"), turned);
  const std::string around = "cut tube.ply --curve low.txt --curve turned.txt ";
  const Outcome between = run(around + "-o between.ply --keep left");
  ASSERT_EQ(between.code, 0) << between.err;
  EXPECT_EQ(between.out.find("left out"), std::string::npos) << between.out;
  EXPECT_EQ(heights("between.ply"), std::pair(2.0, 5.0));
  ASSERT_EQ(run(around + "-o rest.ply --keep right --split").code, 0);
  EXPECT_EQ(heights("rest-0.ply"), std::pair(0.0, 2.0));
  EXPECT_EQ(heights("rest-1.ply"), std::pair(5.0, 8.0));
}

TEST_F(CutCommand, RefusesToKeepNothing) {
  std::string around;  // the sheet's boundary, with the sheet on its left
  for (int k = 0; k < 10; ++k) around += std::to_string(k) + "\n";
  for (int k = 0; k < 10; ++k) around += std::to_string(10 + 11 * k) + "\n";
  for (int k = 0; k < 10; ++k) around += std::to_string(120 - k) + "\n";
  for (int k = 0; k <= 10; ++k) around += std::to_string(110 - 11 * k) + "\n";
  write(file("around.txt"), around);
  ASSERT_EQ(run("cut plane.ply --curve around.txt -o all.ply --keep left").code, 0);
  EXPECT_EQ(read_mesh(file("all.ply")).triangles.size(), 200U);
  expect_failure("cut plane.ply --curve around.txt -o c.ply --keep right", 2,
                 {"keep right leaves nothing", "curve 0 has no face on the right"});
  // Around a torus nothing is on the left of both of two meridians that run the same way.
  write_mesh(file("torus.ply"), test::torus(16, 32));
  write(file("one.txt"), parallel(3));
  write(file("two.txt"), parallel(20));
  expect_failure(
      "cut torus.ply --curve one.txt --curve two.txt -o c.ply --keep left", 2,
      {"keep left leaves nothing", "curve 0", "curve 1", "reverse one of the two curves"});
  EXPECT_FALSE(there("c.ply"));
}

TEST_F(CutCommand, LidsRepeatNothingOfThePiece) {
  // One face, and the lid over it, which must not be the same.
  const Triangle t = read_mesh(file("ball.ply")).triangles[500];
  std::string around;
  for (const std::size_t k : {0, 1, 2, 0}) around += std::to_string(t[k]) + "\n";
  write(file("face.txt"), around);
  const Outcome outcome =
      run("cut ball.ply --curve face.txt -o part.ply --split --cap --map map.json --tag");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("1 of them with points inside"), std::string::npos) << outcome.out;
  std::size_t with_points = 0;
  for (int k = 0; k < 2; ++k) {
    const MeshLists part = read_mesh(file(k == 0 ? "part-0.ply" : "part-1.ply"));
    const MeshInspection found = inspect(part);
    EXPECT_EQ(found.verdict, MeshVerdict::kUsable) << found.reason;
    EXPECT_EQ(found.boundary_edges, 0U);
    const nlohmann::json vertices = json("map.json")["parts"][k]["vertices"];
    ASSERT_EQ(vertices.size(), part.points.size());
    with_points += vertices.back().is_null() ? 1U : 0U;
  }
  EXPECT_EQ(with_points, 1U);
}

/// A line over the plane at this height, as an OBJ of positions.
std::string line_over(double from, double to, double y) {
  std::string text, line = "l";
  int n = 0;
  for (double x = from; x <= to + 1e-9; x += 0.25) {
    text += fmt::format("v {} {} 0\n", x, y);
    line += fmt::format(" {}", ++n);
  }
  return text + line + "\n";
}

TEST_F(CutCommand, AnOpenSheetIsCutFromBorderToBorder) {
  write(file("over.obj"), line_over(-2, 12, 5.3));  // over both edges
  Outcome outcome = run("cut plane.ply --curve over.obj -o half.ply --split --report over.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const char* words : {"at its start: 8 points up to 2 mesh units beyond the border",
                            "at its end: 8", "2 pieces"}) {
    EXPECT_NE(outcome.out.find(words), std::string::npos) << outcome.out;
  }
  EXPECT_EQ(json("over.json")["separates"], nlohmann::json::array({true}));
  EXPECT_EQ(json("over.json")["warnings"].size(), 2U);
  const double first = test::area(read_mesh(file("half-0.ply")));
  EXPECT_NEAR(std::min(first, 100 - first), 47, 1e-4);  // coordinates are floats
  EXPECT_NEAR(first + test::area(read_mesh(file("half-1.ply"))), 100, 1e-4);

  write(file("short.obj"), line_over(1, 9, 5.3));
  outcome = run("cut plane.ply --curve short.obj -o led.ply --open --report led.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("The end of curve 0 lies 1 mesh unit from the border of the mesh; "
                             "the curve was extended"),
            std::string::npos)
      << outcome.out;
  EXPECT_EQ(json("led.json")["pieces"], 2);
  EXPECT_EQ(json("led.json")["warnings"].size(), 2U);

  outcome =
      run("cut plane.ply --curve short.obj -o left.ply --open --border leave "
          "--report left.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("Curve 0 does not separate the mesh: its start at (1, 5.3, 0) lies "
                             "inside, 1 mesh unit from the border, and its end at (9, 5.3, 0)"),
            std::string::npos)
      << outcome.out;
  EXPECT_EQ(json("left.json")["pieces"], 1);
  EXPECT_EQ(json("left.json")["separates"], nlohmann::json::array({false}));

  outcome = run("cut plane.ply --curve short.obj -o edges.ply");  // only edges: it ends anywhere
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out.find("border"), std::string::npos) << outcome.out;
  expect_failure("cut plane.ply --curve short.obj -o c.ply --border cut", 1, {"--border"});
}

TEST_F(CutCommand, BorderSnapExtendsDrawingsToTheBorder) {
  const std::string draw = "draw plane.ply --through 56,64 -o ";  // (1, 5) and (9, 5)
  ASSERT_EQ(run(draw + "stays.json").code, 0);
  EXPECT_EQ(json("stays.json")["curves"][0]["points"].front()["xyz"],
            nlohmann::json::array({1, 5, 0}));
  const Outcome drawn = run(draw + "led.json --border snap");
  ASSERT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_NE(drawn.out.find("The start of curve 0 lies 1 mesh unit from the border of the mesh; "
                           "the curve was extended"),
            std::string::npos)
      << drawn.out;
  const auto points = json("led.json")["curves"][0]["points"];
  EXPECT_EQ(points.front()["xyz"], nlohmann::json::array({0, 5, 0}));
  EXPECT_EQ(points.back()["xyz"], nlohmann::json::array({10, 5, 0}));
  const auto is_way_point = [](const nlohmann::json& p) { return p.value("exact", false); };
  EXPECT_EQ(std::count_if(points.begin(), points.end(), is_way_point), 4);
  ASSERT_EQ(run("cut plane.ply --curve led.json -o half.ply --split --border leave").code, 0);
  EXPECT_NEAR(test::area(read_mesh(file("half-0.ply"))), 50, 1e-4);

  for (const char* how : {"led.txt --border snap", "led.json --edges --border snap",
                          "led.json --points rough --border snap"}) {
    expect_failure(draw + how, 1, {"--border snap", "between vertices"});
  }
  const std::string rough = "draw plane.ply --through 56,64 --points rough --straight -o ";
  EXPECT_EQ(run(rough + "rough.json --border snap").code, 0);
}

TEST_F(CutCommand, AStrokeOverTheEdgesIsSmoothedAndCutThere) {
  write(file("over.obj"), line_over(-1, 11, 5.3));
  ASSERT_EQ(run("smooth plane.ply --curve over.obj -o smooth.json").code, 0);
  Outcome outcome = run("cut plane.ply --curve smooth.json -o half.ply --split");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("2 pieces"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("border"), std::string::npos) << outcome.out;
  // A stroke that stops short is smoothed as it is, unless asked for.
  write(file("short.obj"), line_over(1, 9, 5.3));
  outcome =
      run("smooth plane.ply --curve short.obj --border snap -o s.json --report s-report.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NEAR(json("s-report.json")["length_after"], 10, 1e-6);
  EXPECT_EQ(json("s-report.json")["warnings"].size(), 2U);
  ASSERT_EQ(run("smooth plane.ply --curve short.obj -o s.json --report s-report.json").code, 0);
  EXPECT_NEAR(json("s-report.json")["length_after"], 8, 1e-6);
}

TEST_F(CutCommand, RefusesBadUse) {
  expect_failure("cut plane.ply --curve line.txt -o c.ply --keep up", 1,
                 {"--keep", "left or right"});
  expect_failure("cut plane.ply --curve line.txt -o c.ply --keep left", 2,
                 {"Curve 0 does not separate the mesh", "(3, 3, 0)", "no left side to keep"});
  expect_failure("cut plane.ply --curve line.txt -o c.ply --merge 1", 1, {"merge", "1e-2"});
  expect_failure("cut plane.ply --curve none.txt -o c.ply", 2, {"none.txt"});
  expect_failure("cut plane.ply --curve line.txt -o nowhere/c.ply", 2, {"nowhere"});
  expect_failure("cut plane.ply --curve line.txt -o c.xyz", 2, {"xyz"});
  expect_failure("cut plane.ply -o c.ply", 1, {"--curve"});
  EXPECT_FALSE(there("c.ply"));
}

TEST_F(CutCommand, WritesPolygonsWhereAsked) {
  // Two squares and an L of area 3 beside them, which share the side x = 2; a label for each.
  write(file("faces.ply"),
        "ply\nformat ascii 1.0\nelement vertex 10\nproperty double x\nproperty double y\n"
        "property double z\nelement face 3\nproperty list uchar int vertex_indices\n"
        "property int label\nend_header\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 0\n2 1 0\n4 0 0\n"
        "4 2 0\n3 2 0\n3 1 0\n4 0 1 4 3 7\n4 1 2 5 4 8\n6 6 7 8 9 5 2 9\n");
  write(file("up.obj"), "v 0.5 0 0\nv 0.5 1 0\nl 1 2\n");
  const Outcome outcome =
      run("cut faces.ply --curve up.obj -o cut.ply --polygons --map map.json --tag");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("13 vertices, 4 faces"), std::string::npos) << outcome.out;
  MeshAttributes attributes;
  const MeshLists cut = read_mesh(file("cut.ply"), attributes);
  EXPECT_EQ(cut.polygon_count, 4U);
  EXPECT_EQ(cut.polygon_shapes.concave, 1U);
  EXPECT_NEAR(test::area(cut), 5, 1e-14);
  // The halves have a corner on the diagonal, too: three triangles each.
  std::vector<double> labels = attributes.faces.at(0).values;
  std::sort(labels.begin(), labels.end());
  EXPECT_EQ(labels, (std::vector<double>{7, 7, 7, 7, 7, 7, 8, 8, 9, 9, 9, 9}));
  EXPECT_EQ(json("map.json")["parts"][0]["faces"].size(), 4U);
  EXPECT_EQ(run("cut faces.ply --curve up.obj -o plain.ply").code, 0);
  EXPECT_EQ(read_mesh(file("plain.ply")).polygon_count, 0U);
  EXPECT_NEAR(test::area(read_mesh(file("plain.ply"))), 5, 1e-14);
  const Outcome refused = run("cut faces.ply --curve up.obj -o cut.stl --polygons");
  EXPECT_EQ(refused.code, 1);
  EXPECT_NE(refused.err.find("holds polygons: .ply, .obj or .off"), std::string::npos);
}

}  // namespace
}  // namespace talweg
