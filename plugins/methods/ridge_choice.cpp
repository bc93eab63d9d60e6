#include "ridge_choice.hpp"

#include <cmath>
#include <cstdint>

namespace talweg::plugins {
namespace {

constexpr const char* kKinds[] = {"both", "convex", "concave"};
constexpr const char* kKindLabels[] = {"Ridges and valleys", "Ridges", "Valleys"};

}  // namespace

std::vector<talweg_parameter> ridge_choice(std::uint32_t stage) {
  using plugin::choice, plugin::number;
  return {
      number("ridges", "Snap to ridges", "", 0, {0, 1, 0, 1},
             "How strongly ridges, creases and valleys beside the drawing attract the drawing. "
             "Clicks move, too; pins stay. 0: not at all. At the strength s a ridge attracts the "
             "drawing if the surface turns by more than 10 degrees / s there: 10 at 1, 20 at 0.5.",
             stage),
      choice("ridge_kind", "Kind of ridges", "both", kKinds, kKindLabels,
             "convex: ridges, which stand out; concave: valleys; both.", stage),
      number("ridge_band", "Band of ridges", "mesh units", 0, {0, HUGE_VAL, 0, 10},
             "How far from the drawing a ridge may lie. By default a fortieth of its length, 4 to "
             "12 edges of the mesh; between two clicks a quarter of the way.",
             stage, TALWEG_OPTIONAL | TALWEG_ADVANCED | TALWEG_OPEN_MINIMUM),
  };
}

RidgeOptions ridge_options_of(const plugin::Parameters& parameters) {
  RidgeOptions options;
  options.strength = parameters.number("ridges");
  options.kind = ridge_kind(parameters.choice("ridge_kind"));
  options.band = parameters.optional("ridge_band");
  return options;
}

}  // namespace talweg::plugins
