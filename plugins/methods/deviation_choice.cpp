#include "deviation_choice.hpp"

#include <string>

namespace talweg::plugins {
namespace {

constexpr const char* kDeviations[] = {"surface", "euclidean", "none"};
constexpr const char* kDeviationLabels[] = {"Along the surface", "Through space", "None"};
constexpr const char* kWithAutomatic[] = {"automatic", "surface", "euclidean", "none"};
constexpr const char* kLabelsWithAutomatic[] = {"Automatic", "Along the surface", "Through space",
                                                "None"};

}  // namespace

talweg_parameter deviation_choice() {
  return plugin::choice("deviation", "Deviation in the report", "surface", kDeviations,
                        kDeviationLabels, "The distance between result and drawing to measure.",
                        TALWEG_STAGE_RUN, TALWEG_ADVANCED);
}

talweg_parameter deviation_choice_by_tau() {
  return plugin::choice("deviation", "Deviation in the report", "automatic", kWithAutomatic,
                        kLabelsWithAutomatic,
                        "The distance between result and drawing to measure; automatic: along the "
                        "surface, but below tau = 1/8 through space if result and drawing lie more "
                        "than four mesh edges apart.",
                        TALWEG_STAGE_RUN, TALWEG_ADVANCED);
}

DeviationMeasure deviation_of(const plugin::Parameters& parameters) {
  const std::string& choice = parameters.choice("deviation");
  if (choice == "automatic") return DeviationMeasure::kAutomatic;
  if (choice == "surface") return DeviationMeasure::kAlongSurface;
  return choice == "euclidean" ? DeviationMeasure::kEuclidean : DeviationMeasure::kNone;
}

}  // namespace talweg::plugins
