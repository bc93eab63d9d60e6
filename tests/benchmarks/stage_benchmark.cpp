// talweg-bench: times per stage on the generated mesh and, where present, on real ones.
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include <benchmark/benchmark.h>

#include "stages.hpp"

namespace talweg::benchmarks {
namespace {

void register_stages(const std::string& name, const std::filesystem::path& file) {
  // Made when the first of its benchmarks runs, so meshes that a filter excludes are not made.
  auto held = std::make_shared<std::unique_ptr<Stages>>();
  const auto add = [&](const char* stage, void (Stages::*call)()) {
    benchmark::RegisterBenchmark((name + "/" + stage).c_str(), [=](benchmark::State& state) {
      if (!*held) *held = std::make_unique<Stages>(file);
      Stages& stages = **held;
      if (call == &Stages::trace) stages.straighten();
      for (auto _ : state) {
        (stages.*call)();
        if (call == &Stages::straighten || call == &Stages::trace) {
          state.PauseTiming();
          if (call == &Stages::straighten) stages.trace();
          if (call == &Stages::trace) stages.straighten();
          state.ResumeTiming();
        }
      }
      if (call == &Stages::trace) stages.trace();
      state.counters["faces"] = static_cast<double>(stages.faces());
    })->Unit(benchmark::kMillisecond);
  };
  for (const Stage& stage : kStages) add(stage.name, stage.run);
}

}  // namespace
}  // namespace talweg::benchmarks

int main(int argc, char** argv) {
  using namespace talweg::benchmarks;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  register_stages("generated_50k", generated_mesh());
  const char* given = std::getenv("TALWEG_MESHES");
  const std::filesystem::path meshes = given != nullptr ? given : "../shared/meshes";
  for (const char* name : {"fandisk_14k", "armadillo_86k", "mouse_skull_984k"}) {
    const std::filesystem::path file = meshes / (std::string(name) + ".ply");
    if (std::filesystem::exists(file)) register_stages(name, file);
  }
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
