#include "inspection.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

#include "report_json.hpp"

namespace talweg::browser {
namespace {

using editing::MeshArrays;

/// The number of vertices at exactly the place of another vertex.
std::size_t repeated_places(const MeshArrays& mesh) {
  using Bits = std::array<std::uint64_t, 3>;  // ordered even if a coordinate is NaN
  std::vector<Bits> places(mesh.positions.size());
  for (std::size_t v = 0; v < places.size(); ++v) {
    std::memcpy(places[v].data(), mesh.positions[v].data(), sizeof(Bits));
  }
  std::sort(places.begin(), places.end());
  const auto end = std::unique(places.begin(), places.end());
  return static_cast<std::size_t>(places.end() - end);
}

/// Whether welding may be needed. A surface has about half as many vertices as triangles, a
/// triangle soup three for each triangle. For a large mesh the search is worth its time only if
/// welding may be needed at many places.
bool may_need_welding(const MeshArrays& mesh) {
  const std::size_t vertices = mesh.positions.size();
  if (vertices > mesh.triangles.size()) return true;
  const std::size_t repeated = repeated_places(mesh);
  return mesh.triangles.size() > kInspected ? repeated > vertices / 20 : repeated > 0;
}

/// The number of vertices in triangles: vertices that were welded onto others stay in the list.
std::size_t used_vertices(const host::Mesh& mesh) {
  std::vector<bool> used(mesh.positions.size());
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t v : triangle) used[v] = true;
  }
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
}

}  // namespace

host::Results inspected(const editing::Plugins& plugins, const MeshArrays& mesh) {
  const host::Services services("Talweg page", "1");
  host::Instance repair(plugins.find("talweg.repair"), services);
  editing::set_mesh(repair, mesh);
  return repair.run();
}

std::optional<WeldOffer> weld_offer(const editing::Plugins& plugins, const MeshArrays& mesh) try {
  if (!may_need_welding(mesh)) return {};
  const host::Results all = inspected(plugins, mesh);
  if (all.find("weld.vertices") == nullptr) return {};
  const auto count = [&](const char* key) { return number_or_null(all, key, -1); };
  return WeldOffer{all.number("weld.tolerance"),
                   {{"tolerance", count("weld.tolerance")},
                    {"vertices", count("weld.vertices")},
                    {"parts", count("weld.components")},
                    {"partsNow", count("components")},
                    {"borders", count("weld.boundary_loops")},
                    {"bordersNow", count("boundary_loops")}}};
} catch (const std::exception&) {
  return {};  // the mesh can be used without welding
}

Json repair_told(const editing::Plugins& plugins, const MeshArrays& mesh, double weld_tolerance) {
  const host::Services services("Talweg page", "1");
  host::Instance repair(plugins.find("talweg.repair"), services);
  editing::set_mesh(repair, mesh);
  if (weld_tolerance > 0) repair.set("repair_weld_tolerance", weld_tolerance);
  host::Wanted wanted;
  wanted.meshes = true;
  const host::Results made = repair.run(wanted);
  if (made.meshes.empty()) return nullptr;
  const host::ReportEntry* changes = made.find("repair.changes");
  return {{"vertices", used_vertices(made.meshes[0])},
          {"faces", made.meshes[0].triangles.size()},
          {"changes", changes == nullptr ? std::vector<std::string>() : changes->texts}};
}

}  // namespace talweg::browser
