// talweg.smooth through the interface: the library's results, stage by stage.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "plugins/plugin_runs.hpp"
#include "talweg/core/drawing/edge_dijkstra.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/core/measure/report.hpp"
#include "talweg/core/smoothing/max_deviation.hpp"
#include "talweg/core/smoothing/slack_field.hpp"

namespace talweg {
namespace {

using test::same_bits;

class SmoothPlugin : public testing::Test {
 protected:
  SmoothPlugin() { test::set_mesh(smooth_, subject_.lists); }

  /// What the library makes of the subject.
  SmoothingResult by_library(const SmoothingOptions& options, const CurveOptions& curve = {}) {
    CurveSmoother smoother(subject_.opened);
    smoother.set_curve(subject_.drawn, curve);
    return smoother.smooth(options);
  }
  void expect_same(const host::Results& results, const SmoothingResult& library) {
    ASSERT_EQ(results.curves.size(), library.curves.size());
    for (std::size_t c = 0; c < library.curves.size(); ++c) {
      EXPECT_TRUE(same_bits(results.curves[c], place(subject_.opened->mesh(), library.curves[c])));
    }
  }

  test::Subject subject_;
  host::Services services_{"test", "1"};
  host::Instance smooth_{test::plugin_of_this_build("talweg.smooth"), services_};
};

TEST_F(SmoothPlugin, GivesTheLibrarysBitsForEveryTau) {
  smooth_.set_curves({subject_.curve});
  for (const double tau : {0.0, 0.3, 1.0, 4.0, 100.0}) {
    smooth_.set("tau", tau);
    SmoothingOptions options;
    options.tau = tau;
    expect_same(smooth_.run(), by_library(options));
  }
}

TEST_F(SmoothPlugin, TakesOptionsForEachCurve) {
  smooth_.set_curves({subject_.curve});
  SmoothingOptions options;
  options.per_curve = {{.tau = 3, .slack = 0.4, .finish = Finish::kTaut}};
  smooth_.set("taus", std::vector{3.0});
  smooth_.set("slacks", std::vector{0.4});
  smooth_.set("finishes", std::vector{1.0});
  expect_same(smooth_.run(), by_library(options));
  for (const char* id : {"taus", "slacks", "finishes"}) smooth_.set(id, std::vector{-1.0});
  expect_same(smooth_.run(), by_library({}));
  for (const char* id : {"taus", "slacks", "finishes"}) smooth_.reset(id);
  expect_same(smooth_.run(), by_library({}));
}

TEST_F(SmoothPlugin, RefusesOptionsForOtherCurves) {
  smooth_.set_curves({subject_.curve});
  const auto refused = [&](const char* id, const std::vector<double>& values) -> std::string {
    smooth_.set(id, values);
    try {
      smooth_.run();
    } catch (const host::Error& error) {
      EXPECT_EQ(error.status(), TALWEG_BAD_USAGE);
      smooth_.reset(id);
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refused("taus", {1, 2}), "Tau of each curve (taus) has 2 values for 1 curves.");
  EXPECT_EQ(refused("taus", {-2}),
            "Tau of each curve (taus) must be -1 or >= 0 for curve 0, not -2.");
  EXPECT_EQ(refused("slacks", {HUGE_VAL}),
            "Slack of each curve (slacks) must be -1 or >= 0 for curve 0, not inf.");
  EXPECT_EQ(refused("finishes", {2}),
            "Finish of each curve (finishes) must be -1 or in [0, 1] for curve 0, not 2.");
  EXPECT_EQ(refused("finishes", {0.5}), "Finish of each curve (finishes) must be whole.");
  smooth_.set("potential", "paper");
  EXPECT_EQ(refused("taus", {1}), "taus needs the potential corridor.");
}

TEST_F(SmoothPlugin, PassesEveryOptionOn) {
  smooth_.set_curves({subject_.curve});
  SmoothingOptions options;
  options.slack = 0.5;
  options.phase_turns = 1;
  options.deviation = DeviationMeasure::kEuclidean;
  smooth_.set("slack", 0.5);
  smooth_.set("phase_turns", 1.0);
  smooth_.set("deviation", "euclidean");
  const host::Results corridor = smooth_.run();
  expect_same(corridor, by_library(options));
  EXPECT_EQ(corridor.text("deviation"), "euclidean");

  CurveOptions curve;
  curve.method = Method::kPaper;
  curve.heat_time = 2;
  curve.cap_corners = false;
  options = {};
  options.tau = 3;
  options.relax_rounds = 4;
  options.potential.exponent = 3;
  options.potential.gain = 20;
  smooth_.reset("slack");
  smooth_.reset("deviation");
  smooth_.set("potential", "paper");
  smooth_.set("heat_time", 2.0);
  smooth_.set("cap_corners", 0.0);
  smooth_.set("tau", 3.0);
  smooth_.set("relax", 4.0);
  smooth_.set("potential_exponent", 3.0);
  smooth_.set("potential_gain", 20.0);
  expect_same(smooth_.run(), by_library(options, curve));
}

/// Hosts set all that they show before each run.
TEST_F(SmoothPlugin, SettingTheSameValuesCostsNothing) {
  smooth_.set_curves({subject_.curve});
  const double solved = smooth_.run().number("time_ms.solve");
  smooth_.reset("click_distance");
  smooth_.set("ends", "auto");
  smooth_.set("tau", 2.0);
  EXPECT_EQ(smooth_.run().number("time_ms.solve"), solved);
  smooth_.set("ends", "closed");
  EXPECT_NE(smooth_.run().number("time_ms.solve"), solved);
}

TEST_F(SmoothPlugin, LeadsStrokesToTheBorderIfAsked) {
  host::Curve stroke;
  for (int k = 0; k <= 76; ++k) stroke.positions.push_back({1 + 0.5 * k, 20, 0});
  smooth_.set_curves({stroke});
  const double before = smooth_.run().curves.at(0).positions.front()[0];
  smooth_.set("border", "snap");
  const host::Results led = smooth_.run();
  const auto& positions = led.curves.at(0).positions;
  EXPECT_GT(before, 0.5);
  // The hills' border waves by 0.2.
  EXPECT_NEAR(positions.front()[0], 0, 0.2 + 1e-9);
  EXPECT_NEAR(positions.back()[0], 40, 0.2 + 1e-9);
  smooth_.set("border", "leave");
  EXPECT_EQ(smooth_.run().curves.at(0).positions.front()[0], before);
}

TEST_F(SmoothPlugin, MovesStrokesOntoRidgesOnceForAllTaus) {
  MeshLists roof = test::grid(40, 30);
  for (Point& p : roof.points) p.z() = -0.6 * std::abs(p.y() - 15);
  test::set_mesh(smooth_, roof);
  host::Curve stroke;
  for (int k = 0; k <= 60; ++k) {
    const double y = 15 + 1.5 * std::sin(k / 3.0);
    stroke.positions.push_back({5 + 0.5 * k, y, -0.6 * std::abs(y - 15)});
  }
  smooth_.set_curves({stroke});
  const host::Results drawn = smooth_.run();
  EXPECT_EQ(drawn.find("ridge_moved"), nullptr);
  smooth_.set("ridges", 1.0);
  const host::Results ridged = smooth_.run();
  EXPECT_GT(ridged.number("ridge_moved"), 0.9);
  for (const auto& p : ridged.curves.at(0).positions) {  // docs/ridges.md: ends may lie beside it
    EXPECT_NEAR(p[1], 15, p[0] < 30 ? 0.2 : 1.2);
  }
  smooth_.set("tau", 2.0);
  EXPECT_EQ(smooth_.run().number("time_ms.solve"), ridged.number("time_ms.solve"));
  smooth_.set("tau", 1.0);
  smooth_.set("ridges", 0.0);
  EXPECT_EQ(smooth_.run().curves.at(0).positions, drawn.curves.at(0).positions);
}

TEST_F(SmoothPlugin, KeepsPinsAndTheLargestDeviation) {
  host::Curve pinned = subject_.curve;
  pinned.pins = {7};
  smooth_.set_curves({pinned});
  smooth_.set("tau", 0.0);
  CurveOptions curve;
  curve.pins = {subject_.drawn.points[7]};
  SmoothingOptions options;
  options.tau = 0;
  expect_same(smooth_.run(), by_library(options, curve));
  smooth_.set_curves({subject_.curve});  // only the pin is gone
  expect_same(smooth_.run(), by_library(options));

  smooth_.set("max_deviation", 0.4);
  CurveSmoother smoother(subject_.opened);
  smoother.set_curve(subject_.drawn);
  const host::Results within = smooth_.run();
  expect_same(within, smooth_within(smoother, 0.4));
  EXPECT_LE(within.number("deviation_to_drawn_max"), 0.4);
}

TEST_F(SmoothPlugin, TakesFieldsPerVertex) {
  smooth_.set_curves({subject_.curve});
  const std::size_t n = subject_.lists.points.size();
  const std::vector<double> slack(n, 0.3);
  smooth_.set("slack_field", slack);
  SmoothingOptions options;
  options.slack_at = {slack_along(subject_.opened->surface(), subject_.drawn, slack)};
  expect_same(smooth_.run(), by_library(options));

  smooth_.reset("slack_field");
  std::vector<double> distance;
  for (const Point& p : subject_.lists.points) distance.push_back(std::abs(p.x()));
  smooth_.set("potential", "paper");
  smooth_.set("distance", distance);
  CurveSmoother smoother(subject_.opened);
  smoother.set_curves(std::span(&subject_.drawn, 1), distance);
  expect_same(smooth_.run(), smoother.smooth(1));
}

TEST_F(SmoothPlugin, HasTheReportOfTheLibrary) {
  smooth_.set_curves({subject_.curve});
  const SmoothingResult library = by_library({});
  const host::Results results = smooth_.run();
  std::size_t keys = 0;
  for (const ReportEntry& entry : entries_of(library.total)) {
    const host::ReportEntry* own = results.find(entry.key);
    ASSERT_NE(own, nullptr) << entry.key;
    ++keys;
    if (entry.key.starts_with("time_ms") || entry.key == "peak_memory_mib") continue;
    if (const auto* number = std::get_if<double>(&entry.value)) {
      EXPECT_EQ(own->type, TALWEG_VALUE_NUMBER);
      EXPECT_EQ(own->numbers, std::vector<double>{*number}) << entry.key;
    } else if (const auto* count = std::get_if<std::uint64_t>(&entry.value)) {
      EXPECT_EQ(own->type, TALWEG_VALUE_INTEGER);
      EXPECT_EQ(own->numbers, std::vector<double>{static_cast<double>(*count)}) << entry.key;
    } else if (const auto* text = std::get_if<std::string>(&entry.value)) {
      EXPECT_EQ(own->texts, std::vector<std::string>{*text}) << entry.key;
    }
  }
  EXPECT_GT(keys, 40U);
  EXPECT_NE(results.find("termination", 0), nullptr);
  EXPECT_EQ(results.find("termination", 1), nullptr);
}

TEST_F(SmoothPlugin, GivesFieldsWhereTheyAreWanted) {
  smooth_.set_curves({subject_.curve});
  const host::Results plain = smooth_.run();
  EXPECT_TRUE(plain.fields.empty());
  EXPECT_TRUE(plain.curves[0].fields.empty());

  const host::Results results = smooth_.run({.point_fields = true, .vertex_fields = true});
  EXPECT_TRUE(same_bits(plain.curves[0], results.curves[0]));
  ASSERT_EQ(results.curves[0].fields.size(), 2U);
  const host::Field& deviation = results.curves[0].fields[0];
  EXPECT_EQ(deviation.name, "deviation");
  ASSERT_EQ(deviation.values.size(), results.curves[0].faces.size());
  const double most = *std::max_element(deviation.values.begin(), deviation.values.end());
  EXPECT_GT(most, 0);
  EXPECT_LE(most, results.number("deviation_to_drawn_max") * (1 + 1e-2));
  const host::Field& curvature = results.curves[0].fields[1];
  EXPECT_EQ(curvature.name, "curvature");
  double sum = 0;
  for (const double angle : curvature.values) sum += angle;
  EXPECT_NEAR(sum, results.number("curvature_after"), 1e-9);

  ASSERT_EQ(results.fields.size(), 1U);
  ASSERT_EQ(results.fields[0].values.size(), subject_.lists.points.size());
  for (const SurfacePoint& p : subject_.drawn.points) {
    if (const auto* at = std::get_if<AtVertex>(&p.where())) {
      EXPECT_EQ(results.fields[0].values[at->vertex.index()], 0);
    }
  }
}

TEST_F(SmoothPlugin, PointsMayBeVerticesOrPositionsToo) {
  host::Curve by_vertices, by_positions;
  by_vertices.vertices = {200, 201, 202, 243, 284};
  for (const std::uint32_t v : by_vertices.vertices) {
    const Point& p = subject_.lists.points[v];
    by_positions.positions.push_back({p.x(), p.y(), p.z()});
  }
  smooth_.set_curves({by_vertices});
  const host::Curve first = smooth_.run().curves.at(0);
  smooth_.set_curves({by_positions});
  EXPECT_TRUE(same_bits(smooth_.run().curves.at(0), first));

  by_positions.positions[2][2] += 0.1;
  smooth_.set_curves({by_positions});
  const host::Results moved = smooth_.run();
  ASSERT_FALSE(moved.find("warnings")->texts.empty());
  EXPECT_NE(moved.find("warnings")->texts.back().find("moved onto the mesh"), std::string::npos);
}

TEST_F(SmoothPlugin, ReadsMeshesOfEveryTypeAndStride) {
  smooth_.set_curves({subject_.curve});
  const host::Curve expected = smooth_.run().curves.at(0);

  // Rows of positions with something between them; 64-bit triangles in rows of four.
  std::vector<std::array<double, 5>> rows;
  for (const Point& p : subject_.lists.points) rows.push_back({p.x(), p.y(), p.z(), -1, -1});
  std::vector<std::array<std::int64_t, 4>> triangles;
  for (const Triangle& t : subject_.lists.triangles) triangles.push_back({t[0], t[1], t[2], -1});
  smooth_.set_mesh({rows.data(), rows.size(), sizeof rows[0], 3, TALWEG_FLOAT64},
                   {triangles.data(), triangles.size(), sizeof triangles[0], 3, TALWEG_INT64});
  smooth_.set_curves({subject_.curve});
  EXPECT_TRUE(same_bits(smooth_.run().curves.at(0), expected));

  std::vector<float> single;
  MeshLists rounded = subject_.lists;
  for (Point& p : rounded.points) {
    for (double& x : p) {
      single.push_back(static_cast<float>(x));
      x = single.back();
    }
  }
  test::set_mesh(smooth_, rounded);
  smooth_.set_curves({subject_.curve});
  const host::Curve of_rounded = smooth_.run().curves.at(0);
  smooth_.set_mesh({single.data(), rounded.points.size(), 0, 3, TALWEG_FLOAT32},
                   host::view(rounded.triangles.front().data(), rounded.triangles.size(), 3));
  smooth_.set_curves({subject_.curve});
  EXPECT_TRUE(same_bits(smooth_.run().curves.at(0), of_rounded));
}

TEST_F(SmoothPlugin, AnotherInstanceTakesTheMesh) {
  host::Instance second(smooth_.plugin(), services_);
  EXPECT_THROW(second.set_curves({subject_.curve}), host::Error);
  second.share_mesh(smooth_);
  smooth_.set_curves({subject_.curve});
  second.set_curves({subject_.curve});
  EXPECT_TRUE(same_bits(smooth_.run().curves.at(0), second.run().curves.at(0)));
  test::set_mesh(smooth_, test::grid(5, 5));  // the second one keeps its own
  EXPECT_EQ(second.run().number("vertices"), static_cast<double>(subject_.lists.points.size()));
  EXPECT_THROW(smooth_.run(), host::Error);  // the curves went with the mesh
}

TEST_F(SmoothPlugin, RefusesBadUse) {
  const auto sentence = [](const auto& call) {
    try {
      call();
    } catch (const host::Error& error) {
      return std::to_string(error.status()) + " " + error.what();
    }
    return std::string("no error");
  };
  const auto has = [](const std::string& text, const char* part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  has(sentence([&] { smooth_.run(); }), "1 There are no curves");
  has(sentence([&] { smooth_.set("taw", 1.0); }), "1 There is no parameter \"taw\"");
  has(sentence([&] { smooth_.set("tau", -1.0); }), "1 Tau (tau) must be >= 0, not -1");
  has(sentence([&] { smooth_.set("tau", std::nan("")); }), "finite");
  has(sentence([&] { smooth_.set("tau", "much"); }), "1 Tau (tau) is not a choice");
  has(sentence([&] { smooth_.set("potential", "steep"); }), "corridor, paper, not \"steep\"");
  has(sentence([&] { smooth_.set("relax", 1.5); }), "whole number");
  has(sentence([&] { smooth_.set("max_deviation", 0.0); }), "> 0");
  has(sentence([&] { test::set_mesh(smooth_, test::with_fin(test::grid(4, 4), 3)); }),
      "2 1 edge has more than two faces");
  has(sentence([&] {
        host::Curve far;
        far.vertices = {0, 500};
        smooth_.set_curves({far});
      }),
      "3 Vertices 0 and 500");
  smooth_.set_curves({subject_.curve});  // the mesh is still the first one
  smooth_.set("heat_time", 3.0);
  has(sentence([&] { smooth_.run(); }), "1 heat_time needs the potential paper");
  smooth_.set("potential", "paper");
  smooth_.set("distance", std::vector<double>(3, 1.0));
  has(sentence([&] { smooth_.run(); }), "There are 3 distances for");
  smooth_.reset("distance");
  EXPECT_EQ(smooth_.run().text("termination"), "converged");
}

TEST_F(SmoothPlugin, SeveralCurvesHaveSeveralReports) {
  host::Curve first, second;
  first.vertices = {200, 201, 202, 203};
  second.vertices = {600, 601, 602, 603};
  smooth_.set_curves({first, second});
  const host::Results results = smooth_.run();
  EXPECT_EQ(results.curves.size(), 2U);
  EXPECT_EQ(results.number("points_before"), 8);
  EXPECT_EQ(results.number("points_before", 0), 4);
  EXPECT_EQ(results.number("points_before", 1), 4);
}

/// The subject's curve with a part dragged aside.
SurfaceCurve dragged_aside(const Surface& surface) {
  const std::uint32_t way[] = {20 * 41 + 2,  26 * 41 + 8,  24 * 41 + 14, 14 * 41 + 20,
                               16 * 41 + 27, 25 * 41 + 33, 23 * 41 + 38};
  return test::vertex_curve(surface, draw_edge_path(surface, test::ids(way)), false);
}

TEST_F(SmoothPlugin, PreviewsWhileACurveIsDragged) {
  const SurfaceMesh& mesh = subject_.opened->mesh();
  const SurfaceCurve moved = dragged_aside(mesh.surface());
  const host::Curve moved_curve = test::as_host_curve(mesh, moved);
  CurveSmoother smoother(subject_.opened);
  smoother.set_curve(subject_.drawn);
  smooth_.set_curves({subject_.curve});
  smooth_.set("preview", 1.0);
  expect_same(smooth_.run(), smoother.smooth(1));  // there is nothing to preview from yet

  smooth_.set_curves({moved_curve});
  const host::Results preview = smooth_.run();
  EXPECT_EQ(preview.text("engine"), "preview");
  expect_same(preview, smoother.drag(0, moved));
  smooth_.set_curves({subject_.curve});
  expect_same(smooth_.run(), smoother.smooth(1));
  smooth_.set("tau", 2.0);
  smooth_.set_curves({moved_curve});
  SmoothingOptions options;
  options.tau = 2;
  expect_same(smooth_.run(), smoother.drag(0, moved, options));

  smooth_.set("preview", 0.0);
  CurveSmoother full(subject_.opened);
  full.set_curve(moved);
  const host::Results result = smooth_.run();
  EXPECT_EQ(result.text("engine"), "local");
  expect_same(result, full.smooth(2));
}

TEST_F(SmoothPlugin, PreviewsOfMoreThanOneChangeAreWhole) {
  host::Curve first, second, third;
  first.vertices = {200, 201, 202, 203};
  second.vertices = {600, 601, 602, 603};
  third.vertices = {1000, 1001, 1002, 1003};
  smooth_.set_curves({first, second});
  smooth_.run();
  smooth_.set("preview", 1.0);
  smooth_.set_curves({first, third});
  EXPECT_EQ(smooth_.run().text("engine", 1), "preview");
  smooth_.set_curves({second, third});
  EXPECT_EQ(smooth_.run().text("engine", 1), "local");
  smooth_.set_curves({first});
  EXPECT_EQ(smooth_.run().text("engine"), "local");
}

TEST_F(SmoothPlugin, PreviewsUseTheSlackThatTheBoundLedTo) {
  smooth_.set_curves({subject_.curve});
  const double default_slack = smooth_.run().number("slack");
  smooth_.set("max_deviation", 1.0);
  const host::Results found = smooth_.run();
  EXPECT_NE(found.number("slack"), default_slack);
  smooth_.set("preview", 1.0);
  const SurfaceMesh& mesh = subject_.opened->mesh();
  smooth_.set_curves({test::as_host_curve(mesh, dragged_aside(mesh.surface()))});
  const host::Results preview = smooth_.run();
  EXPECT_EQ(preview.text("engine"), "preview");
  EXPECT_EQ(preview.number("tau"), found.number("tau"));
  EXPECT_EQ(preview.number("slack"), found.number("slack"));
}

}  // namespace
}  // namespace talweg
