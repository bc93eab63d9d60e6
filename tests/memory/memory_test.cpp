// Memory as a function of faces and points (docs/development/cost.md): counted, not estimated.
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/jagged_curves.hpp"
#include "memory/counted_allocations.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"

namespace talweg::test {
namespace {

constexpr double kMiB = 1 << 20;

struct Bytes {
  double kept = 0;  ///< live bytes after the call minus live bytes before
  double peak = 0;  ///< most live bytes during the call minus live bytes before
};

Bytes of(const std::function<void()>& work) {
  const auto before = static_cast<double>(live_bytes());
  begin_peak();
  work();
  return {static_cast<double>(live_bytes()) - before, static_cast<double>(peak_bytes()) - before};
}

/// A jagged drawing over hills: a meander along edges.
SurfaceCurve zigzag(const SurfaceMesh& mesh, std::uint32_t size, std::uint32_t points,
                    std::uint32_t row) {
  SurfaceCurve curve;
  for (std::uint32_t k = 0; k < points; ++k) {
    const std::uint32_t up = k % 4 == 1 || k % 4 == 2 ? 1 : 0;
    const std::size_t vertex = (row + up) * std::size_t{size + 1} + size / 4 + k / 2;
    curve.points.push_back(SurfacePoint::at_vertex(mesh.surface(), VertexId{vertex}));
  }
  return curve;
}

/// Opens a mesh of 2 size^2 faces, sets a drawing of `points` points and smooths it.
struct Stages {
  Bytes open, set, smooth, again;

  Stages(std::uint32_t size, std::uint32_t points) {
    MeshLists lists = hills(size);
    std::shared_ptr<const OpenedMesh> opened;
    open = of([&] { opened = OpenedMesh::open(lists); });
    const SurfaceCurve drawn = zigzag(opened->mesh(), size, points, size / 2);
    std::unique_ptr<CurveSmoother> smoother;
    set = of([&] {
      smoother = std::make_unique<CurveSmoother>(opened);
      smoother->set_curve(drawn);
    });
    smooth = of([&] { (void)smoother->smooth(1.0); });
    again = of([&] { (void)smoother->smooth(1.5); });
  }
};

// The bounds of docs/development/cost.md, in bytes.
constexpr double kOpenPerFace = 80, kOpeningPerFace = 110;  // kept, and while it is opened
constexpr double kCurvePerFace = 220;                       // of the first curve and its result
constexpr double kPerPoint = 8192;                          // of the drawing
constexpr double kBase = 1 << 20;

class MemoryOf : public testing::TestWithParam<std::pair<std::uint32_t, std::uint32_t>> {};

TEST_P(MemoryOf, EachStageKeepsTheDocumentedBound) {
  const auto [size, points] = GetParam();
  const double faces = 2.0 * size * size;
  const Stages stages(size, points);
  EXPECT_LT(stages.open.kept, kOpenPerFace * faces + kBase);
  EXPECT_LT(stages.open.peak, kOpeningPerFace * faces + kBase);
  EXPECT_LT(stages.set.peak + stages.smooth.peak,
            kCurvePerFace * faces + kPerPoint * points + kBase);
  // A change of tau takes no memory that grows with the mesh.
  EXPECT_LT(stages.again.kept, kPerPoint * points);
  EXPECT_LT(stages.again.peak, kPerPoint * points + kBase);
}

INSTANTIATE_TEST_SUITE_P(Sizes, MemoryOf,
                         testing::Values(std::pair(60U, 20U), std::pair(120U, 20U),
                                         std::pair(240U, 20U), std::pair(240U, 110U),
                                         std::pair(480U, 20U), std::pair(480U, 220U),
                                         std::pair(708U, 20U), std::pair(708U, 350U)));

TEST(Memory, AMillionFacesAndTwentyLongCurvesTakeLessThan1200MiB) {
  const std::uint32_t size = 708;
  begin_peak();
  const double before = static_cast<double>(live_bytes());
  const auto opened = OpenedMesh::open(hills(size));
  std::vector<SurfaceCurve> curves;
  for (std::uint32_t k = 0; k < 20; ++k) {
    curves.push_back(zigzag(opened->mesh(), size, 700, 20 + 33 * k));
  }
  CurveSmoother smoother(opened);
  smoother.set_curves(curves);
  SmoothingOptions options;
  options.tau = 3;
  const SmoothingResult result = smoother.smooth(options);
  EXPECT_EQ(result.curves.size(), curves.size());
  EXPECT_LT(static_cast<double>(peak_bytes()) - before, 1200 * kMiB);
}

}  // namespace
}  // namespace talweg::test
