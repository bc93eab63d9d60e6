// talweg info: what a mesh is, and what is wrong with it.
#include <cstdio>
#include <string>

#include "commands.hpp"
#include "info_text.hpp"
#include "talweg/core/mesh_inspection.hpp"
#include "talweg/core/mesh_reader.hpp"
#include "talweg/core/opened_mesh.hpp"
#include "talweg/core/stopwatch.hpp"

namespace talweg::driver {
namespace {

struct InfoOptions {
  std::string mesh;
  bool json = false;
};

}  // namespace

Command add_info(CLI::App& app, const GlobalOptions& /*global*/) {
  auto options = std::make_shared<InfoOptions>();
  CLI::App* command = app.add_subcommand(
      "info", "Tell what a mesh is, what is wrong with it, and whether curves can be drawn on it");
  command->add_option("mesh", options->mesh, "Mesh: OBJ, OFF, PLY, STL or OM")->required();
  command->add_flag("--json", options->json, "As JSON");
  return [options] {
    InfoTimes times;
    const Stopwatch load;
    const MeshLists lists = read_mesh(options->mesh);
    times.load = load.ms();
    const Stopwatch check;
    const MeshInspection inspection = inspect(lists);
    times.inspect = check.ms();
    if (inspection.verdict == MeshVerdict::kUsable) times.open = OpenedMesh::open(lists)->open_ms();
    const std::string text =
        options->json ? info_json(inspection, times) : info_text(inspection, times);
    std::fputs(text.c_str(), stdout);
    return inspection.verdict == MeshVerdict::kUnusable ? kBadInput : kDone;
  };
}

}  // namespace talweg::driver
