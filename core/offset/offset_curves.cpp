#include "talweg/core/offset/offset_curves.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/measure/measures.hpp"
#include "talweg/core/offset/distance_isoline.hpp"
#include "talweg/core/offset/sided_parts.hpp"
#include "talweg/core/offset/way_origin.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"

namespace talweg {
namespace {

class OffsetMaker {
 public:
  OffsetMaker(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
              const OffsetOptions& options, PolylineDistance& distance)
      : mesh_(mesh), curves_(curves), options_(options), distance_(distance) {}

  void add(double distance, OffsetResult& result);

 private:
  [[nodiscard]] double tolerance(double distance) const;
  [[nodiscard]] double off_max(const SurfaceCurve& curve, double distance);
  [[nodiscard]] std::string why_none(double distance, bool other_side);

  const SurfaceMesh& mesh_;
  std::span<const SurfaceCurve> curves_;
  const OffsetOptions& options_;
  PolylineDistance& distance_;
};

double OffsetMaker::tolerance(double distance) const {
  constexpr double kOfDistance = 1e-3, kOfEdge = 0.02, kMost = 0.125;
  const double own = std::min(kOfDistance * distance, kOfEdge * mesh_.mean_edge_length());
  return std::min(options_.tolerance.value_or(own), kMost * distance);
}

double OffsetMaker::off_max(const SurfaceCurve& curve, double distance) {
  const Surface& surface = mesh_.surface();
  double most = 0;
  const auto look_at = [&](const SurfacePoint& point) {
    most = std::max(most, std::abs(distance_.at(point).distance - distance));
  };
  const std::size_t n = curve.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    look_at(curve.points[i]);
    if (i + 1 == n && !curve.closed) break;
    const SurfacePoint& next = curve.points[(i + 1) % n];
    const FaceId face = common_face(surface, curve.points[i], next);
    auto middle = coordinates_in(surface, curve.points[i], face).barycentric;
    const auto to = coordinates_in(surface, next, face).barycentric;
    for (std::size_t k = 0; k < 3; ++k) middle[k] = (middle[k] + to[k]) / 2;
    look_at(SurfacePoint::from_barycentric(surface, face, middle));
  }
  return most;
}

/// The reason why a distance has no offset curve, as one sentence. `other_side`: an isoline exists,
/// but no part of it is wanted.
std::string OffsetMaker::why_none(double distance, bool other_side) {
  if (other_side && options_.side != CurveSide::kBoth) {
    return fmt::format("Nothing at the distance {:.6g} lies on the {} of the curve.", distance,
                       to_string(options_.side));
  }
  if (other_side) {
    return fmt::format("All points at the distance {:.6g} are nearest to an end of the curve.",
                       distance);
  }
  double farthest = 0;
  for (std::size_t v = 0; v < mesh_.surface().vertex_count(); ++v) {
    const double found = distance_.at_vertex(VertexId{v}).distance;
    if (std::isfinite(found)) farthest = std::max(farthest, found);
  }
  return fmt::format(
      "No point of the surface is at the distance {:.6g}: the farthest vertex is {:.6g} away.",
      distance, farthest);
}

void OffsetMaker::add(double distance, OffsetResult& result) {
  const Surface& surface = mesh_.surface();
  const LevelChoice choice{distance, tolerance(distance)};
  const std::vector<LevelCurve> lines = distance_isoline(surface, curves_, distance_, choice);
  const WayOrigins origins(surface, curves_, distance_, distance + 4 * choice.tolerance);
  std::vector<SidedPart> parts;
  for (const LevelCurve& line : lines) {
    std::vector<SidedPart> more = sided_parts(surface, line, origins, options_.side, options_.caps);
    std::move(more.begin(), more.end(), std::back_inserter(parts));
  }
  if (parts.empty()) result.warnings.push_back(why_none(distance, !lines.empty()));
  std::stable_sort(parts.begin(), parts.end(), [](const SidedPart& a, const SidedPart& b) {
    return std::tuple(a.along, a.side, a.arc) < std::tuple(b.along, b.side, b.arc);
  });
  for (SidedPart& part : parts) {
    OffsetCurve& made = result.curves.emplace_back();
    made.distance = distance;
    made.side = part.side;
    made.along = part.along;
    made.length = curve_length(surface, part.curve);
    made.off_max = off_max(part.curve, distance);
    made.curve = std::move(part.curve);
  }
}

}  // namespace

const char* to_string(CurveSide side) {
  switch (side) {
    case CurveSide::kLeft:
      return "left";
    case CurveSide::kRight:
      return "right";
    case CurveSide::kBoth:
      break;
  }
  return "both";
}

void OffsetOptions::validate() const {
  if (distances.empty()) throw Error(ErrorCode::kBadUsage, "An offset needs a distance.");
  for (const double distance : distances) {
    if (!(distance > 0 && std::isfinite(distance))) {
      throw Error(
          ErrorCode::kBadUsage,
          fmt::format("The distance of an offset must be finite and > 0, not {}.", distance));
    }
  }
  if (tolerance && !(*tolerance > 0 && std::isfinite(*tolerance))) {
    throw Error(ErrorCode::kBadUsage, "tolerance must be finite and > 0.");
  }
}

OffsetResult offset_curves(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                           const OffsetOptions& options, const Progress& progress) {
  options.validate();
  if (curves.empty()) throw Error(ErrorCode::kBadCurve, "There is no curve to offset.");
  PolylineDistance distance(mesh.surface());
  ProgressPoller poller(progress, "offset");
  const ScopedPoller scoped(distance, poller);
  distance.set(curves);
  OffsetMaker maker(mesh, curves, options, distance);
  OffsetResult result;
  for (std::size_t i = 0; i < options.distances.size(); ++i) {
    poller.set_fraction(static_cast<double>(i) / static_cast<double>(options.distances.size()));
    maker.add(options.distances[i], result);
  }
  return result;
}

}  // namespace talweg
