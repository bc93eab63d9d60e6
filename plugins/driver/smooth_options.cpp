#include "smooth_options.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "plugin_options.hpp"
#include "repaired_mesh.hpp"
#include "talweg/core/io/curve_file.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::driver {
namespace {

/// Adds an option for a parameter of talweg.smooth, with its name and help text.
template <class Value>
CLI::Option* add(CLI::App& app, const char* id, Value& value) {
  return app.add_option(option_name(id), value, option_text(plugins::smooth_parameter(id)));
}

void add_inputs(CLI::App& app, SmoothOptions& o) {
  CLI::Option* curve =
      app.add_option("--curve", o.curves,
                     "Drawn curves: .obj, .ply, .vtp, .vtk, .mrk.json, .border, .fcsv, "
                     ".txt (vertex numbers) or .json; may be given several times");
  app.add_option("--labels", o.labels,
                 "Instead of curves: the borders between the labels of this file, one whole number "
                 "per face or per vertex")
      ->excludes(curve);
  app.add_flag("--independent", o.independent,
               "Smooth each curve by itself; by default all curves are one set, in which none "
               "crosses another");
  add(app, "pin", o.pins)->delimiter(',');
  add(app, "corner", o.corners)->delimiter(',');
  app.add_option("--points", o.points,
                 "The kind of the drawing's points. given: as the files mark them; exact: "
                 "way-points, between which the result is free; rough: strokes; exact=12,845: "
                 "these vertices are the way-points")
      ->capture_default_str();
  add(app, "tolerance", o.tolerance)->capture_default_str();
  add(app, "click_distance", o.click_distance);
  add_choice(app, plugins::smooth_parameter("ends"), o.ends);
  app.add_flag_callback(
      "--closed", [&o] { o.ends = "closed"; }, "The same as --ends closed");
  app.add_flag_callback(
      "--open", [&o] { o.ends = "open"; }, "The same as --ends open");
  add_choice(app, plugins::smooth_parameter("border"), o.border);
  add_ridge_options(app, o.ridges);
  add_repair_option(app, o.repair);
  add_unit_option(app, o.mesh_units);
}

void add_outputs(CLI::App& app, SmoothOptions& o) {
  app.add_option("-o,--output", o.outputs,
                 "Smoothed curves; the ending chooses the format; may be given several times");
  add_point_options(app, o.written);
  app.add_option("--report", o.report, "Steps and measures, as JSON");
}

/// Adds an option with one value for all curves, or one value per curve.
template <class Value>
CLI::Option* add_list(CLI::App& app, const char* id, std::vector<Value>& values) {
  return app
      .add_option(option_name(id), values,
                  option_text(plugins::smooth_parameter(id)) +
                      " One for all curves, or one for each: \"a,b,c\"")
      ->delimiter(',')
      ->allow_extra_args(false);
}

/// Checks a slack and replaces "auto" by -1, as a transformation of CLI11: returns an error or "".
std::string slack_or_auto(std::string& text) {
  if (text.starts_with('-')) return "A slack must be 0 or more, or auto, not " + text;
  if (text == "auto") text = "-1";
  return {};
}

void add_closeness(CLI::App& app, SmoothOptions& o) {
  add_list(app, "tau", o.tau)->default_str("1");
  add_list(app, "slack", o.slack)->transform(CLI::Validator(slack_or_auto, ""));
  add(app, "slack_field", o.slack_field);
  add(app, "max_deviation", o.max_deviation)->excludes("--tau");
}

void add_method(CLI::App& app, SmoothOptions& o) {
  add_choice(app, plugins::smooth_parameter("potential"), o.potential);
  const talweg_parameter& finish = plugins::smooth_parameter("finish");
  add_list(app, "finish", o.finish)
      ->check(CLI::IsMember(
          std::vector<std::string>(finish.choices, finish.choices + finish.choice_count)))
      ->default_str(finish.default_choice);
  add_choice(app, plugins::smooth_parameter("engine"), o.engine);
  add(app, "heat_time", o.heat_time)->default_str("10");
  add(app, "distance", o.distance);
  add(app, "relax", o.relax)->capture_default_str();
  add(app, "budget", o.budget);
  add(app, "budget_work", o.budget_work)->type_name("INT");
  app.add_option("--repeat", o.repeat, "Run this many times and report median times")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
}

}  // namespace

void add_smooth_options(CLI::App& app, SmoothOptions& options) {
  add_inputs(app, options);
  add_closeness(app, options);
  add_outputs(app, options);
  add_method(app, options);
}

void plan_files(const SmoothOptions& options, FilePlan& files) {
  files.reads("the mesh", options.mesh);
  files.reads("--curve", options.curves);
  files.reads("--labels", options.labels);
  files.reads("--distance", options.distance);
  files.reads("--slack-field", options.slack_field);
  files.writes("-o", options.outputs, check_curve_name);
  files.writes("--report", options.report);
}

PointsChoice points_choice(const SmoothOptions& options) {
  constexpr std::string_view kList = "exact=";
  const std::string& points = options.points;
  const auto fail = [&] {
    throw Error(ErrorCode::kBadUsage,
                "--points must be given, exact, rough, or exact= and vertex numbers separated by "
                "commas, not \"" +
                    points + "\".");
  };
  if (points == "given" || points == "exact" || points == "rough") return {points, {}};
  if (!points.starts_with(kList)) fail();
  PointsChoice choice{"given", {}};
  const char* at = points.data() + kList.size();
  const char* const end = points.data() + points.size();
  for (;; ++at) {
    std::uint32_t vertex = 0;
    const auto parsed = std::from_chars(at, end, vertex);
    if (parsed.ec != std::errc{}) fail();
    choice.exact.push_back(vertex);
    at = parsed.ptr;
    if (at == end) return choice;
    if (*at != ',') fail();
  }
}

namespace {

/// Keeps the value of one curve, unless the value is for all curves.
template <class Value>
void keep_only(std::vector<Value>& values, std::size_t curve) {
  if (values.size() > 1) values = {values[curve]};
}

}  // namespace

SmoothOptions options_of_curve(const SmoothOptions& options, std::size_t curve) {
  SmoothOptions own = options;
  keep_only(own.tau, curve);
  keep_only(own.slack, curve);
  keep_only(own.finish, curve);
  return own;
}

void check_lists(const SmoothOptions& options, std::size_t curves) {
  const auto check = [curves](const char* name, std::size_t values) {
    if (values <= 1 || values == curves) return;
    throw Error(
        ErrorCode::kBadUsage,
        fmt::format("{} has {} values, but the drawing has {} curve{}: give one, or one for each "
                    "curve.",
                    name, values, curves, curves == 1 ? "" : "s"));
  };
  check("--tau", options.tau.size());
  check("--slack", options.slack.size());
  check("--finish", options.finish.size());
}

void check_method(const SmoothOptions& options) {
  check_repair(options.repair);
  check_unit(options.mesh_units);
  check_points(options.written);
  points_choice(options);
  const bool corridor = options.potential == "corridor";
  const auto fail = [](const std::string& text) { throw Error(ErrorCode::kBadUsage, text); };
  if (corridor && options.engine == "full") fail("The corridor needs --engine local.");
  if (!corridor && options.engine == "local") fail("The paper's potential needs --engine full.");
  if (!options.labels.empty() && points_choice(options).points == "exact") {
    fail("--points exact is for curves; the borders of --labels are strokes.");
  }
  if (!(options.tolerance >= 0 && std::isfinite(options.tolerance))) {
    fail("--tolerance must be 0 or more.");
  }
  const auto is_fair = [](const std::string& finish) { return finish == "fair"; };
  if (!corridor && !std::ranges::all_of(options.finish, is_fair)) {
    fail("--finish needs --potential corridor.");
  }
  if (!corridor && options.tau.size() > 1) {
    fail("--tau for each curve needs --potential corridor.");
  }
  const auto check_potential = [&](const char* id, bool given) {
    const std::string its_own = plugins::potential_of(id);
    if (given && its_own != options.potential) {
      fail(option_name(id) + " needs --potential " + its_own + ".");
    }
  };
  check_potential("distance", !options.distance.empty());
  check_potential("heat_time", options.heat_time.has_value());
  check_potential("slack", !options.slack.empty());
  check_potential("slack_field", !options.slack_field.empty());
  check_potential("max_deviation", options.max_deviation.has_value());
}

}  // namespace talweg::driver
