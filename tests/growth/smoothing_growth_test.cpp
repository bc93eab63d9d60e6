#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include "core/small_meshes.hpp"
#include "growth/counted_work.hpp"
#include "growth/stroke.hpp"
#include "talweg/core/drawing/crossings.hpp"
#include "talweg/core/drawing/curve_embedding.hpp"
#include "talweg/core/labels/label_borders.hpp"
#include "talweg/core/labels/label_network.hpp"
#include "talweg/core/measure/self_contacts.hpp"
#include "talweg/core/smoothing/curve_gaps.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"

namespace talweg::test {
namespace {

/// A disc of `count` faces around vertex 0.
MeshLists disc(std::uint32_t count) {
  MeshLists lists;
  lists.points.emplace_back(0, 0, 0);
  for (std::uint32_t i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    lists.points.emplace_back(std::cos(angle), std::sin(angle), 0.1 * (i % 3));
    lists.triangles.push_back({0, 1 + i, 1 + (i + 1) % count});
  }
  return lists;
}

/// A curve that passes vertex 0 of a disc of 64 spokes n times.
SurfaceCurve through_the_middle(const Surface& surface, std::size_t n) {
  SurfaceCurve curve;
  for (std::size_t i = 0; i < n; ++i) {
    const auto spoke = static_cast<std::uint32_t>(i * 27 % 64);
    for (const std::uint32_t v : {1 + spoke, 0U, 1 + (spoke + 32) % 64}) {
      curve.points.push_back(SurfacePoint::at_vertex(surface, VertexId{v}));
    }
    // Along the rim to the beginning of the next passage.
    const auto next = static_cast<std::uint32_t>((i + 1) * 27 % 64);
    for (std::uint32_t at = (spoke + 32) % 64; at != next && i + 1 < n;) {
      at = (at + 1) % 64;
      if (at != next) curve.points.push_back(SurfacePoint::at_vertex(surface, VertexId{1 + at}));
    }
  }
  return curve;
}

TEST(Growth, PassagesOfOneVertex) {
  const SurfaceMesh mesh = SurfaceMesh::open(disc(64));
  expect_growth(
      "path_contacts, passages of one vertex", 2.1, {25, 50, 100, 200}, [&](std::size_t n) {
        const SurfaceCurve curve = through_the_middle(mesh.surface(), n);
        auto triangulation = std::make_shared<SignpostTriangulation>(mesh.surface());
        const EmbeddedCurves embedded = embed_curves(*triangulation, std::span(&curve, 1));
        return
            [triangulation, paths = embedded.paths] { (void)path_contacts(*triangulation, paths); };
      });
  expect_growth("self_contacts, passages of one vertex", 1.4, {25, 50, 100, 200},
                [&](std::size_t n) {
                  return [&mesh, curve = through_the_middle(mesh.surface(), n)] {
                    (void)self_contacts(mesh.surface(), std::span(&curve, 1));
                  };
                });
}

TEST(Growth, CrossingsInOneFace) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(4, 4));
  expect_growth("crossing_curves, segments in a face", 1.5, {250, 1000, 4000}, [&](std::size_t n) {
    return [&mesh, curve = stroke_in(mesh.surface(), FaceId{12}, n)] {
      (void)crossing_curves(mesh.surface(), std::span(&curve, 1));
    };
  });
  expect_growth("self_contacts, segments in a face", 1.5, {250, 1000, 4000}, [&](std::size_t n) {
    return [&mesh, curve = stroke_in(mesh.surface(), FaceId{12}, n)] {
      (void)self_contacts(mesh.surface(), std::span(&curve, 1));
    };
  });
}

TEST(Growth, SmoothingPointsInOneFace) {
  const auto mesh = OpenedMesh::open(grid(4, 4));
  for (const Method method : {Method::kCorridor, Method::kPaper}) {
    const bool corridor = method == Method::kCorridor;
    expect_growth(
        corridor ? "smooth, points in a face, corridor" : "smooth, points in a face, paper",
        corridor ? 1.6 : 2.0, {100, 300, 900}, [&](std::size_t n) {
          return [&mesh, method, curve = stroke_in(mesh->surface(), FaceId{12}, n)] {
            (void)smooth_curve(mesh, curve, {}, {.method = method});
          };
        });
  }
}

/// n points alternating between two sides of a face: a narrow zigzag that does not cross itself.
SurfaceCurve zigzag_in(const Surface& surface, FaceId face, std::size_t n) {
  SurfaceCurve curve;
  for (std::size_t i = 0; i < n; ++i) {
    const double b = 0.1 + 0.4 * (static_cast<double>(i) + 0.5) / static_cast<double>(n);
    const double c = i % 2 == 0 ? 0.1 : 0.4;
    curve.points.push_back(SurfacePoint::in_face(surface, face, {1 - b - c, b, c}));
  }
  return curve;
}

/// Without Delaunay pieces each segment of the zigzag would cross the needles of all previous
/// points, with n^4 flips.
TEST(Growth, SmoothingAZigzagInOneFace) {
  const auto mesh = OpenedMesh::open(grid(4, 4));
  expect_growth("smooth, zigzag in a face, paper", 2.5, {100, 300, 900}, [&](std::size_t n) {
    return [&mesh, curve = zigzag_in(mesh->surface(), FaceId{12}, n)] {
      (void)smooth_curve(mesh, curve, {}, {.method = Method::kPaper});
    };
  });
}

TEST(Growth, ManyWayPoints) {
  expect_growth("smooth, way-points", 1.3, {500, 2000, 8000}, [](std::size_t n) {
    const auto mesh = OpenedMesh::open(grid(static_cast<std::uint32_t>(n), 2));
    SurfaceCurve curve;
    CurveOptions options;
    for (std::size_t i = 0; i < n; ++i) {
      curve.points.push_back(SurfacePoint::at_vertex(mesh->surface(), VertexId{n + 1 + i}));
      options.way_points.push_back({curve.points.back()});
    }
    return [mesh, curve, options] {
      CurveSmoother smoother(mesh);
      smoother.set_curve(curve, options);
      (void)smoother.smooth(1.0);
    };
  });
}

/// n curves along the rows of a sheet.
std::vector<SurfaceCurve> rows(const Surface& surface, std::uint32_t columns, std::size_t n) {
  std::vector<SurfaceCurve> curves;
  for (std::size_t r = 0; r < n; ++r) {
    SurfaceCurve& curve = curves.emplace_back();
    for (std::uint32_t i = 0; i <= columns; ++i) {
      const auto row = static_cast<std::uint32_t>(2 * r + 1 + i % 2);
      curve.points.push_back(SurfacePoint::at_vertex(surface, VertexId{row * (columns + 1) + i}));
      if (i < columns && i % 2 == 1) {  // back to the lower row, along an edge
        curve.points.push_back(
            SurfacePoint::at_vertex(surface, VertexId{(row - 1) * (columns + 1) + i}));
      }
    }
  }
  return curves;
}

TEST(Growth, CurvesInASet) {
  constexpr std::uint32_t kColumns = 12;
  expect_growth("smooth, curves in a set", 1.3, {8, 32, 128}, [&](std::size_t n) {
    const auto mesh = OpenedMesh::open(grid(kColumns, static_cast<std::uint32_t>(2 * n + 2)));
    return [mesh, curves = rows(mesh->surface(), kColumns, n)] {
      CurveSmoother smoother(mesh);
      smoother.set_curves(curves);
      (void)smoother.smooth(1.0);
    };
  });
  expect_growth("CurvesByFace, curves in a set", 1.2, {8, 32, 128}, [&](std::size_t n) {
    const auto mesh = OpenedMesh::open(grid(kColumns, static_cast<std::uint32_t>(2 * n + 2)));
    return [mesh, curves = rows(mesh->surface(), kColumns, n)] {
      CurvesByFace by_face(mesh->surface(), curves);
      for (std::size_t c = 0; c < curves.size(); ++c) {
        (void)by_face.crossed_points(c, curves[c]);
        by_face.replace(c, curves[c]);
      }
    };
  });
  expect_growth("gaps_to_others, curves in a set", 1.3, {8, 32, 128}, [&](std::size_t n) {
    const auto mesh = OpenedMesh::open(grid(kColumns, static_cast<std::uint32_t>(2 * n + 2)));
    return [mesh, curves = rows(mesh->surface(), kColumns, n)] {
      (void)gaps_to_others(mesh->mesh(), curves, 1.0);
    };
  });
}

TEST(Growth, LabelsAtOneVertex) {
  expect_growth("label_borders, labels at one vertex", 1.3, {30, 300, 3000}, [](std::size_t n) {
    const SurfaceMesh mesh = SurfaceMesh::open(disc(static_cast<std::uint32_t>(2 * n)));
    std::vector<std::int64_t> labels(2 * n);
    for (std::size_t f = 0; f < labels.size(); ++f) labels[f] = static_cast<std::int64_t>(f / 2);
    return [mesh, labels] { (void)label_borders(mesh.surface(), labels); };
  });
}

/// n specks of one vertex and its faces each, in the middle of a column of squares of 8.
TEST(Growth, SpecksOfLabels) {
  constexpr std::uint32_t kColumns = 8;
  expect_growth("smooth_labels, specks", 1.3, {8, 32, 128}, [](std::size_t n) {
    const auto rows = static_cast<std::uint32_t>(kColumns * n);
    const auto mesh = OpenedMesh::open(grid(kColumns, rows));
    std::vector<std::int64_t> labels(mesh->surface().face_count());
    for (std::uint32_t k = 0; k < n; ++k) {
      const VertexId middle{(kColumns * k + 4) * (kColumns + 1) + 4};
      for (const FaceId face :
           faces_at(mesh->surface(), SurfacePoint::at_vertex(mesh->surface(), middle))) {
        labels[face.index()] = 1;
      }
    }
    return [mesh, labels] { (void)smooth_labels(mesh, labels); };
  });
}

}  // namespace
}  // namespace talweg::test
