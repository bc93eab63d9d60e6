// talweg.cut, talweg.labels, talweg.repair and talweg.measure, and repair in all plugins, against
// geometry and the library.
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "plugins/plugin_runs.hpp"
#include "talweg/core/labels/label_network.hpp"
#include "talweg/core/measure/curve_measurement.hpp"

namespace talweg {
namespace {

host::Attribute attribute(std::string name, std::uint32_t element, std::uint32_t carry,
                          std::uint32_t columns, std::vector<double> values) {
  host::Attribute result;
  result.name = std::move(name);
  result.element = element;
  result.carry = carry;
  result.columns = columns;
  result.values = std::move(values);
  return result;
}

std::vector<double> flat(const std::vector<Point>& points) {
  std::vector<double> values;
  for (const Point& p : points) values.insert(values.end(), p.begin(), p.end());
  return values;
}

std::string sentence_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const host::Error& error) {
    return error.what();
  }
  return "no error";
}

class OnHills : public testing::Test {
 protected:
  explicit OnHills(const char* id) : instance(test::plugin_of_this_build(id), services) {}
  host::Results run_with_meshes() {
    host::Wanted wanted;
    wanted.meshes = wanted.vertex_fields = true;
    return instance.run(wanted);
  }

  test::Subject subject;
  host::Services services{"test", "1"};
  host::Instance instance;
};

std::vector<std::string> warnings_of(const host::Results& results) {
  const host::ReportEntry* warnings = results.find("warnings");
  return warnings == nullptr ? std::vector<std::string>() : warnings->texts;
}

struct CutPlugin : OnHills {
  CutPlugin() : OnHills("talweg.cut") {
    test::set_mesh(instance, subject.lists);
    host::Curve across;  // straight over the faces, from boundary to boundary
    for (const std::uint32_t v : {14U * 41, 26U * 41 + 40}) {
      const Point& p = subject.lists.points[v];
      across.positions.push_back({p.x(), p.y(), p.z()});
    }
    instance.set_curves({across});
  }
};

TEST_F(CutPlugin, TellsTheOriginOfAllElements) {
  instance.set("open", 1.0);
  const host::Results results = run_with_meshes();
  ASSERT_EQ(results.meshes.size(), 1U);
  EXPECT_EQ(results.number("pieces"), 2);
  const host::Mesh& mesh = results.meshes[0];
  const host::Origin origin = instance.origin(0);
  ASSERT_EQ(origin.vertices.size(), mesh.positions.size());
  ASSERT_EQ(origin.triangles.size(), mesh.triangles.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    Point there = Point::Zero();
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      sum += origin.weights[v][k];
      if (origin.vertices[v][k] == TALWEG_NO_VERTEX) continue;
      there += origin.weights[v][k] * subject.lists.points[origin.vertices[v][k]];
    }
    EXPECT_NEAR(sum, 1, 1e-14);
    EXPECT_LT((there - Point(mesh.positions[v].data())).norm(), 1e-12);
  }
  // Triangles are parts of those that they name: areas add up.
  const auto area = [](const auto& a, const auto& b, const auto& c) {
    return (Point(b) - Point(a)).cross(Point(c) - Point(a)).norm() / 2;
  };
  std::map<std::uint32_t, double> parts;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const auto& t = mesh.triangles[f];
    parts[origin.triangles[f]] +=
        area(Point(mesh.positions[t[0]].data()), Point(mesh.positions[t[1]].data()),
             Point(mesh.positions[t[2]].data()));
  }
  ASSERT_EQ(parts.size(), subject.lists.triangles.size());
  for (const auto& [face, sum] : parts) {
    const Triangle& t = subject.lists.triangles[face];
    EXPECT_NEAR(
        sum,
        area(subject.lists.points[t[0]], subject.lists.points[t[1]], subject.lists.points[t[2]]),
        1e-12);
  }
  // Both sides of the open seam are there at every place of the chain.
  ASSERT_EQ(origin.lengths.size(), 1U);
  EXPECT_EQ(origin.chains.size(), 2 * origin.lengths[0]);
  EXPECT_EQ(origin.closed, std::vector<std::uint32_t>{0});
}

/// The triangles of a mesh after a plan was applied by hand, and its positions.
std::pair<std::vector<std::array<std::uint32_t, 3>>, std::vector<std::array<double, 3>>>
applied_by_hand(const MeshLists& lists, const host::CutPlan& plan) {
  std::vector<std::array<double, 3>> positions;
  for (const Point& p : lists.points) positions.push_back({p.x(), p.y(), p.z()});
  positions.insert(positions.end(), plan.positions.begin(), plan.positions.end());
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::size_t next = 0, part = 0;
  for (std::uint32_t f = 0; f < lists.triangles.size(); ++f) {
    if (next == plan.divided.size() || plan.divided[next] != f) {
      triangles.push_back(lists.triangles[f]);
      continue;
    }
    for (std::uint32_t k = 0; k < plan.parts[next]; ++k)
      triangles.push_back(plan.triangles[part++]);
    ++next;
  }
  return {triangles, positions};
}

TEST_F(CutPlugin, GivesThePlanOfItsMesh) {
  const host::Results planned = instance.run();
  const host::CutPlan plan = instance.cut_plan();
  EXPECT_EQ(plan.vertex_count, subject.lists.points.size());
  EXPECT_EQ(plan.triangle_count, subject.lists.triangles.size());
  const host::Results made = run_with_meshes();
  const auto [triangles, positions] = applied_by_hand(subject.lists, plan);
  EXPECT_EQ(made.meshes.at(0).triangles, triangles);
  EXPECT_EQ(made.meshes.at(0).positions, positions);
  ASSERT_EQ(planned.report.size(), made.report.size());
  for (std::size_t k = 0; k < made.report.size(); ++k) {
    EXPECT_EQ(planned.report[k].key, made.report[k].key);
    if (made.report[k].key == "time_ms.cut") continue;
    EXPECT_EQ(planned.report[k].numbers, made.report[k].numbers) << made.report[k].key;
  }
  // It tells the same as the mesh's origin.
  const host::Origin origin = instance.origin(0);
  for (std::size_t k = 0; k < plan.vertices.size(); ++k) {
    EXPECT_EQ(plan.vertices[k], origin.vertices[subject.lists.points.size() + k]);
    EXPECT_EQ(plan.weights[k], origin.weights[subject.lists.points.size() + k]);
  }
  EXPECT_EQ(plan.closed, origin.closed);
  EXPECT_EQ(plan.lengths, origin.lengths);
  ASSERT_EQ(plan.chains.size(), origin.chains.size());
  for (std::size_t k = 0; k < plan.chains.size(); ++k) {
    EXPECT_EQ(plan.chains[k], origin.chains[k][2]);
  }
}

TEST_F(CutPlugin, HasAPlanOnlyAfterARun) {
  const std::string none = "There is no plan; run() makes one.";
  const auto ask = [&] { static_cast<void>(instance.cut_plan()); };
  EXPECT_EQ(sentence_of(ask), none);
  instance.run();
  EXPECT_EQ(sentence_of(ask), "no error");
  instance.set_curves({subject.curve});
  EXPECT_EQ(sentence_of(ask), none);
  instance.set("open", 1.0);
  instance.run();
  EXPECT_EQ(sentence_of(ask), "no error");
  test::set_mesh(instance, subject.lists);
  EXPECT_EQ(sentence_of(ask), none);
  host::Instance other(test::plugin_of_this_build("talweg.draw"), services);
  EXPECT_EQ(sentence_of([&] { static_cast<void>(other.cut_plan()); }),
            "talweg.draw gives no plan of a cut.");
}

TEST_F(CutPlugin, HasNoPlanForAMeshThatItRepaired) {
  instance.set("repair", 1.0);
  test::set_mesh(instance, test::with_duplicate_face(subject.lists, 0, false));
  instance.set_curves({subject.curve});
  instance.run();
  EXPECT_EQ(
      sentence_of([&] { static_cast<void>(instance.cut_plan()); }),
      "The mesh was repaired before it was cut, so the plan does not fit the mesh that was given.");
}

TEST_F(CutPlugin, CarriesAttributesOfAllKinds) {
  const std::vector<Point>& points = subject.lists.points;
  std::vector<double> numbers, faces, corners;
  for (std::size_t v = 0; v < points.size(); ++v) numbers.push_back(static_cast<double>(v % 7));
  for (const Triangle& t : subject.lists.triangles) {
    faces.push_back(static_cast<double>(faces.size()));
    for (const std::uint32_t v : t) corners.insert(corners.end(), {points[v].x(), points[v].y()});
  }
  instance.set_attributes(
      {attribute("place", TALWEG_OF_VERTICES, TALWEG_CARRY_LINEAR, 3, flat(points)),
       attribute("number", TALWEG_OF_VERTICES, TALWEG_CARRY_NEAREST, 1, numbers),
       attribute("direction", TALWEG_OF_VERTICES, TALWEG_CARRY_DIRECTION, 3,
                 std::vector<double>(3 * points.size(), 0.5773502691896258)),
       attribute("face", TALWEG_OF_TRIANGLES, TALWEG_CARRY_NEAREST, 1, faces),
       attribute("uv", TALWEG_OF_CORNERS, TALWEG_CARRY_LINEAR, 2, corners)});
  instance.set("split", 1.0);
  instance.set("keep", "left");
  instance.set("cap", "none");
  const host::Results results = run_with_meshes();
  ASSERT_EQ(results.meshes.size(), 1U);
  const host::Mesh& mesh = results.meshes[0];
  const host::Origin origin = instance.origin(0);
  const std::vector<host::Attribute> carried = instance.attributes(0);
  ASSERT_EQ(carried.size(), 5U);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(carried[0].values[3 * v + k], mesh.positions[v][k], 1e-12);
      EXPECT_NEAR(carried[2].values[3 * v + k], 0.5773502691896258, 1e-15);
    }
    EXPECT_EQ(carried[1].values[v], std::floor(carried[1].values[v]));
  }
  EXPECT_EQ(carried[3].values,
            std::vector<double>(origin.triangles.begin(), origin.triangles.end()));
  ASSERT_EQ(carried[4].element, std::uint32_t{TALWEG_OF_CORNERS});
  ASSERT_TRUE(carried[4].corners.empty());
  ASSERT_EQ(carried[4].values.size(), 6 * mesh.triangles.size());
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t d = 0; d < 2; ++d) {
        EXPECT_NEAR(carried[4].values[6 * f + 2 * k + d], mesh.positions[mesh.triangles[f][k]][d],
                    1e-12);
      }
    }
  }
}

TEST_F(CutPlugin, RefusesAttributesThatDoNotFit) {
  const std::size_t n = subject.lists.points.size();
  const auto refusal = [&](const host::Attribute& wrong) {
    return sentence_of([&] { instance.set_attributes({wrong}); });
  };
  using V = std::vector<double>;
  EXPECT_EQ(
      refusal(attribute("a", TALWEG_OF_VERTICES, TALWEG_CARRY_LINEAR, 1, V(n - 1))),
      "The attribute \"a\" has " + std::to_string(n - 1) + " rows, not " + std::to_string(n) + ".");
  EXPECT_EQ(refusal(attribute("", TALWEG_OF_VERTICES, TALWEG_CARRY_LINEAR, 1, V(n))),
            "An attribute has no name.");
  EXPECT_EQ(refusal(attribute("a", 4, TALWEG_CARRY_LINEAR, 1, V(n))),
            "The attribute \"a\" is of the unknown element 4.");
  EXPECT_EQ(refusal(attribute("a", TALWEG_OF_VERTICES, 9, 1, V(n))),
            "The attribute \"a\" has the unknown rule 9.");
  EXPECT_EQ(refusal(attribute("n", TALWEG_OF_VERTICES, TALWEG_CARRY_DIRECTION, 1, V(n))),
            "The attribute \"n\" is a direction and has 1 columns, not 3.");
  host::Attribute shared = attribute("uv", TALWEG_OF_CORNERS, TALWEG_CARRY_LINEAR, 2, V{0, 0});
  shared.corners.assign(subject.lists.triangles.size(), {0, 0, 1});
  EXPECT_EQ(refusal(shared),
            "The attribute \"uv\" has the entry 1 at triangle 0, but only 1 entries.");
  const host::Attribute good = attribute("a", TALWEG_OF_VERTICES, TALWEG_CARRY_LINEAR, 1, V(n));
  EXPECT_EQ(sentence_of([&] {
              instance.set_attributes({good, good});
            }),
            "The attribute \"a\" is given twice.");
}

TEST_F(CutPlugin, GivesOnlyMeshesOfTheLastRun) {
  EXPECT_EQ(sentence_of([&] { (void)instance.origin(0); }),
            "There is no mesh 0: 0 were made by the last run that gave meshes.");
  run_with_meshes();
  EXPECT_EQ(sentence_of([&] { (void)instance.origin(0); }), "no error");
  EXPECT_EQ(sentence_of([&] { (void)instance.attributes(1); }),
            "There is no mesh 1: 1 were made by the last run that gave meshes.");
  instance.run();  // without meshes
  EXPECT_EQ(sentence_of([&] { (void)instance.origin(0); }),
            "There is no mesh 0: 0 were made by the last run that gave meshes.");
}

TEST_F(CutPlugin, RefusesBadInput) {
  host::Curve wrong;
  wrong.vertices = {0, 700, 3};
  EXPECT_NE(sentence_of([&] { instance.set_curves({wrong}); }).find("0 and 700"),
            std::string::npos);
  host::Curve slit;  // ends inside
  slit.vertices = {420, 421, 422};
  instance.set_curves({slit});
  instance.set("keep", "left");
  EXPECT_NE(sentence_of([&] { run_with_meshes(); }).find("does not separate the mesh: its start"),
            std::string::npos);
}

TEST_F(CutPlugin, LeadsEndsToTheBorderWhereASeamIsOpened) {
  host::Curve row;  // the hills' row 20, one vertex short of either border
  for (std::uint32_t i = 1; i < 40; ++i) row.vertices.push_back(20 * 41 + i);
  instance.set_curves({row});
  EXPECT_EQ(warnings_of(instance.run()).size(), 0U);  // only edges: it may end anywhere
  instance.set("split", 1.0);
  const host::Results led = run_with_meshes();
  EXPECT_EQ(led.meshes.size(), 2U);
  EXPECT_EQ(led.number("separates.0"), 1);
  ASSERT_EQ(warnings_of(led).size(), 2U);
  EXPECT_EQ(warnings_of(led)[0].find("The start of curve 0 lies "), 0U);
  instance.set("border", "leave");
  const host::Results left = run_with_meshes();
  EXPECT_EQ(left.meshes.size(), 1U);
  EXPECT_EQ(left.number("separates.0"), 0);
  ASSERT_EQ(warnings_of(left).size(), 1U);
  EXPECT_EQ(warnings_of(left)[0].find("Curve 0 does not separate the mesh: its start"), 0U);
}

TEST_F(CutPlugin, CanBeCancelledBeforeWithinAndAfterTheCut) {
  for (const double last : {0.0, 0.5, 1.0}) {
    const host::Services cancelling("test", "1", [&](const char* stage, double fraction) {
      return std::string(stage) != "cut" || fraction < last;
    });
    host::Instance cut(test::plugin_of_this_build("talweg.cut"), cancelling);
    test::set_mesh(cut, subject.lists);
    cut.set_curves({subject.curve});
    EXPECT_EQ(sentence_of([&] { cut.run(); }), "Cancelled.") << last;
  }
}

struct MeasurePlugin : OnHills {
  MeasurePlugin() : OnHills("talweg.measure") { test::set_mesh(instance, subject.lists); }
};

TEST_F(MeasurePlugin, IsTheLibrarysMeasurement) {
  host::Curve straight;
  straight.positions = {{1, 14, 0}, {39, 26, 0}};
  instance.set_curves({subject.curve, straight});
  instance.set("others", 1.0);
  instance.set("edge", 1.5);
  const host::Results results = instance.run();
  const SurfaceMesh& mesh = subject.opened->mesh();
  CurveMeasurementOptions options;
  options.edge = 1.5;
  const CurveMeasurement alone = measure_curves(mesh, std::span(&subject.drawn, 1), {}, options);
  EXPECT_EQ(results.number("length"), alone.curves.total.measures.length);
  EXPECT_EQ(results.number("bending"), alone.curves.total.measures.bending);
  EXPECT_GT(results.number("deviation_to_other_max"), 1);
  EXPECT_GT(results.number("other.length"), 38);
}

TEST_F(MeasurePlugin, NeedsACurveOfItsOwn) {
  instance.set_curves({subject.curve});
  instance.set("others", 1.0);
  EXPECT_EQ(sentence_of([&] { instance.run(); }),
            "Curves to compare with (others) must be less than all 1 curves, not 1.");
}

struct LabelsPlugin : OnHills {
  LabelsPlugin() : OnHills("talweg.labels") { test::set_mesh(instance, subject.lists); }
  std::vector<double> halves() const {
    std::vector<double> labels;
    for (const Triangle& t : subject.lists.triangles) {
      labels.push_back(subject.lists.points[t[0]].y() < 20 ? 3 : 7);
    }
    return labels;
  }
};

TEST_F(LabelsPlugin, IsTheLibrarysNetwork) {
  const std::vector<double> labels = halves();
  instance.set("triangle_labels", labels);
  const host::Results results = run_with_meshes();
  const LabelNetwork network =
      smooth_labels(subject.opened, std::vector<std::int64_t>(labels.begin(), labels.end()));
  ASSERT_EQ(results.curves.size(), network.borders.size());
  EXPECT_TRUE(test::same_bits(results.curves[0],
                              place(subject.opened->mesh(), network.borders[0].border.curve)));
  ASSERT_EQ(results.fields.size(), 1U);
  EXPECT_EQ(results.fields[0].values,
            std::vector<double>(network.face_labels.begin(), network.face_labels.end()));
  const host::Attribute exact = instance.attributes(0).at(0);
  EXPECT_EQ(exact.name, "label");
  EXPECT_EQ(exact.values,
            std::vector<double>(network.cut_labels.begin(), network.cut_labels.end()));
  EXPECT_EQ(results.number("borders.0.left"), 3);
  EXPECT_EQ(results.number("borders.0.right"), 7);
}

TEST_F(LabelsPlugin, RefusesInvalidLabels) {
  EXPECT_EQ(sentence_of([&] { instance.run(); }),
            "There are no labels: set triangle_labels or vertex_labels.");
  instance.set("triangle_labels", std::vector<double>{1, 2});
  EXPECT_EQ(sentence_of([&] { instance.run(); }),
            "Labels of triangles (triangle_labels) has 2 values, but the mesh has " +
                std::to_string(subject.lists.triangles.size()) + " triangles.");
  std::vector<double> half = halves();
  half[5] = 1.5;
  instance.set("triangle_labels", half);
  EXPECT_EQ(sentence_of([&] { instance.run(); }),
            "Labels of triangles (triangle_labels) must be whole numbers, not 1.5 at 5.");
  instance.set("vertex_labels", std::vector<double>{1});
  EXPECT_EQ(sentence_of([&] { instance.run(); }),
            "Both triangle_labels and vertex_labels are set; set only one of them.");
}

struct RepairPlugin : OnHills {
  RepairPlugin() : OnHills("talweg.repair") {}
  /// A face turned, a face twice, a face without area, and an own copy of a vertex.
  MeshLists broken() const {
    MeshLists lists = subject.lists;
    std::swap(lists.triangles[100][1], lists.triangles[100][2]);
    lists.triangles.push_back(lists.triangles[7]);
    lists.triangles.push_back({4, 4, 5});
    lists.points.push_back(lists.points[lists.triangles[300][0]]);
    lists.triangles[300][0] = static_cast<std::uint32_t>(lists.points.size() - 1);
    return lists;
  }
};

TEST_F(RepairPlugin, MakesASurfaceAndTellsTheNewNumberOfEachElement) {
  const MeshLists lists = broken();
  test::set_mesh(instance, lists);
  std::vector<double> faces;
  for (std::size_t f = 0; f < lists.triangles.size(); ++f) faces.push_back(static_cast<double>(f));
  instance.set_attributes({attribute("face", TALWEG_OF_TRIANGLES, TALWEG_CARRY_NEAREST, 1, faces)});
  const host::Results results = run_with_meshes();
  EXPECT_EQ(results.text("verdict"), "repairable");
  EXPECT_EQ(results.text("repair.verdict"), "usable");
  EXPECT_EQ(results.number("repair.turned_faces.count"), 1);
  ASSERT_EQ(results.meshes.size(), 1U);
  const host::Mesh& mesh = results.meshes[0];
  EXPECT_EQ(mesh.triangles.size(), subject.lists.triangles.size());
  const host::Origin origin = instance.origin(0);
  EXPECT_EQ(instance.attributes(0).at(0).values,
            std::vector<double>(origin.triangles.begin(), origin.triangles.end()));
  ASSERT_EQ(results.fields.size(), 2U);
  const std::vector<double>&vertices = results.fields[0].values,
        &triangles = results.fields[1].values;
  ASSERT_EQ(vertices.size(), lists.points.size());
  ASSERT_EQ(triangles.size(), lists.triangles.size());
  EXPECT_EQ(triangles.back(), -1);  // the face without area
  for (std::size_t f = 0; f < origin.triangles.size(); ++f) {
    EXPECT_EQ(triangles[origin.triangles[f]], static_cast<double>(f)) << f;
  }
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    ASSERT_GE(vertices[v], 0) << v;  // the copy of a vertex is welded
    const auto& at = mesh.positions.at(static_cast<std::size_t>(vertices[v]));
    EXPECT_EQ(Point(at[0], at[1], at[2]), lists.points[v]) << v;
  }
  // What comes out can be opened.
  host::Instance draw(test::plugin_of_this_build("talweg.draw"), services);
  draw.set_mesh(host::view(mesh.positions.front().data(), mesh.positions.size(), 3),
                host::view(mesh.triangles.front().data(), mesh.triangles.size(), 3));
}

TEST_F(RepairPlugin, ReportsListsThatCannotBeRepaired) {
  MeshLists lists = subject.lists;
  lists.triangles[3][0] = 999999;
  test::set_mesh(instance, lists);
  const host::Results results = run_with_meshes();
  EXPECT_EQ(results.text("verdict"), "not_usable");
  EXPECT_TRUE(results.meshes.empty());
  EXPECT_EQ(results.number("defects.indices_out_of_range.count"), 1);
}

TEST_F(RepairPlugin, OnlyInspectsIfAsked) {
  test::set_mesh(instance, broken());
  instance.set("repair", 0.0);
  const host::Results results = run_with_meshes();
  EXPECT_EQ(results.text("verdict"), "repairable");
  EXPECT_EQ(results.find("repair.verdict"), nullptr);
  EXPECT_TRUE(results.meshes.empty());
}

/// Repair as a parameter of a plugin on curves.
class RepairParameter : public RepairPlugin {
 protected:
  host::Instance smooth{test::plugin_of_this_build("talweg.smooth"), services};
  MeshLists lists = broken();

  /// A curve of the whole mesh, in the numbers of the broken one.
  host::Curve drawn() const {
    host::Curve curve;
    for (const Point& p : positions_of(subject.opened->mesh(), subject.drawn)) {
      curve.positions.push_back({p.x(), p.y(), p.z()});
    }
    return curve;
  }
};

TEST_F(RepairParameter, ResultsHaveTheNumbersOfTheInput) {
  EXPECT_NE(sentence_of([&] { test::set_mesh(smooth, lists); }), "no error");
  smooth.set("repair", 1.0);
  test::set_mesh(smooth, lists);
  smooth.set_curves({drawn()});
  host::Wanted wanted;
  wanted.vertex_fields = true;
  const host::Results results = smooth.run(wanted);
  const host::Curve& curve = results.curves.at(0);
  for (std::size_t k = 0; k < curve.faces.size(); ++k) {
    ASSERT_LT(curve.faces[k], lists.triangles.size());
    Point there = Point::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
      there += curve.barycentrics[k][i] * lists.points[lists.triangles[curve.faces[k]][i]];
    }
    EXPECT_LT((there - Point(curve.positions[k].data())).norm(), 1e-12);
  }
  EXPECT_EQ(results.fields.at(0).values.size(), lists.points.size());
  const host::ReportEntry* warnings = results.find("warnings");
  ASSERT_NE(warnings, nullptr);
  EXPECT_GE(warnings->texts.size(), 3U);  // welded, dropped, turned
}

TEST_F(RepairParameter, MayBeSetAfterTheMeshAndTheCurves) {
  test::set_mesh(smooth, subject.lists);
  smooth.set_curves({subject.curve});
  const host::Results before = smooth.run();
  smooth.set("repair", 1.0);  // nothing to repair: the same
  EXPECT_TRUE(test::same_bits(smooth.run().curves.at(0), before.curves.at(0)));
  smooth.set("repair", 0.0);
  EXPECT_TRUE(test::same_bits(smooth.run().curves.at(0), before.curves.at(0)));

  host::Instance again(test::plugin_of_this_build("talweg.smooth"), services);
  again.set("repair", 1.0);
  test::set_mesh(again, lists);
  again.set_curves({drawn()});
  const host::Results repaired = again.run();
  again.set("repair", 0.0);
  EXPECT_NE(sentence_of([&] { again.run(); }), "no error");
  again.set("repair", 1.0);
  EXPECT_TRUE(test::same_bits(again.run().curves.at(0), repaired.curves.at(0)));
}

}  // namespace
}  // namespace talweg
