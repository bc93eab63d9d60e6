#include "tools/quality/hand_runs.hpp"

#include <algorithm>
#include <numbers>

#include <fmt/format.h>

#include "talweg/core/drawing/snapping.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/measure/deviation.hpp"
#include "talweg/intrinsic/stopwatch.hpp"
#include "tools/quality/statistics.hpp"
#include "tools/scenes/hands.hpp"

namespace talweg::quality {
namespace {

struct NamedSampling {
  const char* name;
  scenes::Sampling sampling;
};

/// Samplings; the others are compared with the first.
std::vector<NamedSampling> samplings() {
  scenes::Sampling jitter, uneven, rests, doubled, tracker, spikes;
  jitter.step = 0.03;
  jitter.jitter = 0.05;
  uneven.step = 0.2;
  uneven.uneven = 8;
  rests.step = 0.33;
  rests.rests = 4;
  doubled.doubled = true;
  tracker.off = 1;
  tracker.jitter = 0.03;
  spikes.spikes = 4;
  return {{"10 per edge", {}},
          {"1 per edge", {1}},
          {"3 per edge", {0.33}},
          {"33 per edge", {0.03}},
          {"100 per edge", {0.01}},
          {"33 per edge, jitter 0.05", jitter},
          {"0.6 to 40 per edge", uneven},
          {"3 per edge, four rests of 60", rests},
          {"10 per edge, each twice", doubled},
          {"10 per edge, up to 1 off, jitter 0.03", tracker},
          {"10 per edge, four spikes", spikes}};
}

/// The segments of a polyline without those near its ends, where devices cut strokes off
/// differently.
std::vector<Segment> inner_segments(std::span<const Point> points, double near) {
  std::vector<Segment> segments;
  for (const Segment& s : segments_of(points, false)) {
    const auto is_near = [&](const Point& end) {
      return (s.a - end).norm() < near || (s.b - end).norm() < near;
    };
    if (!is_near(points.front()) && !is_near(points.back())) segments.push_back(s);
  }
  return segments;
}

double farthest(std::span<const Point> from, std::span<const Point> to, double near) {
  const std::vector<Segment> inner = inner_segments(from, near);
  if (inner.empty()) return 0;
  return one_sided_deviation(inner, NearestSegment(segments_of(to, false))).max;
}

class HandRuns {
 public:
  HandRuns(const Subject& subject, std::vector<HandRun>& runs)
      : subject_(&subject),
        smoother_(subject.mesh),
        closest_(subject.mesh->mesh()),
        lines_(subject.mesh->surface()),
        runs_(&runs) {}

  void add(std::size_t number, const scenes::HandStroke& stroke) {
    std::vector<Point> reference;
    double bending = 0;
    for (const NamedSampling& named : samplings()) {
      HandRun run;
      run.mesh = subject_->name;
      run.sampling = named.name;
      run.hand = number;
      const std::vector<Point> samples = stroke.sampled(named.sampling);
      run.samples = samples.size();
      const std::vector<Point> result = smoothed(samples, run);
      const double h = edge_, near = 3 * h;
      run.off_way = farthest(result, stroke.way(), near) / h;
      if (reference.empty()) {
        reference = result;
        bending = run.bending;
      }
      run.apart =
          std::max(farthest(result, reference, near), farthest(reference, result, near)) / h;
      run.ratio = std::max(run.bending / bending, bending / run.bending);
      runs_->push_back(run);
    }
  }

 private:
  std::vector<Point> smoothed(const std::vector<Point>& samples, HandRun& run) {
    CurveInput input;
    input.points = samples;
    const SurfaceMesh& mesh = subject_->mesh->mesh();
    const std::vector<SnappedCurve> snapped = snap(mesh, std::span(&input, 1), closest_);
    const SurfaceCurve drawn = lines_.join(snapped.front().points, false);
    const Stopwatch watch;
    smoother_.set_curve(drawn);
    const SmoothingResult result = smoother_.smooth(1.0);
    run.ms = watch.ms();
    const SmoothingReport& report = result.report();
    edge_ = report.edge_length_near;
    run.slack = report.slack / edge_;
    run.bending = report.after.bending;
    run.largest_turn = report.after.max_curvature;
    run.warned = std::ranges::any_of(report.warnings, [](const std::string& warning) {
      return !warning.starts_with("Left out of the drawing");
    });
    return positions_of(mesh, result.curve());
  }

  const Subject* subject_;
  CurveSmoother smoother_;
  std::optional<ClosestPoint> closest_;
  StraightLines lines_;
  std::vector<HandRun>* runs_;
  double edge_ = 0;
};

}  // namespace

std::vector<HandRun> hand_runs(const Subject& subject, std::size_t hands, std::uint64_t seed) {
  constexpr std::uint64_t kApart = 1000;  // of the seeds of two runs
  std::vector<HandRun> runs;
  HandRuns all(subject, runs);
  for (std::size_t k = 0; k < hands; ++k) {
    const scenes::HandStroke stroke(subject.mesh->mesh(), {}, kApart * seed + k);
    if (stroke.is_drawn()) all.add(k, stroke);
  }
  return runs;
}

std::string tables(std::span<const HandRun> runs) {
  std::string text =
      "| samples | strokes | slack, median [h₀] | bending, median | worst | largest turn at one "
      "point [°] | off the way, median [h₀] | worst | distance from 10 per edge, median [h₀] | "
      "worst | bending, larger / smaller, median | worst | ms, median | worst |\n"
      "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const NamedSampling& named : samplings()) {
    std::vector<double> slack, bending, turn, off, apart, ratio, ms;
    for (const HandRun& run : runs) {
      if (run.sampling != named.name) continue;
      slack.push_back(run.slack);
      bending.push_back(run.bending);
      turn.push_back(run.largest_turn * 180 / std::numbers::pi);
      off.push_back(run.off_way);
      apart.push_back(run.apart);
      ratio.push_back(run.ratio);
      ms.push_back(run.ms);
    }
    if (slack.empty()) continue;
    const auto both = [](const std::vector<double>& values) {
      return fmt::format("{:.2f} | {:.2f}", quantile(values, 0.5), quantile(values, 1));
    };
    text += fmt::format("| {} | {} | {:.2f} | {} | {:.0f} | {} | {} | {} | {:.0f} | {:.0f} |\n",
                        named.name, slack.size(), quantile(slack, 0.5), both(bending),
                        quantile(turn, 1), both(off), both(apart), both(ratio), quantile(ms, 0.5),
                        quantile(ms, 1));
  }
  return text;
}

std::string csv(std::span<const HandRun> runs) {
  std::string text =
      "mesh,hand,sampling,samples,slack,bending,largest_turn,off_way,apart,ratio,ms,warned\n";
  for (const HandRun& r : runs) {
    text += fmt::format("{},{},\"{}\",{},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.2f},{}\n",
                        r.mesh, r.hand, r.sampling, r.samples, r.slack, r.bending, r.largest_turn,
                        r.off_way, r.apart, r.ratio, r.ms, r.warned ? 1 : 0);
  }
  return text;
}

}  // namespace talweg::quality
