#include "tools/paper/experiment.hpp"

#include <algorithm>
#include <ctime>
#include <utility>

#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg::paper {
namespace {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

}  // namespace

Experiment::Experiment(MeshLists lists)
    : lists_(std::move(lists)),
      mesh_([this] {
        const Stopwatch watch;
        auto mesh = OpenedMesh::open(lists_);
        static_cast<void>(mesh->heat(10));  // factors
        open_ms_ = watch.ms();
        return mesh;
      }()),
      smoother_(mesh_) {}

Timed Experiment::smooth(double tau, int relax_rounds, std::size_t repeats) {
  CurveOptions curve_options;
  curve_options.method = Method::kPaper;
  SmoothingOptions options;
  options.tau = tau;
  options.relax_rounds = relax_rounds;
  options.deviation = DeviationMeasure::kAlongSurface;
  Timed timed;
  std::vector<double> solve, straighten, processor;
  for (std::size_t k = 0; k < repeats; ++k) {
    const std::clock_t start = std::clock();
    smoother_.set_curve(drawn_, curve_options);
    timed.result = smoother_.smooth(options);
    processor.push_back(1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    const StageTimes& times = timed.result.report().time_ms;
    solve.push_back(times.solve);
    straighten.push_back(times.straighten + times.trace);
  }
  timed.processor_ms = median(std::move(processor));
  timed.solve_ms = median(std::move(solve));
  timed.straighten_ms = median(std::move(straighten));
  return timed;
}

picture::PictureCurve Experiment::tube(const SurfaceCurve& curve, const picture::Color& color,
                                       double width) const {
  return {positions_of(mesh_->mesh(), curve), curve.closed, color, width};
}

}  // namespace talweg::paper
