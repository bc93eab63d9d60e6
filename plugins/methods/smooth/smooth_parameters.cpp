#include "smooth_parameters.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "methods/budget_choice.hpp"
#include "methods/curve_choices.hpp"
#include "methods/deviation_choice.hpp"
#include "methods/ridge_choice.hpp"
#include "talweg/core/smoothing/max_deviation.hpp"
#include "talweg/core/smoothing/slack_field.hpp"

namespace talweg::plugins {
namespace {

using plugin::Parameters;

constexpr const char* kPotentials[] = {"corridor", "paper"};
constexpr const char* kPotentialLabels[] = {"Corridor: flat within the slack",
                                            "The paper's, equations 4 to 6"};
constexpr const char* kFinishes[] = {"fair", "taut"};
constexpr const char* kFinishLabels[] = {"Fair: turns evenly", "Taut: straight, with kinks"};
constexpr const char* kEngines[] = {"auto", "full", "local"};
constexpr const char* kEngineLabels[] = {"Automatic", "Distance over the whole mesh (paper)",
                                         "Distance near the drawing (corridor)"};
constexpr const char* kPoints[] = {"given", "exact", "rough"};
constexpr const char* kPointLabels[] = {"As the drawing says", "Exact: way-points",
                                        "Rough: a stroke"};
constexpr const char* kBorders[] = {"leave", "snap"};
constexpr const char* kBorderLabels[] = {"As drawn", "Extended to the border"};
constexpr const char* kShapes[] = {"power", "exponential"};
constexpr const char* kShapeLabels[] = {"Power", "Exponential"};
constexpr const char* kLengths[] = {"max_distance", "curve_length", "given"};
constexpr const char* kLengthLabels[] = {"Largest distance", "Length of the drawing", "Given"};

constexpr std::uint32_t kCurves = TALWEG_STAGE_CURVES, kRun = TALWEG_STAGE_RUN;
constexpr std::uint32_t kOptional = TALWEG_OPTIONAL, kAdvanced = TALWEG_ADVANCED;

struct OfOnePotential {
  const char* id;
  const char* potential;
  bool field = false;
};
constexpr OfOnePotential kOfOnePotential[] = {
    {"distance", "paper", true},       {"heat_time", "paper"},       {"slack", "corridor"},
    {"slack_field", "corridor", true}, {"taus", "corridor", true},   {"slacks", "corridor", true},
    {"finishes", "corridor", true},    {"max_deviation", "corridor"}};

void require(bool good, const std::string& message) {
  if (!good) throw plugin::Failure(TALWEG_BAD_USAGE, message);
}

void check_together(const Parameters& p) {
  const std::string &potential = p.choice("potential"), &engine = p.choice("engine");
  const bool corridor = potential == "corridor";
  require(!corridor || engine != "full", "The potential corridor needs the engine local.");
  require(corridor || engine != "local", "The potential paper needs the engine full.");
  for (const OfOnePotential& one : kOfOnePotential) {
    const bool given = one.field ? !p.field(one.id).empty() : p.optional(one.id).has_value();
    require(!given || potential == one.potential,
            std::string(one.id) + " needs the potential " + one.potential + ".");
  }
}

std::vector<talweg_parameter> main_parameters() {
  using plugin::array, plugin::boolean, plugin::choice, plugin::integer, plugin::number;
  return {
      number("tau", "Tau", "", 1, {0, HUGE_VAL, 0, 16},
             "0: straight lines; higher values keep closer to the drawing."),
      number(
          "slack", "Slack", "mesh units", 0, {0, HUGE_VAL, 0, 10},
          "How exact the drawing is (corridor). By default the width of the hand's tremor, or 0.7 "
          "of the median segment of a path along edges; at most 1/24 of the length.",
          kRun, kOptional),
      number("max_deviation", "Largest deviation", "mesh units", 0, {0, HUGE_VAL, 0, 10},
             "Finds the smoothest curve that deviates from the drawing by no more than this, "
             "either way; chooses tau and slack (corridor). By default no bound.",
             kRun, kOptional | TALWEG_OPEN_MINIMUM),
      choice("potential", "Potential", "corridor", kPotentials, kPotentialLabels,
             "paper: equations 4 to 6; corridor: flat within the slack, exact distance.", kCurves),
      choice("finish", "Finish", "fair", kFinishes, kFinishLabels,
             "fair: turns evenly, between walls near the drawing; taut: straight with kinks, as "
             "short as it gets (corridor).",
             kRun),
      array(TALWEG_PER_CURVE, "taus", "Tau of each curve", "",
            "A tau for each curve; -1: the value of tau (corridor)."),
      array(TALWEG_PER_CURVE, "slacks", "Slack of each curve", "mesh units",
            "A slack for each curve; -1: the value of slack (corridor)."),
      array(TALWEG_PER_CURVE, "finishes", "Finish of each curve", "",
            "For each curve 0: fair, 1: taut, -1: the value of finish (corridor)."),
      array(TALWEG_FIELD, "slack_field", "Slack field", "mesh units",
            "The slack near each mesh vertex; replaces slack (corridor)."),
      array(TALWEG_VERTICES, "pin", "Pins", "",
            "Vertices of the drawing that the result passes through.", kCurves),
      array(TALWEG_VERTICES, "corner", "Corners", "",
            "Vertices of the drawing that the result passes through and may turn sharply at.",
            kCurves),
      choice("points", "Points", "given", kPoints, kPointLabels,
             "given: by the drawing's marks; exact: way-points, between which the result is free; "
             "rough: a stroke, which the result keeps near.",
             kCurves),
      array(TALWEG_VERTICES, "exact", "Way-points", "",
            "Vertices of the drawing that are meant exactly; replaces points.", kCurves, kAdvanced),
      number("tolerance", "Tolerance", "mesh units", 0, {0, HUGE_VAL, 0, 10},
             "How far from a way-point the result may pass, if the drawing gives no tolerance.",
             kCurves, kAdvanced),
      number("click_distance", "Click distance", "mesh units", 0, {0, HUGE_VAL, 0, 10},
             "Successive way-points at most this far apart are merged into one. By default an edge "
             "of the mesh, and at most a quarter of their median distance; 0: none are merged.",
             kCurves, kOptional | kAdvanced),
      ends_choice(kCurves),
      choice("border", "Ends near the border", "leave", kBorders, kBorderLabels,
             "snap: ends of open strokes that stop within two edges of the mesh's border, or one "
             "and a half steps of the hand, are extended straight to the border; leave: they stay.",
             kCurves, kAdvanced),
      boolean("preview", "Preview", false,
              "For use while a curve is dragged. Only the stretch that differs from the last run "
              "without preview is smoothed and joined to the result of that run (corridor, one "
              "curve changed; else everything is smoothed). The next run without preview gives the "
              "final curve.",
              kRun, kAdvanced),
      integer("relax", "Rounds of relaxation", 0, {0, 1e6, 0, 20},
              "Rounds of relaxation along the supporting edges (the paper: 5)."),
      choice("engine", "Engine", "auto", kEngines, kEngineLabels,
             "full: distance over the whole mesh (paper); local: near the drawing (corridor).",
             kRun, kAdvanced),
      number("heat_time", "Heat time", "squared mean edge lengths", 10, {1e-3, 1e6, 1, 100},
             "Smoothing of the paper's distance. By default 10.", kCurves,
             kOptional | kAdvanced | TALWEG_LOGARITHMIC),
      array(TALWEG_FIELD, "distance", "Distance", "mesh units",
            "Distance to the drawing, used as it is (paper). By default it is computed.", kCurves,
            kAdvanced),
      integer("threads", "Threads", 2, {1, 1024, 1, 16}, "Threads at most; never changes a result.",
              kRun, kAdvanced),
  };
}

std::vector<talweg_parameter> further_parameters() {
  using plugin::boolean, plugin::choice, plugin::integer, plugin::number;
  return {
      boolean("cap_corners", "Cap corners", true,
              "Cut corners of drawings that run along mesh edges first, as the paper does.",
              kCurves, kAdvanced),
      number("bump_radius", "Bump radius", "mesh units", 0, {0, HUGE_VAL, 0, 10},
             "Above 0 the paper's distance is smoothed once more, by equation 3 of the paper.",
             kCurves, kAdvanced),
      choice("potential_shape", "Shape of the potential", "power", kShapes, kShapeLabels,
             "The function f of the paper's potential.", kRun, kAdvanced),
      number("potential_exponent", "Exponent of the potential", "", 2, {1, 16, 1, 4},
             "The exponent, if the potential is a power.", kRun, kAdvanced),
      number("potential_gain", "Gain of the potential", "", 10, {0, HUGE_VAL, 1, 100},
             "The factor a of the paper's potential.", kRun, kAdvanced | TALWEG_OPEN_MINIMUM),
      choice("potential_length", "Length of the potential", "max_distance", kLengths, kLengthLabels,
             "The length that is L in the paper.", kRun, kAdvanced),
      number("given_length", "Given length", "mesh units", 0, {0, HUGE_VAL, 0, 100},
             "L, if potential_length is given; then it must be above 0.", kRun, kAdvanced),
      integer("phase_turns", "Turns of the phase", 3, {0, 64, 0, 8},
              "How often the corridor's phase runs around a loop; at most an eighth of the loop's "
              "points.",
              kRun, kAdvanced),
      integer("max_iterations", "Most iterations", 0, {0, 1e9, 0, 1e6},
              "The most iterations of the straightening; 0: a built-in limit.", kRun, kAdvanced),
      number("min_relative_length", "Least relative length", "", 0, {0, 1, 0, 1},
             "Straightening stops at this fraction of the lifted length; below 1.", kRun,
             kAdvanced),
      number("length_floor", "Least length of a loop", "mesh units", 0, {0, HUGE_VAL, 0, 10},
             "A shorter loop counts as collapsed. By default 3 mean edges of the drawn loop.", kRun,
             kOptional | kAdvanced),
      deviation_choice_by_tau(),
  };
}

PotentialOptions potential_options_of(const Parameters& p) {
  PotentialOptions options;
  options.shape = p.choice("potential_shape") == "power" ? PotentialOptions::Shape::kPower
                                                         : PotentialOptions::Shape::kExponential;
  options.exponent = p.number("potential_exponent");
  options.gain = p.number("potential_gain");
  const std::string& length = p.choice("potential_length");
  options.length = length == "given"          ? PotentialOptions::Length::kGiven
                   : length == "curve_length" ? PotentialOptions::Length::kCurveLength
                                              : PotentialOptions::Length::kMaximumDistance;
  options.given_length = p.number("given_length");
  return options;
}

/// The values of a parameter, one per curve; empty if it is not set. Throws plugin::Failure.
std::vector<double> per_curve(const Parameters& p, const char* id, double most,
                              std::size_t curves) {
  const std::vector<double>& values = p.field(id);
  if (values.empty()) return {};
  const std::string name = fmt::format("{} ({})", smooth_parameter(id).label, id);
  require(values.size() == curves,
          fmt::format("{} has {} values for {} curves.", name, values.size(), curves));
  for (std::size_t c = 0; c < curves; ++c) {
    const double value = values[c];
    require(
        value == -1 || (value >= 0 && value <= most && std::isfinite(value)),
        fmt::format("{} must be -1 or {} for curve {}, not {:g}.", name,
                    std::isfinite(most) ? fmt::format("in [0, {:g}]", most) : ">= 0", c, value));
  }
  return values;
}

/// Converts values per vertex of the host's mesh to values per vertex of the repaired mesh. A wrong
/// number of values is left unchanged, and is refused where the values are used.
std::vector<double> on_mesh(const std::vector<double>& values, const RepairMap* map) {
  const bool fits = map != nullptr && values.size() == map->file_vertex_count();
  return fits ? map->of_vertices(values) : values;
}

/// The options of single curves, one per curve; empty if no curve has options of its own.
std::vector<OwnOptions> own_options_of(const Parameters& p, std::size_t curves) {
  const std::vector<double> taus = per_curve(p, "taus", HUGE_VAL, curves);
  const std::vector<double> slacks = per_curve(p, "slacks", HUGE_VAL, curves);
  const std::vector<double> finishes = per_curve(p, "finishes", 1, curves);
  std::vector<OwnOptions> own;
  if (taus.empty() && slacks.empty() && finishes.empty()) return own;
  own.resize(curves);
  for (std::size_t c = 0; c < curves; ++c) {
    if (!taus.empty() && taus[c] >= 0) own[c].tau = taus[c];
    if (!slacks.empty() && slacks[c] >= 0) own[c].slack = slacks[c];
    if (finishes.empty() || finishes[c] < 0) continue;
    require(finishes[c] == 0 || finishes[c] == 1, "Finish of each curve (finishes) must be whole.");
    own[c].finish = finishes[c] == 0 ? Finish::kFair : Finish::kTaut;
  }
  return own;
}

}  // namespace

const std::vector<talweg_parameter>& smooth_parameters() {
  static const std::vector<talweg_parameter> table = [] {
    std::vector<talweg_parameter> all = main_parameters();
    for (const talweg_parameter& parameter : further_parameters()) all.push_back(parameter);
    for (const talweg_parameter& parameter : ridge_choice(kCurves)) all.push_back(parameter);
    for (const talweg_parameter& parameter : budget_parameters()) all.push_back(parameter);
    return all;
  }();
  return table;
}

const talweg_parameter& smooth_parameter(std::string_view id) {
  const std::vector<talweg_parameter>& table = smooth_parameters();
  const auto found = std::find_if(table.begin(), table.end(),
                                  [&](const talweg_parameter& p) { return id == p.id; });
  assert(found != table.end());
  return *found;
}

std::string potential_of(std::string_view id) {
  for (const OfOnePotential& one : kOfOnePotential) {
    if (id == one.id) return one.potential;
  }
  return {};
}

CurveOptions curve_options_of(const Parameters& p) {
  check_together(p);
  CurveOptions options;
  options.method = p.choice("potential") == "corridor" ? Method::kCorridor : Method::kPaper;
  if (const auto heat_time = p.optional("heat_time")) options.heat_time = *heat_time;
  const double bump = p.number("bump_radius");
  if (bump > 0) options.bump_radius = bump;
  options.click_distance = p.optional("click_distance");
  options.cap_corners = p.flag("cap_corners");
  options.threads = static_cast<unsigned>(p.number("threads"));
  options.distance_at_once = false;  // only run() knows whether the distance is needed
  return options;
}

bool set_curves(CurveSmoother& smoother, std::span<const SurfaceCurve> curves, const Parameters& p,
                const CurveOptions& options, const Progress& progress, const RepairMap* map) {
  if (!go_on(progress, "solve", 0)) return false;
  const std::vector<double> distance = on_mesh(p.field("distance"), map);
  if (distance.empty()) return smoother.set_curves(curves, options, progress);
  return smoother.set_curves(curves, distance, options, progress);
}

SmoothingOptions smoothing_options_of(const Parameters& p, const Surface& surface,
                                      std::span<const SurfaceCurve> drawn, const RepairMap* map) {
  SmoothingOptions options;
  if (const std::vector<double> slack = on_mesh(p.field("slack_field"), map); !slack.empty()) {
    for (const SurfaceCurve& curve : drawn) {
      options.slack_at.push_back(slack_along(surface, curve, slack));
    }
  }
  options.tau = p.number("tau");
  options.per_curve = own_options_of(p, drawn.size());
  options.potential = potential_options_of(p);
  options.slack = p.optional("slack");
  options.phase_turns = static_cast<int>(p.number("phase_turns"));
  options.finish = p.choice("finish") == "fair" ? Finish::kFair : Finish::kTaut;
  options.relax_rounds = static_cast<int>(p.number("relax"));
  const double most = p.number("max_iterations");
  if (most > 0) options.max_iterations = static_cast<std::size_t>(most);
  options.min_relative_length = p.number("min_relative_length");
  options.length_floor = p.optional("length_floor");
  options.deviation = deviation_of(p);
  options.budget = budget_of(p);
  return options;
}

PointMeaning point_meaning(std::string_view choice) {
  if (choice == "exact") return PointMeaning::kExact;
  return choice == "rough" ? PointMeaning::kRough : PointMeaning::kGiven;
}

PointOptions point_options(const Parameters& p, std::vector<SurfacePoint> exact) {
  return {point_meaning(p.choice("points")), std::move(exact), p.number("tolerance")};
}

std::vector<std::string> idle_parameters(const Parameters& p, bool free) {
  std::vector<std::string> given;
  if (p.optional("slack") || !p.field("slacks").empty()) given.emplace_back("slack");
  if (!p.field("slack_field").empty()) given.emplace_back("slack field");
  if (p.optional("max_deviation")) given.emplace_back("largest deviation");
  if (!free || given.empty()) return {};
  return {fmt::format(
      "The {} {} not apply: the drawing has only way-points, between which the result is free.",
      fmt::join(given, " and the "), given.size() == 1 ? "does" : "do")};
}

SmoothingResult smooth_by(const Parameters& p, CurveSmoother& smoother,
                          const SmoothingOptions& options, bool free, const Progress& progress) {
  const std::optional<double> bound = free ? std::nullopt : p.optional("max_deviation");
  return bound ? smooth_within(smoother, *bound, options, progress)
               : smoother.smooth(options, progress);
}

}  // namespace talweg::plugins
