#include "talweg/core/repair/weld_hint.hpp"

#include <fmt/format.h>

#include "talweg/core/mesh/mesh_inspection.hpp"
#include "talweg/core/space/message_numbers.hpp"

namespace talweg {
namespace {

std::string counted(std::size_t n, const char* what) {
  return fmt::format("{} {}{}", count_text(n), what, n == 1 ? "" : "s");
}

std::string boundary_of(const MeshInspection& m) {
  return m.boundary_loops == 0 ? "no boundary" : counted(m.boundary_loops, "boundary loop");
}

}  // namespace

std::string weld_sentence(const MeshInspection& before, const WeldedMesh& welded,
                          std::string_view option) {
  const bool one = welded.vertices == 1;
  const std::string where =
      welded.tolerance > 0 ? fmt::format("within {:.2g} of", welded.tolerance) : "at the place of";
  std::string text =
      fmt::format("{} {} {} {}: with {}{} the mesh has {}", count_text(welded.vertices),
                  one ? "vertex lies" : "vertices lie", where, one ? "another" : "others", option,
                  welded.steps, counted(welded.after.components, "part"));
  if (welded.after.components != before.components) {
    text += fmt::format(" instead of {}", count_text(before.components));
  }
  text += " and " + boundary_of(welded.after);
  if (welded.after.boundary_loops != before.boundary_loops) {
    text += " instead of " + boundary_of(before);
  }
  return text + ".";
}

std::string weld_hint(const MeshLists& mesh, std::string_view option) {
  const MeshInspection before = inspect(mesh);
  const auto welded = try_weld(mesh, before);
  return welded ? fmt::format(" {}", weld_sentence(before, *welded, option)) : std::string();
}

std::string weld_hint(const SurfaceMesh& mesh, std::string_view option) {
  MeshLists lists;
  lists.points.assign(mesh.points().begin(), mesh.points().end());
  for (std::size_t f = 0; f < mesh.surface().face_count(); ++f) {
    const auto corners = mesh.surface().corners(FaceId{f});
    Triangle& t = lists.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) t[k] = static_cast<std::uint32_t>(corners[k].index());
  }
  return weld_hint(lists, option);
}

}  // namespace talweg
