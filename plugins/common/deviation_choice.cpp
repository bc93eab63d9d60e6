#include "deviation_choice.hpp"

#include <string>

namespace talweg::plugins {
namespace {

constexpr const char* kDeviations[] = {"surface", "euclidean", "none"};
constexpr const char* kDeviationLabels[] = {"Along the surface", "Through space", "None"};

}  // namespace

talweg_parameter deviation_choice() {
  return plugin::choice("deviation", "Deviation in the report", "surface", kDeviations,
                        kDeviationLabels, "Which distance between result and drawing is measured.",
                        TALWEG_STAGE_RUN, TALWEG_ADVANCED);
}

DeviationMeasure deviation_of(const plugin::Parameters& parameters) {
  const std::string& choice = parameters.choice("deviation");
  if (choice == "surface") return DeviationMeasure::kAlongSurface;
  return choice == "euclidean" ? DeviationMeasure::kEuclidean : DeviationMeasure::kNone;
}

}  // namespace talweg::plugins
