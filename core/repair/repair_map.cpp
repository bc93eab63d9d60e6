#include "talweg/core/repair/repair_map.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <variant>

#include "talweg/core/drawing/corner_coordinates.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

[[noreturn]] void bad_position(std::size_t k, const std::string& what) {
  throw Error(ErrorCode::kBadCurve, "At position " + std::to_string(k) + " of the curve: " + what);
}

using Choices = std::vector<std::span<const std::uint32_t>>;

/// Picks one vertex of each choice by dynamic programming. The path has as few steps as possible
/// between components, and among such paths as few steps as possible between vertices that are not
/// neighbours. The first of equally good paths is picked.
class Picker {
 public:
  Picker(const Surface& surface, const Choices& choices)
      : surface_(surface), parts_(components_of(surface).of_vertex), choices_(choices) {}

  std::vector<VertexId> pick(bool closed) {
    std::vector<VertexId> best;
    std::size_t least = std::numeric_limits<std::size_t>::max();
    for (const std::uint32_t start : choices_.front()) {
      auto [cost, path] = from(start, closed);
      if (cost >= least) continue;
      least = cost;
      best = std::move(path);
    }
    return best;
  }

 private:
  [[nodiscard]] std::size_t step(std::uint32_t a, std::uint32_t b) const {
    const VertexId from{a};
    const VertexId to{b};
    if (parts_[a] != parts_[b]) return choices_.size() + 1;
    const bool neighbours =
        surface_.find_halfedge(from, to).valid() || surface_.find_halfedge(to, from).valid();
    return neighbours ? 0 : 1;
  }

  [[nodiscard]] std::pair<std::size_t, std::vector<VertexId>> from(std::uint32_t start,
                                                                   bool closed) const {
    std::vector<std::size_t> cost{0};
    std::vector<std::uint32_t> here{start};
    std::vector<std::vector<std::size_t>> came(choices_.size());
    for (std::size_t k = 1; k < choices_.size(); ++k) {
      std::vector<std::size_t> next;
      for (const std::uint32_t v : choices_[k]) {
        std::size_t least = std::numeric_limits<std::size_t>::max();
        came[k].push_back(0);
        for (std::size_t i = 0; i < here.size(); ++i) {
          const std::size_t total = cost[i] + step(here[i], v);
          if (total >= least) continue;
          least = total;
          came[k].back() = i;
        }
        next.push_back(least);
      }
      cost = std::move(next);
      here.assign(choices_[k].begin(), choices_[k].end());
    }
    for (std::size_t i = 0; closed && i < here.size(); ++i) cost[i] += step(here[i], start);
    auto at = static_cast<std::size_t>(std::min_element(cost.begin(), cost.end()) - cost.begin());
    const std::size_t total = cost[at];
    std::vector<VertexId> path(choices_.size());
    for (std::size_t k = choices_.size() - 1; k > 0; --k) {
      path[k] = VertexId{choices_[k][at]};
      at = came[k][at];
    }
    path[0] = VertexId{start};
    return {total, std::move(path)};
  }

  const Surface& surface_;
  std::vector<std::uint32_t> parts_;
  const Choices& choices_;
};

}  // namespace

RepairMap::RepairMap(std::vector<std::uint32_t> vertex_to_file,
                     std::vector<std::uint32_t> face_to_file, std::vector<FaceImage> images,
                     const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs)
    : to_file_(std::move(vertex_to_file)),
      face_to_file_(std::move(face_to_file)),
      images_(std::move(images)) {
  for (const auto& [vertex, image] : pairs) {
    while (first_.size() <= vertex) first_.push_back(static_cast<std::uint32_t>(became_.size()));
    became_.push_back(image);
  }
  first_.push_back(static_cast<std::uint32_t>(became_.size()));
}

std::span<const std::uint32_t> RepairMap::images(VertexId file_vertex) const {
  const std::uint32_t first = first_[file_vertex.index()];
  return std::span(became_).subspan(first, first_[file_vertex.index() + 1] - first);
}

CurveInput RepairMap::to_repaired(const CurveInput& curve, const Surface& repaired) const {
  CurveInput result = curve;
  if (const auto* ids = std::get_if<std::vector<VertexId>>(&curve.points)) {
    result.points = moved(*ids, curve.closed, repaired);
  } else if (const auto* at = std::get_if<std::vector<FaceCoordinates>>(&curve.points)) {
    result.points = moved(*at);
  } else if (const auto* between = std::get_if<std::vector<CornerCoordinates>>(&curve.points)) {
    result.points = moved(*between, repaired);
  }
  return result;
}

std::vector<CornerCoordinates> RepairMap::moved(std::vector<CornerCoordinates> points,
                                                const Surface& repaired) const {
  for (std::size_t k = 0; k < points.size(); ++k) {
    std::array<std::span<const std::uint32_t>, 3> choices;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t v = points[k].corners[c].index();
      if (v >= file_vertex_count()) {
        bad_position(k, "there is no vertex " + std::to_string(v) + "; the mesh has " +
                            std::to_string(file_vertex_count()) + ", counted from 0.");
      }
      choices[c] = images(points[k].corners[c]);
    }
    CornerCoordinates found = points[k];
    const auto pick = [&] {
      for (const std::uint32_t a : choices[0]) {
        for (const std::uint32_t b : choices[1]) {
          for (const std::uint32_t c : choices[2]) {
            found.corners = {VertexId{a}, VertexId{b}, VertexId{c}};
            if (any_face(repaired, found).valid()) return;
          }
        }
      }
    };
    pick();
    points[k] = found;
  }
  return points;
}

std::vector<FaceCoordinates> RepairMap::moved(std::vector<FaceCoordinates> points) const {
  for (std::size_t k = 0; k < points.size(); ++k) {
    const std::size_t f = points[k].face.index();
    if (f >= file_face_count()) {
      bad_position(k, "there is no face " + std::to_string(f) + "; the mesh has " +
                          std::to_string(file_face_count()) + ", counted from 0.");
    }
    const FaceImage& image = images_[f];
    if (image.face == kDropped) {
      bad_position(k, "face " + std::to_string(f) + " was dropped by the repair.");
    }
    const std::array<double, 3> here = points[k].barycentric;
    points[k].face = FaceId{image.face};
    for (std::size_t c = 0; c < 3; ++c) points[k].barycentric[image.corner[c]] = here[c];
  }
  return points;
}

std::vector<VertexId> RepairMap::moved(const std::vector<VertexId>& ids, bool closed,
                                       const Surface& repaired) const {
  Choices choices;
  bool several = false;
  for (std::size_t k = 0; k < ids.size(); ++k) {
    if (ids[k].index() >= file_vertex_count()) {
      bad_position(k, "there is no vertex " + std::to_string(ids[k].index()) + "; the mesh has " +
                          std::to_string(file_vertex_count()) + ", counted from 0.");
    }
    choices.push_back(images(ids[k]));
    several = several || choices.back().size() > 1;
  }
  if (several) return Picker(repaired, choices).pick(closed);
  std::vector<VertexId> result;
  for (const auto& choice : choices) result.push_back(VertexId{choice.front()});
  return result;
}

std::vector<SurfacePoint> RepairMap::on_one_sheet(std::vector<SurfacePoint> points, bool closed,
                                                  const Surface& repaired) const {
  std::vector<std::uint32_t> anchors(
      points.size());  // per point inside an edge or a face, a vertex of it
  Choices choices;
  bool several = false;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto& where = points[k].where();
    if (const auto* v = std::get_if<AtVertex>(&where)) {
      choices.push_back(images(file_vertex(v->vertex)));
      several = several || choices.back().size() > 1;
      continue;
    }
    const auto* e = std::get_if<OnEdge>(&where);
    const VertexId near = e != nullptr ? repaired.tail(halfedge_of(e->edge))
                                       : repaired.corners(std::get<InFace>(where).face)[0];
    anchors[k] = static_cast<std::uint32_t>(near.index());
    choices.push_back(std::span(anchors).subspan(k, 1));
  }
  if (!several) return points;
  const std::vector<VertexId> picked = Picker(repaired, choices).pick(closed);
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (points[k].is_vertex()) points[k] = SurfacePoint::at_vertex(repaired, picked[k]);
  }
  return points;
}

PlacedCurve RepairMap::to_file(PlacedCurve curve) const {
  for (std::size_t k = 0; k < curve.corners.size(); ++k) {
    const auto there = curve.corners[k];
    const FaceImage& image = images_[file_face(curve.faces[k].face).index()];
    for (std::size_t c = 0; c < 3; ++c) curve.corners[k][c] = file_vertex(there[image.corner[c]]);
  }
  curve.vertex_count = curve.vertex_count == 0 ? 0 : file_vertex_count();
  for (VertexId& v : curve.vertices) {
    if (v.valid()) v = file_vertex(v);
  }
  for (FaceCoordinates& at : curve.faces) {
    const std::array<double, 3> there = at.barycentric;
    at.face = file_face(at.face);
    const FaceImage& image = images_[at.face.index()];
    for (std::size_t c = 0; c < 3; ++c) at.barycentric[c] = there[image.corner[c]];
  }
  return curve;
}

}  // namespace talweg
