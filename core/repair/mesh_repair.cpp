#include "talweg/core/repair/mesh_repair.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/mesh/face_dropping.hpp"
#include "talweg/core/mesh/measurable_point.hpp"
#include "talweg/core/mesh/mesh_sides.hpp"
#include "talweg/core/repair/face_turning.hpp"
#include "talweg/core/repair/sheet_splitting.hpp"
#include "talweg/core/repair/vertex_welding.hpp"
#include "talweg/core/space/face_shape.hpp"
#include "talweg/core/space/point_distance.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

constexpr std::uint32_t kNoVertex = RepairMap::kDropped;

using Image =
    std::pair<std::uint32_t, std::uint32_t>;  ///< a vertex of the file and of the repaired lists

bool mendable(const MeshLists& lists) {
  const std::size_t n = lists.points.size();
  const auto exists = [n](const Triangle& t) { return t[0] < n && t[1] < n && t[2] < n; };
  return n > 0 && !lists.triangles.empty() &&
         std::all_of(lists.triangles.begin(), lists.triangles.end(), exists) &&
         all_measurable(lists) && large_enough(lists);
}

/// A dropped face, the face that it repeats, and per corner the matching corner of that face.
struct Double {
  RepeatPlace place;
  std::array<std::uint8_t, 3> corner;
};

std::array<std::uint8_t, 3> corners_in(const Triangle& t, const Triangle& other) {
  std::array<std::uint8_t, 3> corner{};
  for (std::size_t k = 0; k < 3; ++k) {
    corner[k] =
        static_cast<std::uint8_t>(std::find(other.begin(), other.end(), t[k]) - other.begin());
  }
  return corner;
}

/// The lists during the repair. All faces of the file keep their places until finished().
class Repair {
 public:
  explicit Repair(const MeshLists& file)
      : file_(file),
        lists_(file),
        kept_(file.triangles.size(), true),
        turned_(file.triangles.size(), false) {
    for (std::uint32_t v = 0; v < file.points.size(); ++v) vertex_to_file_.push_back(v);
  }

  RepairedMesh run(const RepairSteps& steps) {
    if (steps.weld) weld(steps.weld_tolerance);
    if (steps.drop) drop();
    if (steps.orient) orient();
    if (steps.split) split();
    return finished();
  }

 private:
  void weld(double tolerance) {
    const Welding welding = weld_vertices(file_, tolerance);
    changes_.weld_tolerance = welding.tolerance;
    changes_.held_apart = welding.held_apart;
    for (std::uint32_t f = 0; f < lists_.triangles.size(); ++f) {
      Triangle& t = lists_.triangles[f];
      const Triangle before = t;
      for (std::uint32_t& v : t) v = welding.onto[v];
      if (t == before || !(tolerance > 0)) continue;
      if (!is_flat(before) && is_flat(t)) changes_.flattened_faces.add(f);
    }
  }
  [[nodiscard]] bool is_flat(const Triangle& t) const {
    return shape_of({file_.points[t[0]], file_.points[t[1]], file_.points[t[2]]}).flat;
  }

  void drop() {
    DroppedFaces dropped = faces_to_drop(lists_);
    kept_ = std::move(dropped.kept);
    for (const std::uint32_t f : dropped.collapsed) changes_.collapsed_faces.add(f);
    for (const std::uint32_t f : dropped.zero_area) changes_.zero_area_faces.add(f);
    for (const RepeatPlace& place : dropped.duplicates) {
      changes_.duplicate_faces.add(place);
      doubles_.push_back(
          {place, corners_in(lists_.triangles[place.element], lists_.triangles[place.earlier])});
    }
  }

  /// Per face, whether it is kept and has three different vertices.
  [[nodiscard]] std::vector<bool> proper() const {
    std::vector<bool> result = kept_;
    for (std::size_t f = 0; f < result.size(); ++f) {
      const Triangle& t = lists_.triangles[f];
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) result[f] = false;
    }
    return result;
  }

  void orient() {
    for (const std::uint32_t f : faces_to_turn(lists_, proper())) {
      changes_.turned_faces.add(f);
      turned_[f] = true;
      std::swap(lists_.triangles[f][1], lists_.triangles[f][2]);
    }
  }

  /// The corner in the file that corresponds to corner k of face f in the lists.
  [[nodiscard]] std::uint32_t file_corner(std::uint32_t f, std::uint32_t k) const {
    return turned_[f] && k > 0 ? 3 - k : k;
  }

  void split() {
    const std::vector<bool> joined = proper();
    const Sheets sheets = split_sheets(lists_, joined);
    for (const std::vector<FaceSide>& edge : sheets.crowded) count_crowded(edge);
    // Each fan gets the smallest of its file vertices that no other fan has taken. Vertices that
    // were welded without need are then separate again. A fan without such a vertex gets a copy.
    std::vector<Image> wishes;  // fan, vertex of the file
    for (std::uint32_t f = 0; f < joined.size(); ++f) {
      for (std::uint32_t k = 0; joined[f] && k < 3; ++k) {
        wishes.emplace_back(sheets.fan_of_corner[3 * f + k], file_.triangles[f][file_corner(f, k)]);
      }
    }
    std::sort(wishes.begin(), wishes.end());
    const std::vector<std::uint32_t> vertex_of_fan = name_fans(wishes);
    for (std::uint32_t f = 0; f < joined.size(); ++f) {
      for (std::uint32_t k = 0; joined[f] && k < 3; ++k) {
        lists_.triangles[f][k] = vertex_of_fan[sheets.fan_of_corner[3 * f + k]];
      }
    }
  }

  /// Counts edges with more than two faces in the file, not edges that welding created.
  void count_crowded(const std::vector<FaceSide>& edge) {
    std::vector<std::pair<std::array<std::uint32_t, 2>, std::uint32_t>> sides;
    for (const FaceSide& s : edge) {
      const std::uint32_t f = s.face();
      const std::uint32_t a = file_.triangles[f][file_corner(f, s.side % 3)];
      const std::uint32_t b = file_.triangles[f][file_corner(f, (s.side + 1 - 3 * f) % 3)];
      sides.push_back({{std::min(a, b), std::max(a, b)}, f});
    }
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 0; i < sides.size();) {
      EdgePlace place{sides[i].first, {}};
      std::size_t faces = 0;
      for (; i < sides.size() && sides[i].first == place.vertices; ++i) {
        if (faces++ < EdgePlace::kFaces) place.faces.push_back(sides[i].second);
      }
      if (faces > 2) changes_.split_edges.add(place);
    }
  }

  std::vector<std::uint32_t> name_fans(const std::vector<Image>& wishes) {
    std::vector<std::uint32_t> vertex_of_fan(3 * lists_.triangles.size(), kNoVertex);
    std::vector<bool> taken(file_.points.size(), false);
    for (std::size_t i = 0; i < wishes.size();) {
      const auto [fan, smallest] = wishes[i];
      std::uint32_t& vertex = vertex_of_fan[fan];
      for (; i < wishes.size() && wishes[i].first == fan; ++i) {
        if (vertex == kNoVertex && !taken[wishes[i].second]) vertex = wishes[i].second;
      }
      if (vertex == kNoVertex) vertex = copy_of(smallest);
      if (vertex < taken.size()) taken[vertex] = true;
    }
    return vertex_of_fan;
  }

  std::uint32_t copy_of(std::uint32_t vertex) {
    if (lists_.points.size() >= kNoVertex) {
      throw Error(ErrorCode::kBadMesh, "The repaired mesh has more vertices than can be numbered.");
    }
    lists_.points.push_back(file_.points[vertex]);
    vertex_to_file_.push_back(vertex);
    ++changes_.vertex_copies;
    return static_cast<std::uint32_t>(lists_.points.size() - 1);
  }

  /// Pairs of a file vertex and a repaired vertex that it became, sorted. A vertex in no face of
  /// the file maps to itself.
  [[nodiscard]] std::vector<Image> vertex_images() const {
    std::vector<Image> images;
    std::vector<bool> used(file_.points.size(), false);
    for (std::uint32_t f = 0; f < kept_.size(); ++f) {
      for (std::uint32_t k = 0; kept_[f] && k < 3; ++k) {
        const std::uint32_t v = file_.triangles[f][file_corner(f, k)];
        images.emplace_back(v, lists_.triangles[f][k]);
        used[v] = true;
      }
    }
    // The corners of a repeated face map to the corners of the face that stays.
    for (const Double& d : doubles_) {
      const std::uint32_t f = d.place.earlier;
      for (std::uint32_t k = 0; kept_[f] && k < 3; ++k) {
        const std::uint32_t v = file_.triangles[d.place.element][k];
        images.emplace_back(v, lists_.triangles[f][file_corner(f, d.corner[k])]);
        used[v] = true;
      }
    }
    std::vector<Image> left;  // other vertices of dropped faces: as welded
    for (std::uint32_t f = 0; f < kept_.size(); ++f) {
      for (std::uint32_t k = 0; !kept_[f] && k < 3; ++k) {
        const std::uint32_t v = file_.triangles[f][k];
        if (!used[v]) left.emplace_back(v, lists_.triangles[f][k]);
        used[v] = true;
      }
    }
    images.insert(images.end(), left.begin(), left.end());
    for (std::uint32_t v = 0; v < used.size(); ++v) {
      if (!used[v]) images.emplace_back(v, v);
    }
    std::sort(images.begin(), images.end());
    images.erase(std::unique(images.begin(), images.end()), images.end());
    return images;
  }

  void count_vertices(const std::vector<Image>& images) {
    for (std::size_t i = 0; i < images.size();) {
      const auto [vertex, first] = images[i];
      std::size_t end = i + 1;
      while (end < images.size() && images[end].first == vertex) ++end;
      if (end - i > 1) changes_.split_vertices.add(vertex);
      if (first < vertex) changes_.welded_vertices.add({vertex, first});
      for (; i < end; ++i) {
        const double moved = point_distance(file_.points[vertex], lists_.points[images[i].second]);
        changes_.weld_distance = std::max(changes_.weld_distance, moved);
      }
    }
  }

  /// The image of a kept face, with its corners in the order of the file.
  [[nodiscard]] RepairMap::FaceImage image_of(std::uint32_t f, std::uint32_t number) const {
    RepairMap::FaceImage image{number, {0, 1, 2}};
    if (turned_[f]) std::swap(image.corner[1], image.corner[2]);
    return image;
  }

  RepairedMesh finished() {
    const std::vector<Image> images = vertex_images();
    count_vertices(images);
    std::vector<std::uint32_t> face_to_file;
    std::vector<RepairMap::FaceImage> faces(kept_.size());
    for (std::uint32_t f = 0; f < kept_.size(); ++f) {
      if (kept_[f]) {
        const auto number = static_cast<std::uint32_t>(face_to_file.size());
        faces[f] = image_of(f, number);
        lists_.triangles[number] = lists_.triangles[f];
        face_to_file.push_back(f);
      }
    }
    for (const Double& d : doubles_) {
      const RepairMap::FaceImage& other = faces[d.place.earlier];
      for (std::size_t k = 0; k < 3; ++k) {
        faces[d.place.element].corner[k] = other.corner[d.corner[k]];
      }
      faces[d.place.element].face = other.face;
    }
    lists_.triangles.resize(face_to_file.size());
    lists_.polygons.clear();
    return {
        std::move(lists_),
        RepairMap(std::move(vertex_to_file_), std::move(face_to_file), std::move(faces), images),
        std::move(changes_)};
  }

  const MeshLists& file_;
  MeshLists lists_;
  std::vector<bool> kept_;
  std::vector<bool> turned_;
  std::vector<Double> doubles_;
  std::vector<std::uint32_t> vertex_to_file_;
  MeshChanges changes_;
};

}  // namespace

RepairedMesh repair(const MeshLists& lists, const RepairSteps& steps) {
  if (!mendable(lists)) throw Error(ErrorCode::kBadMesh, obstacle(inspect(lists)));
  return Repair(lists).run(steps);
}

RepairedMesh repair_to_surface(const MeshLists& lists, const RepairSteps& steps) {
  RepairedMesh repaired = repair(lists, steps);
  const MeshInspection after = inspect(repaired.lists);
  if (after.verdict == MeshVerdict::kUsable) return repaired;
  throw Error(
      ErrorCode::kBadMesh,
      "The repaired mesh cannot be used, either (numbers are those of the repaired mesh): " +
          after.reason);
}

void try_repair(const MeshLists& lists, MeshInspection& inspection) {
  if (inspection.verdict != MeshVerdict::kRepairable) return;
  const MeshInspection after = inspect(repair(lists, repair_steps(inspection.steps)).lists);
  if (after.verdict == MeshVerdict::kUsable) return;
  inspection.verdict = MeshVerdict::kUnusable;
  inspection.reason += " Repair (" + inspection.steps + ") does not help: " + after.reason;
  inspection.steps.clear();
}

namespace {

/// The result of the step `weld` and the steps that must follow it; empty if the result is not
/// usable.
std::optional<WeldedMesh> welded_by(const MeshLists& lists, const std::string& weld) {
  WeldedMesh welded;
  const auto inspect_with = [&](const std::string& steps) {
    const RepairedMesh mesh = repair(lists, repair_steps(steps));
    welded.steps = steps;
    welded.vertices = mesh.changes.welded_vertices.count;
    welded.after = inspect(mesh.lists);
  };
  inspect_with(weld);
  if (welded.after.verdict == MeshVerdict::kRepairable) {
    inspect_with(fmt::format("{},{}", weld, welded.after.steps));
  }
  if (welded.after.verdict != MeshVerdict::kUsable) return {};
  return welded;
}

/// Whether `welded` has fewer components or boundary loops than `than`.
bool joins_more(const MeshInspection& welded, const MeshInspection& than) {
  return welded.components < than.components || welded.boundary_loops < than.boundary_loops;
}

}  // namespace

std::optional<WeldedMesh> try_weld(const MeshLists& lists, const MeshInspection& before) {
  if (before.verdict == MeshVerdict::kUnusable) return {};
  return try_weld(lists, before, near_vertices(lists, before));
}

std::optional<WeldedMesh> try_weld(const MeshLists& lists, const MeshInspection& before,
                                   const NearVertices& near) {
  if (before.verdict == MeshVerdict::kUnusable) return {};
  std::optional<WeldedMesh> best;
  if (before.duplicate_positions.found()) best = welded_by(lists, "weld");
  if (best && !joins_more(best->after, before)) best.reset();
  if (near.count == 0) return best;
  auto nearly = welded_by(lists, fmt::format("weld={:.2g}", near.tolerance));
  if (!nearly || !joins_more(nearly->after, best ? best->after : before)) return best;
  nearly->tolerance = near.tolerance;
  nearly->vertices = near.count;
  return nearly;
}

}  // namespace talweg
