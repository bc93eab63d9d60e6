#include "compare/methods.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>

#include <fmt/format.h>

#include "talweg/intrinsic/error.hpp"

namespace talweg::driver {
namespace {

/// `count` values from `first` to `last` with equal ratios.
std::vector<double> geometric(double first, double last, int count) {
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) {
    values.push_back(first * std::pow(last / first, static_cast<double>(k) / (count - 1)));
  }
  return values;
}

}  // namespace

bool same_method(const Method& a, const Method& b) {
  return a.plugin == b.plugin && a.settings == b.settings;
}

const std::vector<Method>& known_methods() {
  static const std::vector<Method> methods = {
      {"corridor", "talweg.smooth", "1450c0", {}, "slack", true, geometric(0.1, 100, 16)},
      {"corridor-tau", "talweg.smooth", "00a0c8", {}, "tau", false, geometric(64, 1.0 / 64, 13)},
      {"paper",
       "talweg.smooth",
       "731f8c",
       {{"potential", "paper"}},
       "tau",
       false,
       geometric(64, 1.0 / 64, 13)},
      {"paper-relaxed",
       "talweg.smooth",
       "c060d0",
       {{"potential", "paper"}, {"relax", 5.0}},
       "tau",
       false,
       geometric(64, 1.0 / 64, 13)},
      {"envelope", "talweg.envelope", "e08a00", {}, "envelope", true, geometric(0.25, 16, 13)},
      {"bipartition",
       "talweg.bipartition",
       "2e8b40",
       {},
       "iterations",
       false,
       {0, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000}},
      {"midpoints", "talweg.midpoints", "808000", {}, "spacing", true, geometric(2, 128, 13)},
      {"geodesic", "talweg.geodesic", "606060", {}, "", false, {}},
  };
  return methods;
}

const Method& bounded_method() {
  static const Method method{"corridor-bound", "talweg.smooth", "101030", {},
                             "max_deviation",  false,           {}};
  return method;
}

std::vector<Method> methods_of(const std::string& list) {
  if (list.empty()) return known_methods();
  std::vector<Method> chosen;
  std::istringstream names(list);
  for (std::string name; std::getline(names, name, ',');) {
    const auto known = std::find_if(known_methods().begin(), known_methods().end(),
                                    [&](const Method& m) { return m.name == name; });
    if (known != known_methods().end()) {
      chosen.push_back(*known);
    } else if (name.find('.') != std::string::npos) {
      chosen.push_back({name, name, "905020", {}, "", false, {}});
    } else {
      std::string all;
      for (const Method& m : known_methods()) all += (all.empty() ? "" : ", ") + m.name;
      throw Error(
          ErrorCode::kBadUsage,
          fmt::format("There is no method \"{}\". The methods are {}, and any plugin by its id.",
                      name, all));
    }
  }
  return chosen;
}

}  // namespace talweg::driver
