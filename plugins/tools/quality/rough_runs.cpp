#include "tools/quality/rough_runs.hpp"

#include <algorithm>
#include <array>
#include <random>

#include <fmt/format.h>

#include "talweg/core/drawing/draw.hpp"
#include "talweg/core/measure/deviation.hpp"
#include "talweg/core/measure/edge_length_near.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/intrinsic/stopwatch.hpp"
#include "tools/quality/statistics.hpp"

namespace talweg::quality {
namespace {

constexpr std::array kRoughness{0.1, 0.3, 0.5, 1.0};
constexpr std::size_t kApart = 25;       // vertices of a drawing between clicks
constexpr double kNearlyStraight = 0.1;  // a straight curve has no ratio
constexpr double kSamples = 4;  // h₀: distance of samples on such legs, a sixth of their length

/// Each vertex moved along the normal of the faces around it.
std::shared_ptr<const OpenedMesh> roughened(const Subject& subject, double deviation) {
  MeshLists lists = subject.lists;
  std::vector<Point> normals(lists.points.size(), Point::Zero());
  for (const Triangle& t : lists.triangles) {
    const Point& a = lists.points[t[0]];
    const Point normal = (lists.points[t[1]] - a).cross(lists.points[t[2]] - a);
    for (const std::uint32_t corner : t) normals[corner] += normal;
  }
  std::mt19937 random(1);
  std::normal_distribution<double> deviate(0, deviation);
  for (std::size_t v = 0; v < lists.points.size(); ++v) {
    lists.points[v] += deviate(random) * normals[v].normalized();
  }
  return OpenedMesh::open(std::move(lists));
}

struct Made {
  SurfaceCurve curve, legs;
  SmoothingReport report;
  double ms = 0;
};

Made through(const std::shared_ptr<const OpenedMesh>& mesh, std::span<const VertexId> clicks,
             bool closed) {
  Made made;
  CurveSmoother smoother(mesh);
  DrawOptions how;
  how.closed = closed;
  const Drawing drawing = draw(mesh->surface(), clicks, how);
  SmoothingOptions options;
  options.deviation = DeviationMeasure::kNone;
  smoother.set_curve(drawing);
  smoother.smooth(options);  // computes data that later runs reuse
  const Stopwatch watch;
  smoother.set_curve(drawing);
  const SmoothingResult result = smoother.smooth(options);
  made.ms = watch.ms();
  made.curve = result.curve();
  made.report = result.report();
  options.tau = 0;
  made.legs = smoother.smooth(options).curve();
  return made;
}

double apart(const SurfaceMesh& mesh, const SurfaceCurve& a, const SurfaceCurve& b) {
  const Deviation both =
      deviation(positions_of(mesh, a), a.closed, positions_of(mesh, b), b.closed);
  return std::max(both.to_drawn.max, both.from_drawn.max);
}

}  // namespace

std::vector<RoughRun> rough_runs(const Subject& subject, std::span<const NamedPath> drawings) {
  std::vector<RoughRun> runs;
  const SurfaceMesh& mesh = subject.mesh->mesh();
  for (const double roughness : kRoughness) {
    const auto rough = roughened(subject, roughness * mesh.mean_edge_length());
    for (const NamedPath& drawing : drawings) {
      std::vector<VertexId> clicks;
      for (std::size_t k = 0; k < drawing.path.size(); k += kApart) {
        clicks.push_back(drawing.path[k]);
      }
      if (clicks.size() < 4) continue;
      const Made smooth = through(subject.mesh, clicks, drawing.closed);
      const Made made = through(rough, clicks, drawing.closed);
      const double edge = edge_length_near(mesh.surface(), smooth.curve);
      const auto bending = [&](const SurfaceCurve& curve) {
        return measure_curve(mesh.surface(), curve, kSamples * edge).bending;
      };
      RoughRun run{subject.name, drawing.name, roughness};
      run.told = made.report.roughness_near;
      run.bending = bending(made.curve) / std::max(bending(smooth.curve), kNearlyStraight);
      run.swing = apart(mesh, made.curve, smooth.legs) / apart(mesh, smooth.curve, smooth.legs);
      run.apart = apart(mesh, made.curve, smooth.curve) / edge;
      run.time = made.ms / smooth.ms;
      run.warned = !made.report.warnings.empty();
      runs.push_back(run);
    }
  }
  return runs;
}

std::string tables(std::span<const RoughRun> runs) {
  std::string text =
      "| roughness [h₀] | runs | reported, median | bending, median | worst | swing, median "
      "| least | apart, median [h₀] | worst | time, median | worst | warned |\n"
      "|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const double roughness : kRoughness) {
    std::vector<double> told, bending, swing, apart, time;
    std::size_t warned = 0;
    for (const RoughRun& run : runs) {
      if (run.roughness != roughness) continue;
      told.push_back(run.told);
      bending.push_back(run.bending);
      swing.push_back(run.swing);
      apart.push_back(run.apart);
      time.push_back(run.time);
      warned += run.warned ? 1 : 0;
    }
    if (told.empty()) continue;
    const auto both = [](const std::vector<double>& values, double q) {
      return fmt::format("{:.2f} | {:.2f}", quantile(values, 0.5), quantile(values, q));
    };
    text += fmt::format("| {} | {} | {:.2f} | {} | {} | {} | {} | {} |\n", roughness, told.size(),
                        quantile(told, 0.5), both(bending, 1), both(swing, 0), both(apart, 1),
                        both(time, 1), warned);
  }
  return text;
}

std::string csv(std::span<const RoughRun> runs) {
  std::string text = "mesh,drawing,roughness,told,bending,swing,apart,time,warned\n";
  for (const RoughRun& r : runs) {
    text += fmt::format("{},{},{},{:.3f},{:.3f},{:.3f},{:.3f},{:.2f},{}\n", r.mesh, r.drawing,
                        r.roughness, r.told, r.bending, r.swing, r.apart, r.time, r.warned ? 1 : 0);
  }
  return text;
}

}  // namespace talweg::quality
