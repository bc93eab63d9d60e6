// talweg plugins: the plugins that can be loaded, and files that were refused.
#include <cstdio>

#include "commands.hpp"
#include "plugin_host.hpp"

namespace talweg::driver {
namespace {

int list_plugins(const GlobalOptions& global) {
  const talweg_loader* loader = plugin_loader();
  for (std::uint64_t k = 0; k < talweg_loader_count(loader); ++k) {
    const talweg_plugin& plugin = *talweg_loader_plugin(loader, k);
    std::printf("%s\t%s", plugin.id, plugin.label);
    if (global.verbose) std::printf("\t%s\t%s", plugin.version, talweg_loader_path(loader, k));
    std::printf("\n");
  }
  for (std::uint64_t k = 0; !global.quiet && k < talweg_loader_refused_count(loader); ++k) {
    std::fprintf(stderr, "talweg: %s: %s\n", talweg_loader_refused_path(loader, k),
                 talweg_loader_refused_reason(loader, k));
  }
  return kDone;
}

}  // namespace

Command add_plugins(CLI::App& app, const GlobalOptions& global) {
  CLI::App* command =
      app.add_subcommand("plugins",
                         "List the plugins: id and label, with --verbose also version "
                         "and file; refused files, with the reason, on stderr");
  static_cast<void>(command);
  return [&global] { return list_plugins(global); };
}

}  // namespace talweg::driver
