// Options out of range give one sentence with the name of the field, and change nothing.
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A bad value of one field; validate() must refuse it with a sentence that contains the field's
/// name.
template <class Options>
struct Fault {
  const char* field;
  std::function<void(Options&)> plant;
};

template <class Options>
void expect_refused(const std::vector<Fault<Options>>& faults) {
  EXPECT_NO_THROW(Options{}.validate());
  for (const Fault<Options>& fault : faults) {
    Options options;
    fault.plant(options);
    try {
      options.validate();
      ADD_FAILURE() << fault.field;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadUsage);
      const std::string what = error.what();
      EXPECT_NE(what.find(fault.field), std::string::npos) << what;
      EXPECT_EQ(what.back(), '.');
    }
  }
}

TEST(Options, OfACurve) {
  expect_refused<CurveOptions>({
      {"threads", [](auto& o) { o.threads = 0; }},
      {"heat_time", [](auto& o) { o.heat_time = 0; }},
      {"heat_time", [](auto& o) { o.heat_time = 1e7; }},
      {"heat_time", [](auto& o) { o.heat_time = kNaN; }},
      {"bump_radius", [](auto& o) { o.bump_radius = 0; }},
      {"bump_radius", [](auto& o) { o.bump_radius = kInf; }},
  });
}

TEST(Options, OfSmoothing) {
  expect_refused<SmoothingOptions>({
      {"tau", [](auto& o) { o.tau = -1e-300; }},
      {"tau", [](auto& o) { o.tau = kInf; }},
      {"tau", [](auto& o) { o.tau = kNaN; }},
      {"slack", [](auto& o) { o.slack = -1; }},
      {"slack", [](auto& o) { o.slack = kNaN; }},
      {"phase_turns", [](auto& o) { o.phase_turns = -1; }},
      {"phase_turns", [](auto& o) { o.phase_turns = 65; }},
      {"rounds", [](auto& o) { o.relax_rounds = -1; }},
      {"min_relative_length", [](auto& o) { o.min_relative_length = 1; }},
      {"min_relative_length", [](auto& o) { o.min_relative_length = kNaN; }},
      {"length_floor", [](auto& o) { o.length_floor = -1; }},
      {"length_floor", [](auto& o) { o.length_floor = kInf; }},
  });
}

TEST(Options, ARefusedTauLeavesTheCurveSet) {
  const auto opened = OpenedMesh::open(test::grid(10, 10));
  CurveSmoother smoother(opened);
  smoother.set_curve(
      test::vertex_curve(opened->surface(), test::ids({24, 25, 37, 38, 50, 51}), false));
  const double before = smoother.smooth(1.0).report().after.length;
  for (const double tau : {-1.0, kInf, kNaN}) EXPECT_THROW(smoother.smooth(tau), Error);
  EXPECT_EQ(smoother.smooth(1.0).report().after.length, before);
}

TEST(Options, DistancesAndPotentialsThatAreNoNumbersNameTheVertex) {
  const auto opened = OpenedMesh::open(test::grid(10, 10));
  const SurfaceCurve drawn =
      test::vertex_curve(opened->surface(), test::ids({24, 25, 37, 38, 50, 51}), false);
  CurveSmoother smoother(opened);
  const std::size_t n = opened->surface().vertex_count();
  for (const double bad : {kNaN, -kInf}) {
    std::vector<double> distance(n, 1);
    distance[17] = bad;
    try {
      smoother.set_curves(std::span(&drawn, 1), distance);
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("vertex 17 "), std::string::npos) << error.what();
    }
  }
  smoother.set_curve(drawn);
  for (const double bad : {kNaN, kInf, 1e200}) {
    std::vector<double> potential(2 * n, 0);
    potential[2 * 17 + 1] = bad;
    try {
      smoother.smooth({}, potential, 2);
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("vertex 17 "), std::string::npos) << error.what();
    }
  }
  EXPECT_THROW(smoother.smooth({}, std::vector<double>(n), 0), Error);
}

}  // namespace
}  // namespace talweg
