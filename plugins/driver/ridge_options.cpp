#include "ridge_options.hpp"

#include "methods/smooth/smooth_parameters.hpp"
#include "plugin_options.hpp"

namespace talweg::driver {

void add_ridge_options(CLI::App& app, RidgeChoice& choice) {
  const auto add = [&](const char* id, auto& value) {
    return app.add_option(option_name(id), value, option_text(plugins::smooth_parameter(id)));
  };
  add("ridges", choice.strength)->check(CLI::Range(0.0, 1.0))->capture_default_str();
  add_choice(app, plugins::smooth_parameter("ridge_kind"), choice.kind);
  add("ridge_band", choice.band);
}

}  // namespace talweg::driver
