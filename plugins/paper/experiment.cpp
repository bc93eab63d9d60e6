#include "paper/experiment.hpp"

#include <algorithm>
#include <utility>

#include "talweg/core/stopwatch.hpp"

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
  SmoothingOptions options;
  options.tau = tau;
  options.relax_rounds = relax_rounds;
  Timed timed;
  std::vector<double> solve, straighten;
  for (std::size_t k = 0; k < repeats; ++k) {
    smoother_.set_curve(drawn_);
    timed.result = smoother_.smooth(options);
    const StageTimes& times = timed.result.report().time_ms;
    solve.push_back(times.solve);
    straighten.push_back(times.straighten + times.trace);
  }
  timed.best_ms = *std::min_element(solve.begin(), solve.end()) +
                  *std::min_element(straighten.begin(), straighten.end());
  timed.solve_ms = median(std::move(solve));
  timed.straighten_ms = median(std::move(straighten));
  return timed;
}

picture::PictureCurve Experiment::tube(const SurfaceCurve& curve, const picture::Color& color,
                                       double width) const {
  return {positions_of(mesh_->mesh(), curve), curve.closed, color, width};
}

}  // namespace talweg::paper
