// Arbitrary raw lists: inspected, repaired, opened. Every change is reported.
#include <algorithm>
#include <array>
#include <string>

#include "fuzz_bytes.hpp"
#include "fuzz_target.hpp"
#include "small_mesh.hpp"
#include "talweg/core/mesh/mesh_inspection.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/repair/mesh_repair.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::fuzz {
namespace {

/// The verdict of the inspection must agree with opening.
void check_opening(const MeshLists& lists, const MeshInspection& found) {
  const bool usable = found.verdict == MeshVerdict::kUsable;
  require(!found.reason.empty() && found.reason.back() == '.', "a sentence");
  try {
    const SurfaceMesh mesh = SurfaceMesh::open(lists);
    require(usable, "only what is usable opens");
    require(mesh.surface().face_count() == lists.triangles.size(), "all faces");
    require(mesh.points().size() == lists.points.size(), "all vertices");
  } catch (const Error& error) {
    require(error.code() == ErrorCode::kBadMesh, "a mesh's error");
    require(!usable, "what is usable opens");
  }
}

void check_faces(const MeshLists& lists, const RepairedMesh& mended) {
  for (std::size_t f = 0; f < lists.triangles.size(); ++f) {
    const RepairMap::FaceImage& image = mended.map.image(FaceId{f});
    if (image.face == RepairMap::kDropped) continue;
    require(image.face < mended.lists.triangles.size(), "faces that exist");
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = mended.lists.triangles[image.face][image.corner[k]];
      const auto became = mended.map.images(VertexId{lists.triangles[f][k]});
      require(std::find(became.begin(), became.end(), v) != became.end(), "corners that are told");
    }
  }
}

void check_repair(const MeshLists& lists, const RepairedMesh& mended) {
  const MeshChanges& c = mended.changes;
  const std::size_t dropped =
      c.collapsed_faces.count + c.duplicate_faces.count + c.zero_area_faces.count;
  require(mended.lists.triangles.size() + dropped == lists.triangles.size(), "every dropped face");
  require(mended.lists.points.size() == lists.points.size() + c.vertex_copies, "every copy");
  require(c.any() || mended.lists.triangles == lists.triangles, "every change of faces");
  require(!c.any() || !sentences(c).empty(), "every change in words");
  for (std::size_t v = 0; v < mended.lists.points.size(); ++v) {
    const std::size_t from = mended.map.file_vertex(VertexId{v}).index();
    require(from < lists.points.size(), "vertices of the file");
    const Point& place = lists.points[from];
    require(mended.lists.points[v] == place || !place.allFinite(), "positions stay");
  }
  check_faces(lists, mended);
}

}  // namespace

void take_in(const Target& /*target*/, const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  const std::uint8_t steps = bytes.take<std::uint8_t>();
  const MeshLists lists = small_mesh(bytes, 255);
  const MeshInspection found = inspect(lists);
  check_opening(lists, found);
  MeshInspection tried = found;
  if (found.verdict != MeshVerdict::kUnusable) try_repair(lists, tried);
  const RepairSteps wanted{(steps & 1U) != 0, (steps & 2U) != 0, (steps & 4U) != 0,
                           (steps & 8U) != 0};
  const bool mendable = found.verdict == MeshVerdict::kRepairable;
  const RepairSteps named = mendable ? repair_steps(found.steps) : wanted;
  RepairSteps within;
  within.weld_tolerance = found.edge_length_mean * static_cast<double>(steps >> 4U) / 8;
  const std::array ways{RepairSteps{}, wanted, named, within};
  for (const RepairSteps& how : ways) {
    try {
      const RepairedMesh mended = repair(lists, how);
      check_repair(lists, mended);
      const MeshInspection after = inspect(mended.lists);
      check_opening(mended.lists, after);
      // The promise of repair excludes dropped faces, which change the neighbours of other faces.
      const bool promised = found.steps.find("drop") == std::string::npos && &how == &ways[2];
      require(!mendable || !promised || after.verdict == MeshVerdict::kUsable, "mends as promised");
    } catch (const Error& error) {
      require(error.code() == ErrorCode::kBadMesh, "a mesh's error");
      require(found.verdict == MeshVerdict::kUnusable, "only refused where nothing helps");
    }
  }
}

}  // namespace talweg::fuzz
