// talweg-stage-instructions: every stage once, for callgrind to count (run bench --check).
#include <cstdio>
#include <cstring>
#include <iterator>

#include <valgrind/callgrind.h>

#include "stages.hpp"

namespace talweg::benchmarks {
namespace {

void count_all() {
  Stages stages(generated_mesh());
  const auto count = [&](const char* name, void (Stages::*call)()) {
    CALLGRIND_ZERO_STATS;
    CALLGRIND_TOGGLE_COLLECT;
    (stages.*call)();
    CALLGRIND_TOGGLE_COLLECT;
    CALLGRIND_DUMP_STATS_AT(name);
  };
  for (const Stage& stage : kStages) count(stage.name, stage.run);
}

}  // namespace
}  // namespace talweg::benchmarks

int main(int argc, char** argv) {
  if (argc > 1 && std::strcmp(argv[1], "--compiler") == 0) {
    std::puts(TALWEG_COMPILER);
    return 0;
  }
  if (argc > 1 && std::strcmp(argv[1], "--stages") == 0) {
    std::printf("%zu\n", std::size(talweg::benchmarks::kStages));
    return 0;
  }
  talweg::benchmarks::count_all();
}
