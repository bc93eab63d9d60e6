// The compared methods are plugins, each with one parameter that chooses between smooth and close.
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace talweg::driver {

struct Method {
  std::string name;    ///< as --methods has it
  std::string plugin;  ///< id
  std::string color;   ///< rrggbb, in pictures and plots
  std::vector<std::pair<std::string, std::variant<double, std::string>>> settings;
  std::string swept;           ///< parameter id; empty: there is none
  bool in_edges = false;       ///< its values below are in mean edges near the drawing
  std::vector<double> values;  ///< of the sweep, from close to smooth
};

/// Whether they differ in the swept parameter only.
bool same_method(const Method& a, const Method& b);

/// In the order of tables and pictures; the first is what the others are compared with.
const std::vector<Method>& known_methods();

/// The default asked for a bound on its deviation: what it does at exactly that of another's run.
const Method& bounded_method();

/// The methods of a list of names and plugin ids, separated by commas; empty: all that are known. A
/// plugin by its id runs with its defaults. Throws Error(kBadUsage) naming what is neither.
std::vector<Method> methods_of(const std::string& list);

}  // namespace talweg::driver
