// Way-points through the plugin interface: the field `exact`, in and out.
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/temporary_folder.hpp"
#include "plugins/plugin_runs.hpp"
#include "talweg/core/drawing/edge_dijkstra.hpp"
#include "talweg/plugin/talweg_curve_files.h"
#include "talweg/plugin/talweg_way_points.h"

namespace talweg {
namespace {

using test::same_bits;

class WayPointsPlugin : public test::TemporaryFolder {
 protected:
  void SetUp() override {
    TemporaryFolder::SetUp();
    test::set_mesh(smooth_, subject_.lists);
    test::set_mesh(draw_, subject_.lists);
    clicks_.vertices = {200, 760, 1500};
    draw_.set("way", "edges");
    draw_.set_curves({clicks_});
    drawn_ = draw_.run().curves.at(0);
  }
  [[nodiscard]] SurfacePoint at(std::uint32_t v) const {
    return SurfacePoint::at_vertex(subject_.opened->surface(), VertexId{v});
  }
  /// What the library makes of the drawing.
  [[nodiscard]] PlacedCurve by_library(const CurveOptions& options, double tau = 1) const {
    const Surface& surface = subject_.opened->surface();
    const SurfaceCurve path =
        test::vertex_curve(surface, draw_edge_path(surface, test::ids(clicks_.vertices)), false);
    return place(subject_.opened->mesh(),
                 smooth_curve(subject_.opened, path, {.tau = tau}, options).curve());
  }
  [[nodiscard]] CurveOptions through_clicks(double tolerance = 0) const {
    CurveOptions options;
    for (const std::uint32_t v : clicks_.vertices) {
      options.way_points.push_back({at(v), tolerance});
    }
    return options;
  }
  host::Curve smoothed(const host::Curve& curve) {
    smooth_.set_curves({curve});
    return smooth_.run().curves.at(0);
  }
  /// The drawing, with the same mark wherever it is a way-point.
  [[nodiscard]] host::Curve marked(double mark) const {
    host::Curve curve = drawn_;
    for (double& exact : curve.exact) exact = exact == 0 ? mark : exact;
    return curve;
  }
  std::string sentence(const host::Curve& curve) {
    try {
      smooth_.set_curves({curve});
    } catch (const host::Error& error) {
      return std::to_string(error.status()) + " " + error.what();
    }
    return "no error";
  }

  test::Subject subject_;
  host::Curve clicks_, drawn_;
  host::Services services_{"test", "1"};
  host::Instance smooth_{test::plugin_of_this_build("talweg.smooth"), services_};
  host::Instance draw_{test::plugin_of_this_build("talweg.draw"), services_};
};

TEST_F(WayPointsPlugin, ThoseThatReadThemSaySo) {
  for (const char* id : {"talweg.smooth", "talweg.draw"}) {
    const talweg_plugin& plugin = test::plugin_of_this_build(id);
    ASSERT_NE(plugin.get_extension, nullptr) << id;
    const auto* reads =
        static_cast<const talweg_way_points*>(plugin.get_extension(TALWEG_WAY_POINTS));
    ASSERT_NE(reads, nullptr) << id;
    EXPECT_EQ(reads->size, sizeof *reads);
    EXPECT_EQ(reads->reads_exact, 1U);
    EXPECT_EQ(plugin.get_extension("talweg.way_points/2"), nullptr);
    EXPECT_EQ(plugin.get_extension(nullptr), nullptr);
  }
  const talweg_plugin& geodesic = test::plugin_of_this_build("talweg.geodesic");
  EXPECT_TRUE(geodesic.get_extension == nullptr ||
              geodesic.get_extension(TALWEG_WAY_POINTS) == nullptr);
}

TEST_F(WayPointsPlugin, DrawingMarksThePointsThatWereGiven) {
  ASSERT_EQ(drawn_.exact.size(), drawn_.vertices.size());
  std::vector<std::uint32_t> exact;
  for (std::size_t k = 0; k < drawn_.exact.size(); ++k) {
    if (drawn_.exact[k] == 0) exact.push_back(drawn_.vertices[k]);
    EXPECT_TRUE(drawn_.exact[k] == 0 || drawn_.exact[k] == TALWEG_MARK_NONE);
  }
  EXPECT_EQ(exact, clicks_.vertices);
  draw_.set("points", "rough");
  const host::Curve rough = draw_.run().curves.at(0);
  EXPECT_TRUE(rough.exact.empty());
  EXPECT_TRUE(same_bits(rough, drawn_));
}

TEST_F(WayPointsPlugin, DrawingKeepsTheMarksOfTheGivenPoints) {
  host::Curve given = clicks_;
  given.exact = {0.5, TALWEG_MARK_PAINTED, 0};
  draw_.set_curves({given});
  const host::Curve curve = draw_.run().curves.at(0);
  ASSERT_EQ(curve.exact.size(), curve.vertices.size());
  for (std::size_t k = 0; k < curve.exact.size(); ++k) {
    const std::uint32_t v = curve.vertices[k];
    EXPECT_EQ(curve.exact[k], v == 200    ? 0.5
                              : v == 760  ? TALWEG_MARK_PAINTED
                              : v == 1500 ? 0
                                          : TALWEG_MARK_NONE);
  }
  for (const std::uint32_t v : clicks_.vertices) {
    EXPECT_EQ(std::count(curve.vertices.begin(), curve.vertices.end(), v), 1) << v;
  }
}

TEST_F(WayPointsPlugin, ADrawingGoesFromOnePluginToTheNextAndGivesTheLibrarysBits) {
  for (const double tau : {0.0, 1.0, 4.0}) {
    smooth_.set("tau", tau);
    EXPECT_TRUE(same_bits(smoothed(drawn_), by_library(through_clicks(), tau))) << tau;
  }
}

TEST_F(WayPointsPlugin, CurvesThatSayNothingAreStrokes) {
  host::Curve silent = drawn_;
  silent.exact.clear();
  const PlacedCurve stroke = by_library({});
  EXPECT_TRUE(same_bits(smoothed(silent), stroke));
  EXPECT_TRUE(same_bits(smoothed(marked(TALWEG_MARK_NONE)), stroke));
  smooth_.set("points", "rough");
  EXPECT_TRUE(same_bits(smoothed(drawn_), stroke));
}

TEST_F(WayPointsPlugin, TolerancesArriveFromFieldOrParameter) {
  const PlacedCurve near = by_library(through_clicks(0.5));
  EXPECT_FALSE(same_bits(smoothed(drawn_), near));
  EXPECT_TRUE(same_bits(smoothed(marked(0.5)), near));
  smooth_.set("tolerance", 0.5);
  EXPECT_TRUE(same_bits(smoothed(drawn_), near));
  EXPECT_TRUE(same_bits(smoothed(marked(0.1)), by_library(through_clicks(0.1))));
}

TEST_F(WayPointsPlugin, AChangeOfMarksAloneIsSeen) {
  host::Curve silent = drawn_;
  silent.exact.clear();
  const PlacedCurve through = by_library(through_clicks()), stroke = by_library({});
  EXPECT_TRUE(same_bits(smoothed(silent), stroke));
  EXPECT_TRUE(same_bits(smoothed(drawn_), through));
  EXPECT_TRUE(same_bits(smoothed(silent), stroke));
  for (const char* what : {"rough", "given"}) {
    smooth_.set("points", what);
    smooth_.set_curves({drawn_});
    EXPECT_TRUE(same_bits(smooth_.run().curves.at(0), *what == 'r' ? stroke : through)) << what;
  }
}

TEST_F(WayPointsPlugin, PaintedPointsMakeAStrokeBetweenWayPoints) {
  host::Curve painted = drawn_;
  CurveOptions options = through_clicks();
  painted.exact[3] = TALWEG_MARK_PAINTED;
  options.painted.push_back(at(painted.vertices[3]));
  const host::Curve result = smoothed(painted);
  EXPECT_TRUE(same_bits(result, by_library(options)));
  EXPECT_FALSE(same_bits(result, by_library(through_clicks())));
}

TEST_F(WayPointsPlugin, ControlPointsAreWayPointsIfTheyAreFew) {
  host::Curve few;
  for (const std::uint32_t v : clicks_.vertices) {
    const Point& p = subject_.lists.points[v];
    few.positions.push_back({p.x(), p.y(), p.z()});
  }
  host::Curve exact = few;
  few.exact.assign(3, TALWEG_MARK_CONTROL);
  exact.exact.assign(3, 0);
  EXPECT_TRUE(same_bits(smoothed(few), smoothed(exact)));

  host::Curve dense = drawn_, silent = drawn_;
  dense.exact.assign(dense.exact.size(), TALWEG_MARK_CONTROL);
  silent.exact.clear();
  const host::Curve stroke = smoothed(silent);
  smooth_.set_curves({dense});
  const host::Results results = smooth_.run();
  EXPECT_TRUE(same_bits(results.curves.at(0), stroke));
  ASSERT_EQ(results.find("warnings")->texts.size(), 1U);
  EXPECT_NE(results.find("warnings")->texts[0].find("taken as a stroke"), std::string::npos);
}

TEST_F(WayPointsPlugin, TheParameterSaysOtherwise) {
  host::Curve silent = drawn_;
  silent.exact.clear();
  smooth_.set("exact", clicks_.vertices);
  EXPECT_TRUE(same_bits(smoothed(silent), by_library(through_clicks())));
  smooth_.set("exact", std::vector<std::uint32_t>{7});  // not on the drawing
  EXPECT_THROW(smooth_.run(), host::Error);
  smooth_.reset("exact");
  smooth_.set("points", "exact");
  CurveOptions all;
  for (const std::uint32_t v : silent.vertices) all.way_points.push_back({at(v)});
  EXPECT_TRUE(same_bits(smoothed(silent), by_library(all)));
}

TEST_F(WayPointsPlugin, SaysWhichParametersDoNotApply) {
  const host::Curve plain = smoothed(drawn_);
  smooth_.set("slack", 0.1);
  smooth_.set("max_deviation", 0.2);
  const host::Results bounded = smooth_.run();
  EXPECT_TRUE(same_bits(bounded.curves.at(0), plain));
  ASSERT_EQ(bounded.find("warnings")->texts.size(), 1U);
  EXPECT_NE(
      bounded.find("warnings")->texts[0].find("The slack and the largest deviation do not apply"),
      std::string::npos);
  smooth_.set_curves({subject_.curve});  // a stroke
  const host::Results stroke = smooth_.run();
  EXPECT_TRUE(stroke.find("warnings")->texts.empty());
  EXPECT_LE(stroke.number("deviation_to_drawn_max"), 0.2);
}

TEST_F(WayPointsPlugin, APreviewOfAMovedWayPointIsTheCurveThatFollows) {
  smoothed(drawn_);
  clicks_.vertices[1] = 801;
  draw_.set_curves({clicks_});
  const host::Curve moved = draw_.run().curves.at(0);
  smooth_.set("preview", 1.0);
  const host::Curve preview = smoothed(moved);
  smooth_.set("preview", 0.0);
  EXPECT_TRUE(same_bits(preview, smoothed(moved)));
  EXPECT_TRUE(same_bits(preview, by_library(through_clicks())));
}

TEST_F(WayPointsPlugin, ABadFieldIsRefusedAndChangesNothing) {
  const host::Curve before = smoothed(drawn_);
  host::Curve few = drawn_;
  few.exact.pop_back();
  EXPECT_NE(sentence(few).find("1 The field exact has"), std::string::npos) << sentence(few);
  for (const double bad : {-0.5, -4.0, std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::quiet_NaN()}) {
    const std::string said = sentence(marked(bad));
    EXPECT_NE(said.find("expected a tolerance of 0 or more, -1 (no mark)"), std::string::npos)
        << said;
  }
  EXPECT_TRUE(same_bits(smooth_.run().curves.at(0), before));
}

TEST_F(WayPointsPlugin, FilesKeepThemInBothDirections) {
  const auto* files = static_cast<const talweg_curve_files*>(
      test::plugin_of_this_build("talweg.draw").get_extension(TALWEG_CURVE_FILES));
  const auto take = [](void* context, const talweg_curve* curve) -> talweg_status {
    *static_cast<host::Curve*>(context) = host::detail::copy(*curve);
    return TALWEG_OK;
  };
  host::Curve curve = drawn_;
  curve.exact[2] = TALWEG_MARK_PAINTED;
  curve.exact.back() = 0.25;
  for (const char* name : {"a.json", "a.vtp", "a.vtk"}) {
    const std::string path = file(name).string();
    const std::vector<host::Curve> curves{curve};
    const host::detail::CurveViews one(curves);
    ASSERT_EQ(files->write(path.c_str(), one.data(), one.size(), nullptr, 0), TALWEG_OK) << name;
    host::Curve back;
    const talweg_sink sink = {sizeof sink, 0, &back, take, nullptr, nullptr, nullptr};
    ASSERT_EQ(files->read(path.c_str(), &sink, nullptr, 0), TALWEG_OK) << name;
    EXPECT_EQ(back.exact, curve.exact) << name;
  }
}

}  // namespace
}  // namespace talweg
