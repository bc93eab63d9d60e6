// Drawings on small meshes of any shape, smoothed by either method.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "fuzz_bytes.hpp"
#include "fuzz_target.hpp"
#include "small_mesh.hpp"
#include "talweg/core/drawing/snapping.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/repair/mesh_repair.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::fuzz {
namespace {

std::shared_ptr<const OpenedMesh> opened(Bytes& bytes) {
  const std::uint8_t damage = bytes.take<std::uint8_t>() % 2 * 128;
  const MeshLists lists = small_mesh(bytes, damage);
  try {
    return OpenedMesh::open(damage > 0 ? repair(lists).lists : lists);
  } catch (const Error& error) {
    require(error.code() == ErrorCode::kBadMesh, "a mesh's error");
    return nullptr;
  }
}

CurveInput drawing(Bytes& bytes, const SurfaceMesh& mesh) {
  CurveInput curve;
  const std::uint8_t kind = bytes.take<std::uint8_t>();
  curve.closed = kind % 2 == 1;
  const std::size_t faces = mesh.surface().face_count();
  const std::uint32_t n = 2 + bytes.take<std::uint8_t>() % 12;
  if (kind % 4 < 2) {
    std::vector<FaceCoordinates> points;
    for (std::uint32_t k = 0; k < n; ++k) {
      const FaceId face{bytes.take<std::uint8_t>() % faces};
      const int a = bytes.take<std::uint8_t>() % 9, b = bytes.take<std::uint8_t>() % (9 - a);
      points.push_back({face, {a / 8.0, b / 8.0, (8 - a - b) / 8.0}});
    }
    curve.points = points;
  } else {
    std::vector<Point> points;
    for (std::uint32_t k = 0; k < n; ++k) {
      const Point& p = mesh.points()[bytes.take<std::uint8_t>() % mesh.points().size()];
      points.emplace_back(p * (1 + bytes.take<std::int8_t>() / 512.0));
    }
    curve.points = points;
  }
  return curve;
}

/// Marks some points of the drawing as clicks, with or without a tolerance, or as painted; none
/// after the end of the bytes.
void mark(Bytes& bytes, const SurfaceMesh& mesh, const SnappedCurve& snapped, CurveOptions& how) {
  for (const SurfacePoint& point : snapped.points) {
    const std::uint8_t kind = bytes.take<std::uint8_t>() % 8;
    if (kind == 1) how.painted.push_back(point);
    if (kind > 1 && kind < 6) {
      how.way_points.push_back({point, kind == 2 ? mesh.mean_edge_length() / 4 : 0});
    }
  }
}

void check(const OpenedMesh& mesh, const SmoothingResult& result, std::size_t curves, double tau) {
  require(result.curves.size() == curves && result.reports.size() == curves, "one per drawing");
  for (const SurfaceCurve& curve : result.curves) {
    const std::size_t n = curve.points.size();
    require(n > 0, "points");
    for (std::size_t k = 0; k + (curve.closed ? 0 : 1) < n; ++k) {
      const SurfacePoint &p = curve.points[k], &q = curve.points[(k + 1) % n];
      require(common_face(mesh.surface(), p, q).valid(), "each point and the next in one face");
      require(mesh.mesh().position(p).allFinite(), "finite positions");
    }
  }
  const SmoothingReport& total = result.total;
  require(std::isfinite(total.after.length) && std::isfinite(total.after.total_curvature),
          "numbers");
  require(total.tau == tau, "the tau that was asked for");
  require(total.lifted_length_after <= total.lifted_length_before * (1 + 1e-9), "never longer");
}

}  // namespace

void smooth(const Target& /*target*/, const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  const std::shared_ptr<const OpenedMesh> mesh = opened(bytes);
  if (mesh == nullptr) return;
  CurveOptions how;
  SmoothingOptions options;
  const std::uint8_t kind = bytes.take<std::uint8_t>();
  how.method = kind % 4 == 0 ? Method::kPaper : Method::kCorridor;
  how.threads = 1;
  options.finish = kind % 8 != 7 ? Finish::kFair : Finish::kTaut;
  options.tau = kind % 16 == 5 ? 0 : std::ldexp(1.0 + kind / 128.0, bytes.take<std::int8_t>() / 8);
  if (kind % 32 == 9) {
    options.slack = mesh->mesh().mean_edge_length() * bytes.take<std::uint8_t>() / 32;
  }
  try {
    std::vector<CurveInput> inputs;
    for (std::uint32_t n = 1 + (kind >= 224 ? 1U : 0U); n > 0; --n) {
      inputs.push_back(drawing(bytes, mesh->mesh()));
    }
    StraightLines lines(mesh->surface());
    std::vector<SurfaceCurve> curves;
    const std::vector<SnappedCurve> all = snap(mesh->mesh(), inputs);
    curves.reserve(all.size());
    for (const SnappedCurve& snapped : all) {
      curves.push_back(lines.join(snapped.points, snapped.closed));
    }
    if (how.method == Method::kCorridor && bytes.take<std::uint8_t>() % 2 == 1) {
      for (const SnappedCurve& snapped : all) mark(bytes, mesh->mesh(), snapped, how);
    }
    CurveSmoother smoother(mesh);
    smoother.set_curves(curves, how);
    check(*mesh, smoother.smooth(options), curves.size(), options.tau);
  } catch (const Error& error) {
    require(error.code() == ErrorCode::kBadCurve || error.code() == ErrorCode::kNumerical,
            error.what());
  }
}

}  // namespace talweg::fuzz
