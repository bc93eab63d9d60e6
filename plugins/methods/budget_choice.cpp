#include "budget_choice.hpp"

#include <cmath>
#include <cstdint>

namespace talweg::plugins {

std::vector<talweg_parameter> budget_parameters() {
  constexpr std::uint32_t kFlags = TALWEG_OPTIONAL | TALWEG_ADVANCED;
  return {
      plugin::number("budget", "Budget", "s", 10, {0, HUGE_VAL, 0, 60},
                     "The time that a run may take. When it is used up, the stages that improve a "
                     "result step by step (fairing, the search for the largest deviation, moving "
                     "junctions, measuring) end with the best result so far, and the report says "
                     "so. By default no limit.",
                     TALWEG_STAGE_RUN, kFlags | TALWEG_OPEN_MINIMUM),
      plugin::integer("budget_work", "Budget of work", 1e9, {1, 1e15, 1e6, 1e10},
                      "The work that a run may do, in steps of about 0.1 microseconds. Unlike a "
                      "limit of time it gives the same result on every machine. By default no "
                      "limit.",
                      TALWEG_STAGE_RUN, kFlags),
  };
}

Budget budget_of(const plugin::Parameters& parameters) {
  Budget budget;
  budget.seconds = parameters.optional("budget");
  if (const auto work = parameters.optional("budget_work")) {
    budget.work = static_cast<std::uint64_t>(*work);
  }
  return budget;
}

}  // namespace talweg::plugins
