// The compared methods are plugins, each with one parameter that chooses between smooth and close.
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace talweg::driver {

struct Method {
  std::string name;    ///< the name used by --methods
  std::string plugin;  ///< id
  std::string color;   ///< rrggbb, for pictures and plots
  std::vector<std::pair<std::string, std::variant<double, std::string>>> settings;
  std::string swept;           ///< parameter id; empty if nothing is swept
  bool in_edges = false;       ///< whether its values below are in mean edges near the drawing
  std::vector<double> values;  ///< of the sweep, from close to smooth
};

/// Whether two methods are equal except for their swept parameters.
bool same_method(const Method& a, const Method& b);

/// All methods in the order of tables and pictures; the others are compared with the first.
const std::vector<Method>& known_methods();

/// The default method with a bound on its deviation, to run it at exactly the deviation of another
/// run.
const Method& bounded_method();

/// The methods of a list of names and plugin ids, separated by commas; all known methods if it is
/// empty. A plugin given by its id runs with its defaults. Throws Error(kBadUsage) naming a word
/// that is neither.
std::vector<Method> methods_of(const std::string& list);

}  // namespace talweg::driver
