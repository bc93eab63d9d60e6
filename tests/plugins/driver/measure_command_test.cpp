// talweg measure as its users see it, against closed forms on a plane of unit squares.
#include <cmath>
#include <numbers>
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

constexpr double kPi = std::numbers::pi;

/// An OBJ file of lines; a closed one repeats its first point's number.
std::string lines(const std::vector<std::vector<Point>>& curves, bool closed) {
  std::string vertices, elements;
  std::size_t next = 1;
  for (const auto& curve : curves) {
    elements += "l";
    const std::size_t first = next;
    for (const Point& p : curve) {
      vertices += "v";
      for (int k = 0; k < 3; ++k) {
        vertices += ' ';
        vertices += std::to_string(p[k]);
      }
      vertices += '\n';
      elements += ' ';
      elements += std::to_string(next++);
    }
    if (closed) {
      elements += ' ';
      elements += std::to_string(first);
    }
    elements += '\n';
  }
  vertices += elements;
  return vertices;
}

class MeasureCommand : public test::DriverRuns {
 protected:
  void SetUp() override {
    DriverRuns::SetUp();
    write_mesh(file("mesh.ply"), test::grid(30, 20));
  }
  [[nodiscard]] nlohmann::json report(const std::string& arguments) const {
    std::string command("measure ");
    command.append(arguments).append(" --report r.json");
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    return nlohmann::json::parse(bytes_of(file("r.json")));
  }
};

TEST_F(MeasureCommand, MeasuresACornerAndASquare) {
  write("corner.txt", "0\n1\n2\n33\n64\n95\n");  // two to the right, three up
  const auto corner = report("mesh.ply corner.txt");
  EXPECT_EQ(corner["faces"], 1200);
  EXPECT_EQ(corner["vertices"], 651);
  EXPECT_EQ(corner["points"], 6);
  EXPECT_EQ(corner["closed"], false);
  EXPECT_NEAR(corner["length"], 5, 1e-12);
  EXPECT_NEAR(corner["curvature"], kPi / 2, 1e-12);
  EXPECT_NEAR(corner["curvature_signed"], kPi / 2, 1e-12);
  EXPECT_NEAR(corner["curvature_max"], kPi / 2, 1e-12);
  EXPECT_EQ(corner["curvature_max_at"], nlohmann::json({2.0, 0.0, 0.0}));
  EXPECT_NEAR(corner["bending"], 2 * kPi / 2 * kPi / 2, 1e-9);  // one kink alone
  EXPECT_NEAR(corner["window_turning"], kPi / 2, 1e-12);
  EXPECT_NEAR(corner["window_turning_2"], kPi / 2, 1e-12);
  EXPECT_NEAR(corner["tortuosity"], 5 / std::sqrt(13.0), 1e-12);
  EXPECT_EQ(corner["self_contacts"], 0);
  EXPECT_TRUE(corner["self_contacts_at"].empty());
  EXPECT_TRUE(corner["warnings"].empty());
  EXPECT_FALSE(corner.contains("curves"));
  EXPECT_FALSE(corner.contains("other"));
  EXPECT_FALSE(corner.contains("deviation_at"));
  // Gauss and Bonnet: once around turns by a full turn; clockwise it is negative.
  write("square.txt", "64\n95\n96\n65\n64\n");
  const auto square = report("mesh.ply square.txt");
  EXPECT_EQ(square["closed"], true);
  EXPECT_EQ(square["points"], 4);
  EXPECT_NEAR(square["length"], 4, 1e-12);
  EXPECT_TRUE(square["tortuosity"].is_null());
  EXPECT_NEAR(square["curvature"], 2 * kPi, 1e-12);
  EXPECT_NEAR(square["curvature_signed"], -2 * kPi, 1e-12);
  // The edges near it have lengths of 1 and √2: one window holds two corners, two hold three.
  EXPECT_GT(square["edge_length_near"], 1.0);
  EXPECT_LT(square["edge_length_near"], 1.5);
  EXPECT_NEAR(square["window_turning"], kPi, 1e-12);
  EXPECT_NEAR(square["window_turning_2"], 1.5 * kPi, 1e-12);
}

TEST_F(MeasureCommand, WindowsHaveTheGivenLength) {
  write("square.txt", "64\n95\n96\n65\n64\n");
  const auto square = report("mesh.ply square.txt --edge 0.5");
  EXPECT_EQ(square["edge_length_near"], 0.5);
  EXPECT_NEAR(square["window_turning"], kPi / 2, 1e-12);
  EXPECT_NEAR(square["window_turning_2"], kPi, 1e-12);
  EXPECT_NEAR(square["bending"], 4 * 2 * kPi / 2 * kPi / 2, 1e-9);  // four kinks, each alone
  for (const std::string bad : {"0", "-1", "nan", "inf"}) {
    const Outcome refused = run("measure mesh.ply square.txt --edge " + bad);
    EXPECT_EQ(refused.code, 1) << bad;
    EXPECT_NE(refused.err.find("edge must be"), std::string::npos) << refused.err;
  }
}

TEST_F(MeasureCommand, CountsSelfContacts) {
  write("eight.obj", lines({{{4, 4, 0}, {16, 12, 0}, {16, 4, 0}, {4, 12, 0}}}, true));
  const auto eight = report("mesh.ply eight.obj");
  EXPECT_EQ(eight["self_contacts"], 1);
  EXPECT_EQ(eight["self_contact_stretches"], 0);
  EXPECT_NEAR(eight["self_contacts_at"][0][0], 10, 1e-9);
  EXPECT_NEAR(eight["self_contacts_at"][0][1], 8, 1e-9);
  EXPECT_NEAR(eight["curvature_signed"], 0, 1e-9);  // its two loops turn against each other
  write("back.obj", lines({{{4, 4.5, 0}, {16, 4.5, 0}, {9, 4.5, 0}}}, false));
  EXPECT_EQ(report("mesh.ply back.obj")["self_contact_stretches"], 1);
}

TEST_F(MeasureCommand, ComparesAlongTheSurface) {
  // A spike of height 3 over a straight line.
  write("line.obj", lines({{{5, 2, 0}, {15, 2, 0}}}, false));
  write("spike.obj", lines({{{5, 2, 0}, {10, 5, 0}, {15, 2, 0}}}, false));
  const auto r = report("mesh.ply line.obj spike.obj");
  EXPECT_NEAR(r["length"], 10, 1e-9);
  EXPECT_NEAR(r["other"]["length"], 2 * std::sqrt(34.0), 1e-9);
  EXPECT_NEAR(r["deviation_from_other_max"], 3, 1e-9);
  EXPECT_NEAR(r["deviation_from_other_mean"], 1.5, 3e-3);
  EXPECT_NEAR(r["deviation_to_other_max"], 15 / std::sqrt(34.0), 3e-3);
  EXPECT_NEAR(r["deviation_to_other_mean"], 7.5 / std::sqrt(34.0), 3e-3);
  EXPECT_NEAR(r["deviation_at"][0], 10, 1e-9);
  EXPECT_NEAR(r["deviation_at"][1], 5, 1e-9);
  // The other way around the names change sides.
  const auto turned = report("mesh.ply spike.obj line.obj");
  EXPECT_EQ(turned["deviation_to_other_max"], r["deviation_from_other_max"]);
  EXPECT_EQ(turned["deviation_from_other_mean"], r["deviation_to_other_mean"]);
}

TEST_F(MeasureCommand, ComparesManyOneByOneOrAllTogether) {
  const std::vector<Point> low{{5, 2.3, 0}, {15, 3.3, 0}}, high{{5, 8.3, 0}, {15, 9.3, 0}};
  const auto up = [](std::vector<Point> curve, double by) {
    for (Point& p : curve) p += by * Point(-1, 10, 0).normalized();
    return curve;
  };
  write("two.obj", lines({low, high}, false));
  write("moved.obj", lines({up(low, 1), up(high, 2)}, false));
  const auto pairs = report("mesh.ply two.obj moved.obj");
  ASSERT_EQ(pairs["curves"].size(), 2U);
  EXPECT_NEAR(pairs["curves"][0]["deviation_to_other_max"], 1, 1e-5);  // OBJ has six digits here
  EXPECT_NEAR(pairs["curves"][1]["deviation_to_other_max"], 2, 1e-5);
  EXPECT_NEAR(pairs["deviation_to_other_max"], 2, 1e-5);
  EXPECT_NEAR(pairs["deviation_to_other_mean"], 1.5, 1e-5);
  EXPECT_NEAR(pairs["length"], 2 * std::sqrt(101.0), 1e-9);
  EXPECT_EQ(pairs["other"]["curves"].size(), 2U);
  // Two curves are compared with one all together. The upper curve lies far from the one.
  write("one.obj", lines({up(low, 1)}, false));
  const auto together = report("mesh.ply two.obj one.obj");
  EXPECT_FALSE(together["curves"][0].contains("deviation_to_other_max"));
  EXPECT_NEAR(together["deviation_from_other_max"], 1, 1e-5);
  EXPECT_GT(together["deviation_to_other_max"], 4);
  ASSERT_EQ(together["warnings"].size(), 1U);
  EXPECT_NE(together["warnings"][0].get<std::string>().find("all together"), std::string::npos);
}

TEST_F(MeasureCommand, CountsContactsBetweenCurvesInTheTotal) {
  write("cross.obj", lines({{{5, 2, 0}, {15, 9, 0}}, {{5, 9, 0}, {15, 2, 0}}}, false));
  const auto r = report("mesh.ply cross.obj");
  EXPECT_EQ(r["self_contacts"], 1);
  EXPECT_EQ(r["curves"][0]["self_contacts"], 0);
  EXPECT_EQ(r["curves"][1]["self_contacts"], 0);
}

TEST_F(MeasureCommand, NoWayFromOneToTheOtherIsNull) {
  write_mesh(file("two.ply"), test::together(test::grid(4, 4), test::grid(4, 4), 100));
  write("here.txt", "6\n7\n8\n");
  write("there.txt", "31\n32\n33\n");
  const auto r = report("two.ply here.txt there.txt");
  for (const char* name : {"deviation_to_other_max", "deviation_to_other_mean",
                           "deviation_from_other_max", "deviation_from_other_mean"}) {
    EXPECT_TRUE(r[name].is_null()) << name;
  }
  ASSERT_EQ(r["warnings"].size(), 1U);
  EXPECT_NE(r["warnings"][0].get<std::string>().find("not connected"), std::string::npos);
}

TEST_F(MeasureCommand, AgreesWithTheReportOfSmooth) {
  ASSERT_EQ(run("draw mesh.ply --through 64,400,590 -o drawn.txt").code, 0);
  ASSERT_EQ(run("smooth mesh.ply --curve drawn.txt -o smooth.json --report s.json").code, 0);
  const auto smooth = nlohmann::json::parse(bytes_of(file("s.json")));
  const auto r = report("mesh.ply smooth.json drawn.txt");
  EXPECT_EQ(r["points"], smooth["points_after"]);
  // A sum along the file's order here, along the drawing's canonical order there.
  const auto number = [](const nlohmann::json& value) { return value.get<double>(); };
  const auto same_sum = [&](const nlohmann::json& a, const nlohmann::json& b) {
    EXPECT_NEAR(number(a), number(b), 1e-12 * number(b));
  };
  same_sum(r["length"], smooth["length_after"]);
  same_sum(r["curvature"], smooth["curvature_after"]);
  same_sum(r["tortuosity"], smooth["tortuosity_after"]);
  same_sum(r["other"]["tortuosity"], smooth["tortuosity_before"]);
  same_sum(r["other"]["curvature"], smooth["curvature_before"]);
  const double most = smooth["deviation_from_drawn_max"];
  EXPECT_NEAR(r["deviation_to_other_max"], smooth["deviation_to_drawn_max"], 2e-3 * most + 2e-3);
  EXPECT_NEAR(r["deviation_from_other_max"], most, 2e-3 * most + 2e-3);
  EXPECT_EQ(smooth["deviation"], "surface");
}

TEST_F(MeasureCommand, PrintsATableAndIsQuietWhenAsked) {
  write("corner.txt", "0\n1\n2\n33\n");
  const Outcome one = run("measure mesh.ply corner.txt");
  EXPECT_EQ(one.code, 0);
  for (const char* words : {"corner.txt", "self-contacts", "1.5708", "(2, 0, 0)"}) {
    EXPECT_NE(one.out.find(words), std::string::npos) << one.out;
  }
  EXPECT_EQ(one.out.find("deviation"), std::string::npos);
  write("two.txt", "0\n1\n2\n\n31\n32\n33\n");
  const Outcome two = run("measure mesh.ply two.txt two.txt -v --report r.json");
  for (const char* words : {"deviation", "to the other", "from the other", "all"}) {
    EXPECT_NE(two.out.find(words), std::string::npos) << two.out;
  }
  EXPECT_EQ(run("-q measure mesh.ply corner.txt").out, "");
  EXPECT_NE(run("measure --help").out.find("one by one in their order"), std::string::npos);
}

TEST_F(MeasureCommand, RefusesBadUse) {
  write("a.txt", "0\n1\n2\n");
  write("bad.txt", "0\n9999\n");
  write("torn.txt", "0\n300\n");
  expect_failure("measure", 1, {"mesh"});
  expect_failure("measure mesh.ply", 1, {"curve"});
  expect_failure("measure mesh.ply a.txt a.txt a.txt", 1, {"a.txt"});
  expect_failure("measure mesh.ply a.txt --tau 1", 1, {"--tau"});
  expect_failure("measure none.ply a.txt", 2, {"none.ply"});
  expect_failure("measure mesh.ply none.txt", 2, {"none.txt"});
  expect_failure("measure mesh.ply bad.txt", 2, {"9999", "651"});
  expect_failure("measure mesh.ply a.txt bad.txt", 2, {"9999"});
  expect_failure("measure mesh.ply torn.txt", 2, {"300"});
  expect_failure("measure mesh.ply a.txt --report nowhere/r.json", 2, {"nowhere"});
  write_mesh(file("nan.ply"), test::with_coordinate(test::grid(4, 4), 5, std::nan("")));
  expect_failure("measure nan.ply a.txt", 2, {"finite"});
}

}  // namespace
}  // namespace talweg
