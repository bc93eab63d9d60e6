// talweg info: the size, the topology and the defects of a mesh.
#include <cstdio>
#include <optional>
#include <string>
#include <utility>

#include "commands.hpp"
#include "info_text.hpp"
#include "repaired_mesh.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/core/mesh/mesh_inspection.hpp"
#include "talweg/core/mesh/opened_mesh.hpp"
#include "talweg/core/repair/mesh_repair.hpp"
#include "talweg/core/repair/vertex_welding.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg::driver {
namespace {

struct InfoOptions {
  std::string mesh;
  bool json = false;
  std::string repair;
};

/// The effect of a repair; nothing if none was requested or nothing needs repair.
std::optional<InfoRepair> repair_of(const MeshLists& lists, const std::string& list) {
  if (list.empty()) return std::nullopt;
  try {
    RepairedMesh repaired = repair(lists, repair_steps(list));
    return InfoRepair{std::move(repaired.changes), inspect(repaired.lists)};
  } catch (const Error& error) {
    if (error.code() != ErrorCode::kBadMesh) throw;
    return std::nullopt;  // the verdict says why
  }
}

}  // namespace

Command add_info(CLI::App& app, const GlobalOptions& /*global*/) {
  auto options = std::make_shared<InfoOptions>();
  CLI::App* command = app.add_subcommand(
      "info", "Tell what a mesh is, what is wrong with it, and whether curves can be drawn on it");
  command->add_option("mesh", options->mesh, mesh_help())->required();
  command->add_flag("--json", options->json, "As JSON");
  add_repair_option(*command, options->repair);
  return [options] {
    check_repair(options->repair);
    InfoTimes times;
    const Stopwatch load;
    const MeshLists lists = read_mesh(options->mesh);
    times.load = load.ms();
    const Stopwatch check;
    MeshInspection inspection = inspect(lists);
    try_repair(lists, inspection);
    times.inspect = check.ms();
    const NearVertices near = near_vertices(lists, inspection);
    const std::optional<WeldedMesh> welded = try_weld(lists, inspection, near);
    if (inspection.verdict == MeshVerdict::kUsable) times.open = OpenedMesh::open(lists)->open_ms();
    const std::optional<InfoRepair> repaired = repair_of(lists, options->repair);
    const std::string text = options->json ? info_json(inspection, times, repaired, welded, near)
                                           : info_text(inspection, times, repaired, welded, near);
    std::fputs(text.c_str(), stdout);
    const MeshVerdict verdict = repaired ? repaired->after.verdict : inspection.verdict;
    return verdict == MeshVerdict::kUnusable ? kBadInput : kDone;
  };
}

}  // namespace talweg::driver
