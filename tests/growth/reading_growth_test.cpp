#include <string>

#include "growth/counted_work.hpp"
#include "talweg/core/io/curve_file.hpp"

namespace talweg::test {
namespace {

TEST(Growth, ReadingACurveOfManyPoints) {
  expect_growth("read_curves, JSON", 1.1, {200, 2000, 20000}, [](std::size_t n) {
    std::string bytes = R"({"format": "talweg-curves", "version": 1, "curves": [{"closed": false,)"
                        R"( "points": [)";
    for (std::size_t i = 0; i < n; ++i) {
      if (i > 0) bytes += ',';
      bytes += R"({"face": 7, "barycentric": [0.25, 0.25, 0.5]})";
    }
    bytes += "]}]}";
    return [bytes] { (void)read_curves("many.json", bytes); };
  });
}

}  // namespace
}  // namespace talweg::test
