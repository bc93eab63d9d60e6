#include "talweg/heat/heat_distance.hpp"

#include <algorithm>
#include <cmath>
#include <future>
#include <limits>
#include <string>
#include <system_error>
#include <utility>

#include "talweg/heat/cholesky_factor.hpp"
#include "talweg/heat/cotan_laplacian.hpp"
#include "talweg/heat/heat_flow.hpp"
#include "talweg/heat/heat_systems.hpp"
#include "talweg/heat/heat_triangles.hpp"
#include "talweg/heat/mollification.hpp"
#include "talweg/heat/unit_gradient.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg {
namespace {

void check_range(double value, double low, double high, const char* name) {
  if (value >= low && value <= high) return;
  throw Error(ErrorCode::kBadUsage, std::string(name) + " must be in [" + std::to_string(low) +
                                        ", " + std::to_string(high) + "], not " +
                                        std::to_string(value) + ".");
}

std::vector<char> boundary_vertices(const Surface& surface) {
  std::vector<char> boundary(surface.vertex_count(), 0);
  for (std::size_t v = 0; v < boundary.size(); ++v) {
    boundary[v] = surface.on_boundary(VertexId{v}) ? 1 : 0;
  }
  return boundary;
}

std::vector<MetricTriangle> triangles_of(const Surface& surface, const Mollification& mollified,
                                         bool delaunay, std::size_t& flips) {
  const auto triangles = [&](const Surface& s) {
    return delaunay ? delaunay_triangles(s, &flips) : metric_triangles(s);
  };
  if (!mollified.changed()) return triangles(surface);
  Surface thickened = surface;
  thickened.set_lengths(mollified.lengths);
  return triangles(thickened);
}

// Without pthreads, a page would wait forever for a new thread to start.
#if defined(__EMSCRIPTEN__) && !defined(__EMSCRIPTEN_PTHREADS__)
constexpr bool kHasThreads = false;
#else
constexpr bool kHasThreads = true;
#endif

/// Factors matrices one after the other or two at a time, with the same results.
class Factoring {
 public:
  Factoring(const SymbolicFactor& symbolic, unsigned threads)
      : symbolic_(symbolic), in_parallel_(kHasThreads && threads > 1) {}

  std::future<CholeskyFactor> start(std::shared_ptr<const SymmetricMatrix> matrix) {
    const auto job = [symbolic = symbolic_, kept = std::move(matrix)] {
      return CholeskyFactor(symbolic, *kept);
    };
    // The two launch policies are tried one by one: with both at once, libstdc++ falls back to a
    // job that it has already moved from.
    try {
      if (in_parallel_) return std::async(std::launch::async, job);
    } catch (const std::system_error&) {
      in_parallel_ = false;  // the system has no more threads
    }
    return std::async(std::launch::deferred, job);
  }

 private:
  SymbolicFactor symbolic_;
  bool in_parallel_;
};

}  // namespace

void HeatOptions::validate() const {
  check_range(time_scale, 1e-3, 1e6, "time_scale");
  check_range(mollification, 1e-10, 1e-2, "mollification");
  if (threads < 1) throw Error(ErrorCode::kBadUsage, "threads must be at least 1.");
}

struct HeatDistance::Impl {
  double time_scale = 0;
  Components components;
  std::vector<char> boundary;  // by vertex
  std::vector<HeatTriangle> triangles;
  std::vector<char> pinned;  // by vertex, in the Poisson system
  std::optional<CholeskyFactor> neumann, dirichlet, poisson;
  HeatReport report;

  /// The checked sources, and the sums and flags of each component that follow from them.
  struct CheckedSources {
    std::vector<double> total;  // weight, by component
    std::vector<char> inside;   // by component: whether a source is off the boundary
    std::vector<double> heat;   // by vertex; sums to 1 over each component with a source
    std::vector<char> reached;  // by vertex
  };

  bool prepare(const Surface& surface, const HeatOptions& options, const Progress& progress);
  bool factor(CotanLaplacian laplacian, unsigned threads, const Progress& progress);
  CheckedSources checked(std::span<const WeightedVertex> sources) const;
  ScaledField heat(const CheckedSources& checked, const Progress& progress) const;
  void finish(std::vector<double>& distance, std::span<const WeightedVertex> sources,
              const CheckedSources& checked, const DistanceOptions& options) const;
};

bool HeatDistance::Impl::prepare(const Surface& surface, const HeatOptions& options,
                                 const Progress& progress) {
  options.validate();
  if (surface.vertex_count() == 0) throw Error(ErrorCode::kBadMesh, "The mesh has no vertices.");
  if (!go_on(progress, "laplacian", 0)) return false;
  Stopwatch watch;
  time_scale = options.time_scale;
  components = components_of(surface);
  boundary = boundary_vertices(surface);
  if (!go_on(progress, "laplacian", 0)) return false;
  report.components = components.count;
  report.mean_edge_length = mean_edge_lengths(surface, components);

  CotanLaplacian laplacian;
  {
    Mollification mollified = mollify(surface, components, options.mollification);
    if (!go_on(progress, "laplacian", 0)) return false;
    const std::vector<MetricTriangle> metric =
        triangles_of(surface, mollified, options.delaunay, report.flips);
    report.mollification = std::move(mollified.amount);
    if (!go_on(progress, "laplacian", 0)) return false;
    laplacian = cotan_laplacian(surface.vertex_count(), metric);
    if (!go_on(progress, "laplacian", 0)) return false;
    triangles = heat_triangles(metric);
    report.flat_triangles = metric.size() - triangles.size();
  }
  report.laplacian_ms = watch.lap();
  return factor(std::move(laplacian), options.threads, progress);
}

bool HeatDistance::Impl::factor(CotanLaplacian laplacian, unsigned threads,
                                const Progress& progress) {
  if (!go_on(progress, "order", 0.1)) return false;
  Stopwatch watch;
  const SymbolicFactor symbolic(laplacian.stiffness);
  report.factor_entries = symbolic.factor_entries();
  report.order_ms = watch.lap();
  if (!go_on(progress, "factor", 0.6)) return false;

  // Each matrix lives only until its factor is computed, because the process takes most memory
  // here.
  Factoring factoring(symbolic, threads);
  auto poisson_job = factoring.start(std::make_shared<const SymmetricMatrix>(
      pinned_poisson_matrix(laplacian, components, pinned)));
  const auto heat = std::make_shared<SymmetricMatrix>(
      neumann_heat_matrix(std::move(laplacian), components, report.mean_edge_length, time_scale));
  neumann = factoring.start(heat).get();
  poisson = poisson_job.get();
  if (std::find(boundary.begin(), boundary.end(), 1) != boundary.end()) {
    if (!go_on(progress, "factor", 0.8)) return false;
    replace_by_identity(*heat, boundary);
    dirichlet = CholeskyFactor(symbolic, *heat);
  }
  report.factor_ms = watch.lap();
  return go_on(progress, "factor", 1);
}

HeatDistance::Impl::CheckedSources HeatDistance::Impl::checked(
    std::span<const WeightedVertex> sources) const {
  const std::size_t vertices = boundary.size();
  CheckedSources checked;
  checked.total.assign(components.count, 0.0);
  checked.inside.assign(components.count, 0);
  checked.heat.assign(vertices, 0.0);
  checked.reached.assign(vertices, 0);
  bool any = false;
  for (const auto& [vertex, weight] : sources) {
    const std::size_t v = vertex.index();
    if (v >= vertices || !(weight >= 0) || !std::isfinite(weight)) {
      throw Error(ErrorCode::kBadCurve,
                  "The source at vertex " + std::to_string(v) +
                      (v >= vertices ? " is not on the mesh."
                                     : " has a weight that is negative or not finite."));
    }
    if (!(weight > 0)) continue;
    any = true;
    checked.total[components.of_vertex[v]] += weight;
    checked.heat[v] += weight;
    if (boundary[v] == 0) checked.inside[components.of_vertex[v]] = 1;
  }
  if (!any) throw Error(ErrorCode::kBadCurve, "The curve has no source of positive weight.");
  for (std::size_t v = 0; v < vertices; ++v) {
    const double total = checked.total[components.of_vertex[v]];
    if (!(total > 0)) continue;
    checked.reached[v] = 1;
    checked.heat[v] /= total;
  }
  return checked;
}

ScaledField HeatDistance::Impl::heat(const CheckedSources& checked,
                                     const Progress& progress) const {
  ScaledField u =
      heat_flow(*neumann, triangles, time_scale, checked.heat, checked.reached, progress);
  if (!dirichlet) return u;
  // The average is taken in components with a boundary and a source off the boundary. In a closed
  // component the second solution would be the same.
  std::vector<char> bounded(components.count, 0);
  for (std::size_t v = 0; v < boundary.size(); ++v) {
    if (boundary[v] != 0) bounded[components.of_vertex[v]] = 1;
  }
  std::vector<char> averaged(boundary.size(), 0), reached(boundary.size(), 0);
  std::vector<double> source(boundary.size(), 0.0);
  bool any = false;
  for (std::size_t v = 0; v < boundary.size(); ++v) {
    const std::size_t c = components.of_vertex[v];
    if (bounded[c] == 0 || checked.inside[c] == 0) continue;
    any = true;
    averaged[v] = 1;
    if (boundary[v] != 0) continue;
    reached[v] = 1;
    source[v] = checked.heat[v];
  }
  if (!any) return u;
  return average(std::move(u),
                 heat_flow(*dirichlet, triangles, time_scale, source, reached, progress), averaged);
}

void HeatDistance::Impl::finish(std::vector<double>& distance,
                                std::span<const WeightedVertex> sources,
                                const CheckedSources& checked,
                                const DistanceOptions& options) const {
  std::vector<double> mean(components.count, 0.0);
  for (const auto& [vertex, weight] : sources) {
    const std::size_t c = components.of_vertex[vertex.index()];
    if (weight > 0) mean[c] += distance[vertex.index()] * (weight / checked.total[c]);
  }
  for (std::size_t v = 0; v < distance.size(); ++v) {
    if (checked.reached[v] == 0) {
      distance[v] = std::numeric_limits<double>::infinity();
      continue;
    }
    if (!std::isfinite(distance[v])) {
      throw Error(ErrorCode::kNumerical,
                  "The distance at vertex " + std::to_string(v) + " is not a finite number.");
    }
    if (options.zero_on_sources) distance[v] -= mean[components.of_vertex[v]];
    if (options.clamp) distance[v] = std::max(distance[v], 0.0);
  }
}

HeatDistance::HeatDistance(const Surface& surface, const HeatOptions& options)
    : HeatDistance(std::move(*open(surface, options, {}))) {}

HeatDistance::HeatDistance(std::unique_ptr<const Impl> impl) : impl_(std::move(impl)) {}
HeatDistance::~HeatDistance() = default;
HeatDistance::HeatDistance(HeatDistance&&) noexcept = default;
HeatDistance& HeatDistance::operator=(HeatDistance&&) noexcept = default;

std::optional<HeatDistance> HeatDistance::open(const Surface& surface, const HeatOptions& options,
                                               const Progress& progress) {
  auto impl = std::make_unique<Impl>();
  if (!impl->prepare(surface, options, progress)) return std::nullopt;
  return HeatDistance(std::move(impl));
}

std::vector<double> HeatDistance::solve(std::span<const WeightedVertex> sources,
                                        const DistanceOptions& options,
                                        const Progress& progress) const {
  ProgressPoller poller(progress, "solve");
  const Impl::CheckedSources checked = impl_->checked(sources);
  const ScaledField heat = impl_->heat(checked, progress);
  poller.poll();
  std::vector<double> right = unit_gradient_divergence(impl_->triangles, heat);
  for (std::size_t v = 0; v < right.size(); ++v) {
    if (impl_->pinned[v] != 0) right[v] = 0;
  }
  poller.poll();
  std::vector<double> distance = impl_->poisson->solve(right);
  poller.poll();
  impl_->finish(distance, sources, checked, options);
  return distance;
}

const HeatReport& HeatDistance::report() const { return impl_->report; }

std::vector<double> heat_distance(const Surface& surface, const SurfaceCurve& curve,
                                  const HeatOptions& options) {
  return HeatDistance(surface, options).solve(curve_sources(surface, curve));
}

}  // namespace talweg
