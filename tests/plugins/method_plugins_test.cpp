// The plugins of other methods against values from mathematics.
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "plugins/plugin_runs.hpp"
#include "talweg/core/measures.hpp"
#include "talweg/core/report.hpp"
#include "talweg/core/version.hpp"

namespace talweg {
namespace {

/// A plugin on a mesh.
struct OnMesh {
  OnMesh(const char* id, const MeshLists& lists)
      : mesh(SurfaceMesh::open(lists)), instance(test::plugin_of_this_build(id), services) {
    test::set_mesh(instance, lists);
  }
  host::Results run(const std::vector<SurfaceCurve>& curves) {
    std::vector<host::Curve> given;
    for (const SurfaceCurve& curve : curves) given.push_back(test::as_host_curve(mesh, curve));
    instance.set_curves(given);
    return instance.run();
  }
  std::string sentence(const std::vector<SurfaceCurve>& curves) {
    try {
      run(curves);
    } catch (const host::Error& error) {
      return error.what();
    }
    return "no error";
  }

  SurfaceMesh mesh;
  host::Services services{"test", "1"};
  host::Instance instance;
};

SurfaceCurve edge_path(const SurfaceMesh& mesh, std::vector<std::uint32_t> way, bool closed) {
  return test::vertex_curve(mesh.surface(), draw_edge_path(mesh.surface(), test::ids(way), closed),
                            closed);
}

constexpr const char* kMethods[] = {"talweg.midpoints"};

TEST(MethodPlugins, GiveAWholeReportAndCurvesInTheirOrder) {
  const test::Subject subject;
  for (const char* id : kMethods) {
    SCOPED_TRACE(id);
    if (std::string(id) == "talweg.bipartition") continue;  // takes no open curves
    OnMesh on(id, subject.lists);
    const host::Results results = on.run({subject.drawn});
    ASSERT_EQ(results.curves.size(), 1U);
    EXPECT_FALSE(results.curves[0].closed);
    const double before = measure_curve(on.mesh.surface(), subject.drawn).total_curvature;
    EXPECT_NEAR(results.number("curvature_before"), before, 1e-12 * before);
    EXPECT_LT(results.number("curvature_after"), 0.5 * before);
    EXPECT_LE(results.number("length_after"), results.number("length_before"));
    EXPECT_EQ(results.text("version"), version());
    for (const ReportEntry& entry : entries_of(SmoothingReport{})) {
      EXPECT_NE(results.find(entry.key.c_str()), nullptr) << entry.key;
    }
    EXPECT_EQ(results.curves[0].positions.front()[0],
              on.mesh.position(subject.drawn.points.front()).x());
    EXPECT_EQ(results.curves[0].positions.back()[0],
              on.mesh.position(subject.drawn.points.back()).x());
  }
}

// Lane and Riesenfeld's scheme of degree 2 is Chaikin's: in the plane its limit consists of
// parabolas between the midpoints of the polygon's sides.
TEST(MidpointsPlugin, OnAPlaneTendsToTheBSpline) {
  OnMesh on("talweg.midpoints", test::grid(20, 20));
  const auto at = [](std::uint32_t x, std::uint32_t y) { return x + 21 * y; };
  const SurfaceCurve square =
      edge_path(on.mesh, {at(4, 4), at(16, 4), at(16, 16), at(4, 16)}, true);
  on.instance.set("spacing", 12.0);
  on.instance.set("degree", 2.0);
  on.instance.set("levels", 7.0);
  const host::Results results = on.run({square});
  EXPECT_EQ(results.number("control_points"), 4);
  // Of a parabola with legs of 6 at a right angle: 12 times the integral of sqrt((1-t)^2 + t^2).
  const double parabola = 12 * (0.5 + std::asinh(1.0) / (2 * std::numbers::sqrt2));
  EXPECT_NEAR(results.number("length_after"), 4 * parabola, 1e-4 * parabola);
  EXPECT_NEAR(results.number("deviation_from_drawn_max"), 6 * std::numbers::sqrt2 / 4, 1e-2);
  EXPECT_NEAR(results.number("curvature_after"), 2 * std::numbers::pi, 1e-6);
}

TEST(MidpointsPlugin, KeepsAStraightLineAndItsEnds) {
  OnMesh on("talweg.midpoints", test::grid(20, 20));
  const SurfaceCurve line = edge_path(on.mesh, {21 * 5 + 2, 21 * 5 + 18}, false);
  const host::Results results = on.run({line});
  EXPECT_NEAR(results.number("length_after"), 16, 1e-12);
  EXPECT_NEAR(results.number("deviation_to_drawn_max"), 0, 1e-12);
}

TEST(MidpointsPlugin, SaysWhatIsWrongWithAParameter) {
  OnMesh on("talweg.midpoints", test::grid(4, 4));
  EXPECT_THROW(on.instance.set("spacing", 0.0), host::Error);
  EXPECT_THROW(on.instance.set("degree", 2.5), host::Error);
  EXPECT_THROW(on.instance.set("levels", 0.0), host::Error);
}

}  // namespace
}  // namespace talweg
