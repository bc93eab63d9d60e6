#include "stress/random_run.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <memory>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "stress/budgeted_curves.hpp"
#include "stress/capped_pieces.hpp"
#include "stress/planted_defects.hpp"
#include "stress/random_curves.hpp"
#include "stress/random_labels.hpp"
#include "stress/redrawn_curves.hpp"
#include "talweg/core/drawing/snapping.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/measure/edge_length_near.hpp"
#include "talweg/core/repair/mesh_repair.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"
#include "talweg/core/smoothing/max_deviation.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"

namespace talweg::stress {
namespace {

using End = RunOutcome::End;

/// FNV-1a.
struct Hash {
  std::uint64_t value = 0xCBF29CE484222325U;
  void add(const void* data, std::size_t size) {
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < size; ++i) value = (value ^ bytes[i]) * 0x100000001B3U;
  }
  void add(const std::string& text) { add(text.data(), text.size()); }
};

/// Whether an error names a place: by a number, or by words for the whole mesh.
bool names_the_place(const std::string& sentence) {
  const bool number = std::any_of(sentence.begin(), sentence.end(),
                                  [](unsigned char c) { return std::isdigit(c) != 0; });
  const auto has = [&](const char* words) { return sentence.find(words) != std::string::npos; };
  return number || has("no vertices") || has("no faces") || has("one-sided") || has("one side");
}

std::shared_ptr<const OpenedMesh> open_or_repair(MeshLists lists, RunOutcome& outcome) {
  const MeshInspection found = inspect(lists);
  try {
    auto opened = OpenedMesh::open(lists);
    if (found.verdict != MeshVerdict::kUsable) outcome.broken = "opened, but not called usable";
    return opened;
  } catch (const Error& error) {
    outcome.refusal = error.what();
    if (found.verdict == MeshVerdict::kUsable) outcome.broken = "called usable, but not opened";
  }
  if (!names_the_place(outcome.refusal)) outcome.broken = "refused without a place";
  try {
    auto opened = OpenedMesh::open(repair(lists).lists);
    outcome.refusal.clear();
    // Dropping flat faces may split a one-sided surface into two-sided ones, and some of many flat
    // faces may stay.
    if (found.verdict != MeshVerdict::kRepairable &&
        found.reason.find("one-sided") == std::string::npos &&
        found.reason.find("All faces have zero area") == std::string::npos) {
      outcome.broken = "repaired, but not called repairable: " + found.reason;
    }
    return opened;
  } catch (const Error& error) {
    outcome.refusal = error.what();
    if (!names_the_place(outcome.refusal)) outcome.broken = "refused without a place";
    // A surface may turn out one-sided only after its other defects are repaired.
    const bool one_sided = outcome.refusal.find("opposite orientation") != std::string::npos;
    if (found.verdict == MeshVerdict::kRepairable && !one_sided) {
      outcome.broken = "called repairable, but not repaired: " + found.reason;
    }
    return nullptr;
  }
}

void check_curve(const SurfaceMesh& mesh, const SurfaceCurve& drawn, const SurfaceCurve& result,
                 bool may_lack_ends, RunOutcome& outcome) {
  const Surface& surface = mesh.surface();
  const std::size_t n = result.points.size();
  if (result.closed != drawn.closed) outcome.broken = "open and closed mixed up";
  if (n < (drawn.closed ? 1U : 2U)) {
    outcome.broken = "hardly any points";
    return;
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (!mesh.position(result.points[i]).allFinite()) outcome.broken = "a position is not finite";
    if (i + 1 == n && !result.closed) break;
    if (!common_face(surface, result.points[i], result.points[(i + 1) % n]).valid()) {
      outcome.broken = fmt::format("points {} and {} share no face", i, (i + 1) % n);
    }
  }
  if (result.closed || may_lack_ends) return;
  // A point within rounding of a vertex is that vertex. The distance is measured inside the face,
  // because positions far from the origin have a larger rounding.
  const auto moved = [&](const SurfacePoint& from, const SurfacePoint& to) {
    const FaceId face = common_face(surface, from, to);
    if (!face.valid()) return true;
    double side = 0;
    for (HalfedgeId h = surface.halfedge(face), end = h;;) {
      side = std::max(side, surface.length(edge_of(h)));
      if ((h = surface.next(h)) == end) break;
    }
    return distance_in_face(surface, coordinates_in(surface, from, face),
                            coordinates_in(surface, to, face)) > 1e-9 * side;
  };
  if (moved(drawn.points.front(), result.points.front()) ||
      moved(drawn.points.back(), result.points.back())) {
    outcome.broken = "an end has moved";
  }
}

void check_report(const SmoothingReport& report, RunOutcome& outcome) {
  for (const ReportEntry& entry : entries_of(report)) {
    const double* number = std::get_if<double>(&entry.value);
    if (number == nullptr) continue;
    const bool may_be_infinite = entry.key.starts_with("deviation") ||
                                 entry.key.starts_with("farthest") || entry.key == "moved" ||
                                 entry.key.starts_with("tortuosity") ||
                                 entry.key == "max_deviation" || entry.key == "roughness_near";
    if (std::isnan(*number) || (std::isinf(*number) && !may_be_infinite)) {
      outcome.broken = fmt::format("{} is {}", entry.key, *number);
    }
  }
  if (!(report.lifted_length_after <= report.lifted_length_before * (1 + 1e-9))) {
    outcome.broken = fmt::format("lifted length rose from {:.17g} to {:.17g}",
                                 report.lifted_length_before, report.lifted_length_after);
  }
}

bool warns(const SmoothingResult& result, const std::string& words) {
  return std::ranges::any_of(result.total.warnings, [&](const std::string& warning) {
    return warning.find(words) != std::string::npos;
  });
}

/// The largest distance between clicks that are merged, mesh units.
double largest_click_distance(const CurveSmoother& smoother) {
  double most = 0;
  for (const SurfaceCurve& curve : smoother.drawn()) {
    most = std::max(most, edge_length_near(smoother.opened().mesh().surface(), curve));
  }
  return 1.05 * most;
}

/// Checks that the result passes all clicks, or a warning names the clicks that it misses.
void check_way_points(const CurveSmoother& smoother, const SmoothingResult& result,
                      RunOutcome& outcome) {
  const auto& way_points = smoother.curve_options().way_points;
  if (way_points.empty() || warns(result, "it should pass") || !outcome.broken.empty()) return;
  const double one = warns(result, "merged with that point") ? largest_click_distance(smoother) : 0;
  const SurfaceMesh& mesh = smoother.opened().mesh();
  PolylineDistance distance(mesh.surface());
  distance.set(result.curves);
  for (const WayPoint& way : way_points) {
    const double away = distance.at(way.point).distance;
    if (away <= std::max(way.tolerance, one) + 1e-6 * mesh.mean_edge_length()) continue;
    outcome.broken = fmt::format("a way-point is {:.3g} edges away from the result",
                                 away / mesh.mean_edge_length());
    return;
  }
}

void allow(double smoothings, std::size_t faces, std::size_t points, RunOutcome& outcome) {
  outcome.most_seconds +=
      smoothings * 10 * (static_cast<double>(faces) / 100'000 + static_cast<double>(points) / 1000);
}

void check(const CurveSmoother& smoother, const SmoothingResult& result, RunOutcome& outcome,
           Hash& hash, double smoothings = 1) {
  const SurfaceMesh& mesh = smoother.opened().mesh();
  const SmoothingReport& total = result.total;
  outcome.work += smoothings * static_cast<double>(total.faces + total.faces_touched + total.flips +
                                                   total.points_before + total.points_after);
  allow(smoothings, total.faces, total.points_before, outcome);
  if (result.curves.size() != smoother.drawn().size()) outcome.broken = "curves are missing";
  for (std::size_t c = 0; c < result.curves.size() && outcome.broken.empty(); ++c) {
    check_curve(mesh, smoother.drawn()[c], result.curves[c], result.reports[c].left_out > 0,
                outcome);
    check_report(result.reports[c], outcome);
    for (const Point& p : positions_of(mesh, result.curves[c])) hash.add(p.data(), sizeof(Point));
    SmoothingReport report = result.reports[c];
    report.time_ms = {};
    report.peak_memory_mib = 0;
    hash.add(to_json(report));
  }
  check_way_points(smoother, result, outcome);
}

SmoothingOptions random_options(const SurfaceMesh& mesh, Random& random, std::string& what) {
  SmoothingOptions options;
  options.tau = random.one_in(8) ? 0 : random.scale(1e-3, 1e3);
  if (random.one_in(30)) options.tau = random.scale(1e3, 1e12);
  if (random.one_in(4)) options.slack = random.scale(1e-6, 30) * mesh.mean_edge_length();
  if (random.one_in(20)) options.slack = 0;
  if (random.one_in(6)) options.phase_turns = static_cast<int>(random.below(65));
  if (random.one_in(8)) options.finish = Finish::kTaut;
  if (random.one_in(6)) options.relax_rounds = static_cast<int>(1 + random.below(8));
  if (random.one_in(12)) options.max_iterations = 1 + random.below(50);
  if (random.one_in(12)) options.min_relative_length = random.unit();
  if (random.one_in(12)) options.length_floor = random.scale(1e-3, 100) * mesh.mean_edge_length();
  if (random.one_in(4)) options.deviation = DeviationMeasure::kNone;
  what += fmt::format("tau {:.3g} slack {:.3g} turns {} taut {} relax {}", options.tau,
                      options.slack.value_or(-1), options.phase_turns,
                      options.finish == Finish::kTaut, options.relax_rounds);
  return options;
}

/// Cuts along the result and caps the pieces.
void cap(const SurfaceMesh& mesh, const SmoothingResult& result, Random& random,
         RunOutcome& outcome) {
  allow(1, result.total.faces, result.total.points_after, outcome);
  try {
    const CappedPieces capped = cap_pieces(mesh, result.curves, random);
    outcome.broken = capped.broken;
    outcome.pieces = capped.pieces;
    outcome.lids = capped.lids;
    outcome.lids_refused = capped.refused;
  } catch (const Error& error) {
    outcome.broken = std::string("cutting along the result says: ") + error.what();
  }
}

/// Marks some points of a drawing as clicks, with or without a tolerance, and some as painted.
void mark_some(const SurfaceMesh& mesh, const SnappedCurve& snapped, Random& random,
               CurveOptions& curve_options) {
  for (const SurfacePoint& point : snapped.points) {
    if (random.one_in(2)) {
      const double tolerance = random.one_in(4) ? random.unit() * mesh.mean_edge_length() : 0;
      curve_options.way_points.push_back({point, tolerance});
    } else if (random.one_in(8)) {
      curve_options.painted.push_back(point);
    }
  }
}

/// Random numbers for other choices, on which the drawing does not depend.
struct OtherChoices {
  Random clicks, budgets, labels;
};

void smooth_random(const std::shared_ptr<const OpenedMesh>& opened, Random& random,
                   OtherChoices& others, unsigned threads, RunOutcome& outcome) {
  const SurfaceMesh& mesh = opened->mesh();
  const RandomDrawing drawing = random_drawing(mesh, random);
  outcome.what += " | " + drawing.kind + "| ";
  CurveOptions curve_options;
  curve_options.threads = threads;
  curve_options.method = random.one_in(3) ? Method::kPaper : Method::kCorridor;
  if (random.one_in(6)) curve_options.heat_time = random.scale(1e-3, 1e6);
  if (random.one_in(20)) curve_options.bump_radius = random.scale(0.1, 5) * mesh.mean_edge_length();
  curve_options.cap_corners = !random.one_in(4);
  if (curve_options.method == Method::kPaper) outcome.what += "paper ";
  const bool clicked = curve_options.method == Method::kCorridor && others.clicks.one_in(4);
  if (clicked) outcome.what += "clicks ";
  const SmoothingOptions options = random_options(mesh, random, outcome.what);

  CurveSmoother smoother(opened);
  try {
    StraightLines lines(mesh.surface());
    std::vector<SurfaceCurve> curves;
    for (const SnappedCurve& snapped : snap(mesh, drawing.curves, {drawing.connect})) {
      for (const std::size_t pin : snapped.pins) {
        curve_options.pins.push_back(snapped.points[pin]);
      }
      curves.push_back(lines.join(snapped.points, snapped.closed));
      if (clicked) mark_some(mesh, snapped, others.clicks, curve_options);
    }
    smoother.set_curves(curves, curve_options);
  } catch (const Error& error) {
    outcome.end = End::kCurveRefused;
    outcome.refusal = error.what();
    if (!names_the_place(outcome.refusal)) outcome.broken = "refused without a place";
    return;
  }
  Hash hash;
  const SmoothingResult result = smoother.smooth(options);
  check(smoother, result, outcome, hash);
  SmoothingOptions moved = options;
  moved.tau *= random.scale(0.2, 5);
  check(smoother, smoother.smooth(moved), outcome, hash);
  if (curve_options.method == Method::kCorridor && random.one_in(12) && outcome.broken.empty()) {
    const double bound = random.scale(0.1, 30) * mesh.mean_edge_length();
    outcome.what += fmt::format(" within {:.3g}", bound);
    check(smoother, smooth_within(smoother, bound, options), outcome, hash, RunOutcome::kSearch);
  }
  if (outcome.broken.empty() && random.one_in(4)) cap(mesh, result, random, outcome);
  outcome.bytes = hash.value;
  const std::size_t points = result.total.points_before;
  const bool corridor = curve_options.method == Method::kCorridor;
  const auto any_bound = [&](Random& from) {
    return corridor && from.one_in(2) ? from.scale(0.1, 30) * mesh.mean_edge_length() : 0;
  };
  if (outcome.broken.empty() && random.one_in(3)) {
    const double bound = any_bound(random);
    if (bound > 0) outcome.what += fmt::format(" redrawn within {:.3g}", bound);
    outcome.broken = differs_when_redrawn(smoother, curve_options, options, bound, random);
    const double smoothings = bound > 0 ? 2 * RunOutcome::kSearch : 2;
    outcome.work += smoothings * static_cast<double>(mesh.surface().face_count());
    allow(smoothings, mesh.surface().face_count(), points, outcome);
  }
  if (outcome.broken.empty() && others.budgets.one_in(5)) {
    outcome.had_budget = true;
    const double bound = others.budgets.one_in(3) ? any_bound(others.budgets) : 0;
    outcome.what += fmt::format(" budget within {:.3g}", bound);
    outcome.broken = breaks_its_budget(smoother, options, bound, others.budgets);
    const double smoothings = bound > 0 ? 4 * RunOutcome::kSearch : 4;
    outcome.work += smoothings * static_cast<double>(mesh.surface().face_count());
    allow(smoothings, mesh.surface().face_count(), points, outcome);
  }
}

void smooth_labels_too(const std::shared_ptr<const OpenedMesh>& opened, Random& random,
                       RunOutcome& outcome) {
  const LabelRun run = random_label_run(opened, random);
  constexpr double kSmoothings = 8;  // up to four attempts, each with a cut
  const std::size_t faces = opened->surface().face_count();
  outcome.what += " | labels " + run.what;
  outcome.broken = run.broken;
  outcome.borders = run.borders;
  outcome.work += kSmoothings * static_cast<double>(faces + run.points);
  allow(kSmoothings, faces, run.points, outcome);
  Hash hash{outcome.bytes};
  hash.add(run.cut_labels.data(), run.cut_labels.size() * sizeof(std::int64_t));
  outcome.bytes = hash.value;
}

}  // namespace

RunOutcome random_run(std::uint64_t seed, unsigned threads) {
  Random random(seed * 0x2545F4914F6CDD1DU + 1);
  RunOutcome outcome;
  MeshLists lists = random_mesh(random);
  outcome.what = plant_some(lists, random);
  outcome.what += fmt::format(" ({} faces)", lists.triangles.size());
  const auto opened = open_or_repair(std::move(lists), outcome);
  if (opened == nullptr) {
    outcome.end = End::kMeshRefused;
  } else if (outcome.broken.empty()) {
    OtherChoices others{Random(seed * 0xD1B54A32D192ED03U + 1),
                        Random(seed * 0xA0761D6478BD642FU + 1),
                        Random(seed * 0xE7037ED1A0B428DBU + 1)};
    smooth_random(opened, random, others, threads, outcome);
    if (outcome.broken.empty() && others.labels.one_in(4)) {
      smooth_labels_too(opened, others.labels, outcome);
    }
  }
  return outcome;
}

}  // namespace talweg::stress
