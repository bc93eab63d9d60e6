// Plugin options are a plugin's parameters on the command line, made from their descriptions.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "talweg/plugin/talweg_host.hpp"

namespace talweg::driver {

class PluginOptions {
 public:
  /// Adds one option per parameter ("max_deviation": --max-deviation), except for the parameters of
  /// mesh repair, see set_repair(). The object must outlive the app's parsing.
  PluginOptions(CLI::App& app, const talweg_plugin& plugin);

  /// Sets the parameters that were given. Throws Error(kBadFile) for files of fields, host::Error.
  void apply(host::Instance& instance) const;
  /// Pairs of an option that was given a file of a field, and the file's name.
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> files() const;
  /// Whether the plugin repairs meshes itself.
  [[nodiscard]] bool repairs() const { return repairs_; }

 private:
  struct Value {
    const talweg_parameter* parameter = nullptr;
    CLI::Option* option = nullptr;
    double number = 0;
    bool flag = false;
    std::string text;  ///< a choice, or a file
    std::vector<std::uint32_t> vertices;
    std::vector<double> numbers;
  };
  static void add(CLI::App& app, Value& value);

  std::vector<std::unique_ptr<Value>> values_;  // CLI11 keeps their addresses
  bool repairs_ = false;
};

bool has_parameter(const talweg_plugin& plugin, std::string_view id);
/// Sets a plugin's repair parameters to the steps of --repair; does nothing for an empty list.
void set_repair(host::Instance& instance, const std::string& list);

/// The option's name: "--max-deviation" for "max_deviation".
std::string option_name(const std::string& id);
/// The help text of a parameter's option.
std::string option_text(const talweg_parameter& parameter);
/// Adds an option that takes one of a parameter's choices.
CLI::Option* add_choice(CLI::App& app, const talweg_parameter& parameter, std::string& value);

}  // namespace talweg::driver
