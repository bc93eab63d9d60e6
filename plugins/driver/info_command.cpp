// talweg info: what a mesh is, and what is wrong with it.
#include <cstdio>
#include <string>

#include "commands.hpp"
#include "info_text.hpp"
#include "talweg/core/mesh_inspection.hpp"
#include "talweg/core/mesh_reader.hpp"

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
    const MeshInspection inspection = inspect(read_mesh(options->mesh));
    const std::string text = options->json ? info_json(inspection) : info_text(inspection);
    std::fputs(text.c_str(), stdout);
    return inspection.verdict == MeshVerdict::kUnusable ? kBadInput : kDone;
  };
}

}  // namespace talweg::driver
