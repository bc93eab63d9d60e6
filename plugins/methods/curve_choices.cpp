#include "curve_choices.hpp"

namespace talweg::plugins {
namespace {

constexpr const char* kEnds[] = {"auto", "closed", "open"};
constexpr const char* kEndLabels[] = {"Loops where they meet", "All are loops", "Open"};
constexpr const char* kSides[] = {"both", "left", "right"};
constexpr const char* kSideLabels[] = {"Both sides", "Left of the curves", "Right of the curves"};

}  // namespace

talweg_parameter ends_choice(std::uint32_t stage) {
  return plugin::choice(
      "ends", "Ends", "auto", kEnds, kEndLabels,
      "auto: a stroke whose end stops a little short of its beginning, or runs over it, is a loop; "
      "closed: every curve is a loop; open: only curves that are given as closed are loops.",
      stage);
}

talweg_parameter side_choice(const char* id, const char* label, const char* doc) {
  return plugin::choice(id, label, "both", kSides, kSideLabels, doc);
}

}  // namespace talweg::plugins
