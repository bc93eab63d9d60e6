// The entry of libFuzzer: TALWEG_FUZZ_TARGET names the target (fuzz_target.cpp).
#include <cstdio>
#include <cstdlib>

#include "fuzz_target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const talweg::fuzz::Target* const target = [] {
    const char* name = std::getenv("TALWEG_FUZZ_TARGET");
    const talweg::fuzz::Target* found = talweg::fuzz::target_named(name == nullptr ? "" : name);
    if (found != nullptr) return found;
    std::fprintf(stderr, "TALWEG_FUZZ_TARGET must be one of:\n");
    for (const auto& t : talweg::fuzz::targets()) std::fprintf(stderr, "  %s\n", t.name.c_str());
    std::exit(1);
  }();
  talweg::fuzz::run(*target, data, size);
  return 0;
}
