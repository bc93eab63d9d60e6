#include "compare/comparison.hpp"

#include <span>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "compare/verdict.hpp"
#include "plugin_host.hpp"
#include "talweg/core/cutting/cut_topology.hpp"
#include "talweg/core/drawing/snapping.hpp"
#include "talweg/core/measure/edge_length_near.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/core/measure/self_contacts.hpp"
#include "talweg/core/version.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg::driver {
namespace {

CurveNumbers numbers_of(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                        double edge) {
  CurveNumbers numbers;
  numbers.curves = curves.size();
  for (const SurfaceCurve& curve : curves) {
    const CurveMeasures m = measure_curve(mesh.surface(), curve, edge);
    numbers.points += curve.points.size();
    numbers.length += m.length;
    numbers.curvature += m.total_curvature;
    numbers.largest_turn = std::max(numbers.largest_turn, m.max_curvature);
    numbers.bending += m.bending;
    numbers.window_turning = std::max(numbers.window_turning, m.window_turning);
  }
  numbers.contacts = self_contacts(mesh.surface(), curves).size();
  numbers.pieces = pieces_along(mesh, curves, false);
  numbers.bare = pieces_along(mesh, curves, true);
  return numbers;
}

bool ends_moved(const SurfaceMesh& mesh, const SurfaceCurve& a, const SurfaceCurve& b,
                double bound) {
  if (a.closed || b.closed) return false;
  return (mesh.position(a.points.front()) - mesh.position(b.points.front())).norm() > bound ||
         (mesh.position(a.points.back()) - mesh.position(b.points.back())).norm() > bound;
}

/// The end of a sentence if the result's topology differs from the drawing's.
std::string change_of_kind(const SurfaceMesh& mesh, std::span<const SurfaceCurve> drawn,
                           const CurveNumbers& before, std::span<const SurfaceCurve> result,
                           const CurveNumbers& after) {
  if (drawn.size() != result.size()) {
    return fmt::format("{} curves of {}", result.size(), drawn.size());
  }
  for (std::size_t c = 0; c < drawn.size(); ++c) {
    if (drawn[c].closed != result[c].closed) return result[c].closed ? "closed" : "opened";
    if (ends_moved(mesh, drawn[c], result[c], 1e-6 * mesh.mean_edge_length())) return "ends moved";
  }
  if (after.contacts > before.contacts) {
    return fmt::format("touches itself {} times", after.contacts - before.contacts);
  }
  if (after.pieces != before.pieces && after.pieces != before.bare && after.bare != before.bare) {
    return "separates the mesh into other pieces";
  }
  return {};
}

void add_deviation(DeviationMeter& meter, std::span<const SurfaceCurve> result,
                   std::span<const SurfaceCurve> drawn, double result_share, double drawn_share,
                   ComparedRun& run) {
  const SurfaceDeviation d = meter.measure(result, drawn);
  run.to_drawn = std::max(run.to_drawn, d.to_drawn.max);
  run.from_drawn = std::max(run.from_drawn, d.from_drawn.max);
  run.to_drawn_mean += d.to_drawn.mean * result_share;
  run.from_drawn_mean += d.from_drawn.mean * drawn_share;
}

/// Measures each curve to its own drawing if there are as many curves, otherwise all curves to all.
void measure_deviation(const SurfaceMesh& mesh, std::span<const SurfaceCurve> result,
                       std::span<const SurfaceCurve> drawn, double drawn_length, ComparedRun& run) {
  DeviationMeter meter(mesh);
  if (result.size() != drawn.size()) return add_deviation(meter, result, drawn, 1, 1, run);
  const auto length = [&](const SurfaceCurve& c) { return curve_length(mesh.surface(), c); };
  for (std::size_t c = 0; c < drawn.size(); ++c) {
    add_deviation(meter, result.subspan(c, 1), drawn.subspan(c, 1),
                  length(result[c]) / run.numbers.length, length(drawn[c]) / drawn_length, run);
  }
}

/// Runs one method on one drawing, with all requested values of its parameter.
class MethodRuns {
 public:
  MethodRuns(const ReadMesh& read, const SnappedDrawing& drawing, const SurfaceMesh& mesh,
             const Comparison& comparison, const CompareOptions& options)
      : read_(read), drawing_(drawing), mesh_(mesh), comparison_(comparison), options_(options) {
    for (const SurfaceCurve& curve : drawing.curves) {
      curves_.push_back(host_curve(place(mesh, curve)));
    }
  }

  /// Refusals are stored as runs. Throws Cancelled.
  std::vector<ComparedRun> of(std::size_t method) const {
    std::vector<std::optional<double>> values{std::nullopt};
    const Method& m = comparison_.methods[method];
    if (options_.sweep && !m.values.empty()) {
      values.clear();
      for (const double v : m.values) values.emplace_back(m.in_edges ? v * comparison_.edge : v);
    }
    return of(method, values);
  }

  /// Runs a method with these values of its parameter, in its own units.
  std::vector<ComparedRun> of(std::size_t method,
                              std::span<const std::optional<double>> values) const {
    const Method& m = comparison_.methods[method];
    std::vector<ComparedRun> runs;
    try {
      const host::Services services("talweg", version(), options_.progress);
      host::Instance instance(plugin_named(m.plugin), services);
      for (const std::optional<double>& value : values) {
        if (!go_on(options_.progress, "compare", progress_at(method, runs.size(), values.size()))) {
          throw host::Error(TALWEG_CANCELLED, "Cancelled.");
        }
        runs.push_back(run(instance, method, value, runs.empty()));
      }
    } catch (const Error& error) {  // no such plugin
      runs.push_back({});
      runs.back().method = method;
      runs.back().refusal = error.what();
    }
    return runs;
  }

 private:
  [[nodiscard]] double progress_at(std::size_t method, std::size_t run, std::size_t count) const {
    const double part = static_cast<double>(run) / static_cast<double>(count);
    return (static_cast<double>(method) + part) / static_cast<double>(comparison_.methods.size());
  }

  ComparedRun run(host::Instance& instance, std::size_t method, std::optional<double> value,
                  bool first) const {
    const Method& m = comparison_.methods[method];
    ComparedRun run;
    run.method = method;
    run.value = value;
    try {
      const Stopwatch watch;
      if (first) set_mesh(instance, mesh_.points(), read_.lists.triangles);
      for (const auto& setting : m.settings) {
        std::visit([&](const auto& v) { instance.set(setting.first.c_str(), v); }, setting.second);
      }
      if (run.value) instance.set(m.swept.c_str(), *run.value);
      instance.set_curves(curves_);
      host::Results results = instance.run();
      run.first_ms = watch.ms();
      if (!options_.sweep) {
        const Stopwatch again;
        instance.set_curves(curves_);
        results = instance.run();
        run.again_ms = again.ms();
      }
      measure(results, run);
    } catch (const host::Error& error) {
      if (error.status() == TALWEG_CANCELLED) throw;
      run.refusal = error.what();
    }
    return run;
  }

  void measure(const host::Results& results, ComparedRun& run) const {
    std::vector<SurfaceCurve> curves;
    for (const host::Curve& curve : results.curves) {
      run.curves.push_back(placed_curve(curve));
      CurveInput input;
      input.closed = curve.closed;
      input.points = run.curves.back().faces;
      SnappedCurve snapped = snap(mesh_, input);
      curves.push_back({snapped.closed, std::move(snapped.points)});
    }
    if (curves.empty()) {
      run.refusal = "The method returned no curve.";
      return;
    }
    run.numbers = numbers_of(mesh_, curves, comparison_.edge);
    measure_deviation(mesh_, curves, drawing_.curves, comparison_.drawn.length, run);
    run.changed = change_of_kind(mesh_, drawing_.curves, comparison_.drawn, curves, run.numbers);
    const std::string termination = results.text("termination");
    if (run.changed.empty() && termination == "collapsed") run.changed = termination;
    for (PlacedCurve& curve : run.curves) {
      curve = in_file_numbers(read_.map.get(), std::move(curve));
    }
  }

  const ReadMesh& read_;
  const SnappedDrawing& drawing_;
  const SurfaceMesh& mesh_;
  const Comparison& comparison_;
  const CompareOptions& options_;
  std::vector<host::Curve> curves_;
};

/// Without a sweep, methods that differ only in the swept parameter are the same.
void drop_repeated(std::vector<Method>& methods) {
  for (std::size_t m = methods.size(); m-- > 1;) {
    const auto end = methods.begin() + static_cast<std::ptrdiff_t>(m);
    if (std::any_of(methods.begin(), end,
                    [&](const Method& other) { return same_method(other, *end); })) {
      methods.erase(end);
    }
  }
}

}  // namespace

Comparison compare_methods(const ReadMesh& read, const SnappedDrawing& drawing,
                           const SurfaceMesh& mesh, const CompareOptions& options) {
  Comparison comparison;
  comparison.faces = mesh.surface().face_count();
  comparison.methods = options.methods;
  for (const SurfaceCurve& curve : drawing.curves) {
    comparison.edge += edge_length_near(mesh.surface(), curve);
    comparison.drawing.push_back(in_file_numbers(read.map.get(), place(mesh, curve)));
  }
  comparison.edge /= static_cast<double>(drawing.curves.size());
  comparison.drawn = numbers_of(mesh, drawing.curves, comparison.edge);
  const MethodRuns runs(read, drawing, mesh, comparison, options);
  const auto add = [&](std::vector<ComparedRun> more) {
    std::move(more.begin(), more.end(), std::back_inserter(comparison.runs));
  };
  if (!options.sweep) drop_repeated(comparison.methods);
  for (std::size_t m = 0; m < comparison.methods.size(); ++m) add(runs.of(m));
  const std::vector<std::optional<double>> bounds = bounds_to_try(comparison);
  if (options.sweep && !bounds.empty()) {
    comparison.methods.push_back(bounded_method());
    add(runs.of(comparison.methods.size() - 1, bounds));
  }
  return comparison;
}

}  // namespace talweg::driver
