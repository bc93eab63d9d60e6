// Pins in curve files.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/curve_files.hpp"

namespace talweg {
namespace {

using CurvePins = test::CurveFiles;
using Pins = std::vector<std::size_t>;

std::vector<PlacedCurve> curves_without_pins(const SurfaceMesh& mesh) {
  return {place(mesh, test::ring(mesh)), place(mesh, test::walk(mesh))};
}

TEST_F(CurvePins, ComeBackFromFilesThatHoldThem) {
  const SurfaceMesh mesh = test::odd_sphere();
  std::vector<PlacedCurve> curves = curves_without_pins(mesh);
  curves[1].pins = {0, 2};
  for (const char* name : {"a.json", "a.mrk.json"}) {
    write_curves(path(name), curves);
    const std::vector<CurveInput> back = read_curves(path(name));
    EXPECT_EQ(back.at(0).pins, Pins()) << name;
    EXPECT_EQ(back.at(1).pins, (Pins{0, 2})) << name;
  }
}

TEST_F(CurvePins, AreLeftOutInOtherFormatsAndInFilesWithoutPins) {
  const SurfaceMesh mesh = test::odd_sphere();
  const std::vector<PlacedCurve> plain = curves_without_pins(mesh);
  std::vector<PlacedCurve> pinned = plain;
  pinned[1].pins = {1};
  for (const char* name : {"a.obj", "a.ply", "a.vtp", "a.vtk"}) {
    EXPECT_EQ(curve_bytes(name, pinned), curve_bytes(name, plain)) << name;
  }
  EXPECT_EQ(curve_bytes("a.json", plain).find("pinned"), std::string::npos);
}

std::string json_pinned(const std::string& pinned) {
  return R"({"format": "talweg-curves", "version": 1, "curves": [{"closed": false, "points": [
    {"face": 0, "barycentric": [1, 0, 0]}, {"face": 0, "barycentric": [0, 1, 0], "pinned": )" +
         pinned + "}]}]}";
}

TEST_F(CurvePins, MustBeTrueOrFalse) {
  EXPECT_EQ(read("a.json", json_pinned("true")).at(0).pins, Pins{1});
  EXPECT_EQ(read("a.json", json_pinned("false")).at(0).pins, Pins());
  for (const char* bad : {"1", "null", "\"yes\"", "[true]"}) {
    expect_refused("a.json", json_pinned(bad), {"curves[0].points[1].pinned"});
  }
}

}  // namespace
}  // namespace talweg
