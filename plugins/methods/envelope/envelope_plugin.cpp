// talweg.envelope: Laplacian smoothing with splitting and merging inside a distance envelope.
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "envelope_smoothing.hpp"
#include "methods/deviation_choice.hpp"
#include "methods/method_workspace.hpp"
#include "methods/plugins.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg::plugins {
namespace {

class Envelope : public MethodWorkspace {
 public:
  using MethodWorkspace::MethodWorkspace;

  static talweg_plugin about() {
    return about_curves(
        "talweg.envelope", "Laplacian smoothing in an envelope (Lawonn et al. 2014)",
        "Another method, to compare with talweg.smooth: the curve's points slide along the mesh's "
        "edges towards the mean of their neighbours, split and merge at vertices, and stay within "
        "a distance of the drawing. Pinned points stay.");
  }
  static std::vector<talweg_parameter> parameters() {
    return with_repair(
        {plugin::number("envelope", "Envelope", "mesh units", 0, {0, HUGE_VAL, 0, 10},
                        "How far the curve's points may go from the drawing, along the surface. "
                        "By default the mean length of the drawing's segments.",
                        TALWEG_STAGE_RUN, TALWEG_OPTIONAL | TALWEG_OPEN_MINIMUM),
         plugin::integer("iterations", "Most iterations", 2000, {1, 1e6, 1, 10000},
                         "Rounds in which every point moves once."),
         plugin::number("weight", "Weight", "", 1, {0, 1, 0.1, 1},
                        "The part of the way to its best place that a point moves in a round.",
                        TALWEG_STAGE_RUN, TALWEG_ADVANCED | TALWEG_OPEN_MINIMUM),
         plugin::number("tolerance", "Tolerance", "", 1e-6, {0, 1, 1e-8, 1e-3},
                        "Stop when a round shortens the curves by a smaller part of their length.",
                        TALWEG_STAGE_RUN, TALWEG_ADVANCED),
         deviation_choice()});
  }

 private:
  Method smooth(const plugin::Parameters& parameters) override {
    const Stopwatch watch;
    EnvelopeOptions options;
    options.envelope = parameters.optional("envelope").value_or(mean_segment());
    options.iterations = static_cast<std::size_t>(parameters.number("iterations"));
    options.weight = parameters.number("weight");
    options.tolerance = parameters.number("tolerance");
    options.go_on = [&](std::size_t round) {
      return services().go_on("smooth",
                              static_cast<double>(round) / static_cast<double>(options.iterations));
    };
    EnvelopeResult result = smooth_in_envelope(mesh(), drawing().curves, drawing().pins, options);
    if (result.cancelled) throw plugin::Services::cancelled();
    Method method{"envelope", {}, {}};
    for (std::size_t c = 0; c < result.curves.size(); ++c) {
      MethodCurve& made = method.curves.emplace_back();
      made.curve = std::move(result.curves[c]);
      made.iterations = result.rounds;
      made.entries = {{"envelope", options.envelope},
                      {"splits", std::uint64_t{result.splits}},
                      {"merges", std::uint64_t{result.merges}}};
      if (!result.converged) made.termination = Outcome::kLimit;
      if (result.collapsed[c] == 0) continue;
      made.termination = Outcome::kCollapsed;
      made.warnings.emplace_back(
          "The loop shrinks to a point within the envelope; it was kept as it was when it fell "
          "below three mesh edges.");
    }
    method.times.straighten = watch.ms();
    return method;
  }

  /// The mean length of the segments of all curves, mesh units.
  [[nodiscard]] double mean_segment() const {
    double length = 0;
    std::size_t segments = 0;
    for (const SurfaceCurve& curve : drawing().curves) {
      length += curve_length(mesh().surface(), curve);
      segments += curve.points.size() - (curve.closed ? 0 : 1);
    }
    return length / static_cast<double>(segments);
  }
};

}  // namespace

const talweg_plugin* envelope_plugin() { return plugin::Adapter<Envelope>::plugin(); }

}  // namespace talweg::plugins
