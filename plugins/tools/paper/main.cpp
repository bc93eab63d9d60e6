// talweg-paper: the paper's experiments with its own potential.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/version.hpp"
#include "talweg/intrinsic/error.hpp"
#include "tools/paper/experiment.hpp"

namespace talweg::paper {
namespace {

std::string processor() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown processor";
}

int run(int argc, char** argv) {
  CLI::App app("Reproduces the paper's table and figures: pictures and results.md.",
               "talweg-paper");
  Folders folders;
  std::vector<std::string> parts{"table1", "tau", "resolution", "relaxation"};
  app.add_option("OUTDIR", folders.out, "Where results go")->required();
  app.add_option("--meshes", folders.meshes,
                 "Folder with the real meshes; generated ones stand for those that are absent");
  app.add_option("--only", parts, "Parts to run")
      ->delimiter(',')
      ->check(CLI::IsMember(parts))
      ->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    return app.exit(asked);
  } catch (const CLI::ParseError& error) {
    throw Error(ErrorCode::kBadUsage, error.what());
  }
  std::filesystem::create_directories(folders.out);
  std::string text = "Talweg " + std::string(version()) + ", one core of " + processor() +
                     ", medians of 5. h: mean edge length; "
                     "deviation: from the result to the drawing.\n";
  for (const std::string& part : parts) {
    std::printf("%s\n", part.c_str());
    std::fflush(stdout);
    text += "\n" + (part == "table1"       ? table1(folders)
                    : part == "tau"        ? tau_figure(folders)
                    : part == "resolution" ? resolution_figures(folders)
                                           : relaxation_figure(folders));
  }
  write_file(folders.out / "results.md", text);
  return 0;
}

}  // namespace
}  // namespace talweg::paper

int main(int argc, char** argv) {
  try {
    return talweg::paper::run(argc, argv);
  } catch (const talweg::Error& error) {
    std::fprintf(stderr, "talweg-paper: %s\n", error.what());
    return error.code() == talweg::ErrorCode::kBadUsage ? 1 : 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "talweg-paper: %s\n", error.what());
    return 5;
  }
}
