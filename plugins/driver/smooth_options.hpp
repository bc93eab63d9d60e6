// The options of `talweg smooth`, for one run or one line of a list.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "file_plan.hpp"
#include "methods/smooth/smooth_parameters.hpp"
#include "ridge_options.hpp"
#include "written_points.hpp"

namespace talweg::driver {

struct SmoothOptions {
  std::string mesh;
  std::string repair;               ///< steps; empty for none
  std::vector<std::string> curves;  ///< files
  std::string labels;               ///< a file of labels whose borders are the curves
  std::string mesh_units;           ///< the unit of the mesh; empty: the unit of its file
  bool independent = false;         ///< smooth each curve separately instead of all as one set
  std::vector<std::string> outputs;
  WrittenPoints written;  ///< the points of outputs
  std::string report;
  std::string potential = plugins::smooth_parameter("potential").default_choice;
  std::string engine = plugins::smooth_parameter("engine").default_choice;
  std::string distance;
  std::string slack_field;
  std::optional<double> max_deviation;
  std::optional<double> heat_time;
  std::vector<std::size_t> pins, corners;
  std::string points = "given";  ///< given, exact or rough; or "exact=" and vertices
  double tolerance = 0;
  std::optional<double> click_distance;
  std::string ends = plugins::smooth_parameter("ends").default_choice;
  std::string border = plugins::smooth_parameter("border").default_choice;
  RidgeChoice ridges;
  std::size_t repeat = 1;
  // One value for all curves, or one value per curve.
  std::vector<double> tau = {plugins::smooth_parameter("tau").default_number};
  std::vector<double> slack;  ///< empty: the default; -1: the default for this curve
  std::vector<std::string> finish = {"fair"};
  int relax = 0;
  std::optional<double> budget;       ///< s
  std::optional<double> budget_work;  ///< counted steps
  unsigned threads = 2;
};

/// Adds all options but the mesh. `options` must outlive the app; its values are the defaults.
void add_smooth_options(CLI::App& app, SmoothOptions& options);

/// Registers the files that a run reads and writes.
void plan_files(const SmoothOptions& options, FilePlan& files);

/// The parts of `points`: the choice, and the vertices after "exact=". Throws Error(kBadUsage) for
/// other texts.
struct PointsChoice {
  std::string points;
  std::vector<std::size_t> exact;
};
PointsChoice points_choice(const SmoothOptions& options);

/// Options for smoothing curve `curve` alone: lists with one value per curve are cut down to its
/// value.
SmoothOptions options_of_curve(const SmoothOptions& options, std::size_t curve);

/// Throws Error(kBadUsage) where a list has neither one value nor one per curve.
void check_lists(const SmoothOptions& options, std::size_t curves);

/// Throws Error(kBadUsage) if options contradict each other.
void check_method(const SmoothOptions& options);

}  // namespace talweg::driver
