#include "talweg/core/mesh/vertex_filter.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "talweg/intrinsic/surface/spokes.hpp"

namespace talweg {
namespace {

constexpr std::size_t kMostDegree = 20;
constexpr double kTime = 0.61;  // halves waves of 2π s / √8 edges, whose eigenvalue is λ = 2 / s²
constexpr std::uint32_t kOutside = 0xFFFFFFFFU;

using Coefficients = std::vector<double>;

/// The Chebyshev coefficients of (1 − exp(−tλ))² / λ as a function of x = λ − 1 in [−1, 1].
Coefficients coefficients_of(double scale, std::size_t degree) {
  const double t = kTime * scale * scale;
  const std::size_t points = degree + 1;
  const auto all = static_cast<double>(points);
  Coefficients c(points, 0);
  for (std::size_t j = 0; j < points; ++j) {
    const double angle = std::numbers::pi * (static_cast<double>(j) + 0.5) / all;
    const double lambda = std::cos(angle) + 1;
    const double gone = -std::expm1(-t * lambda);
    for (std::size_t k = 0; k < points; ++k) {
      c[k] += (k == 0 ? 1.0 : 2.0) / all * gone * gone / lambda *
              std::cos(static_cast<double>(k) * angle);
    }
  }
  return c;
}

/// L applied to `values`: each value minus the mean of its neighbours; 0 at vertices that are not
/// whole.
std::vector<Point> rough_part(const VertexGraph& graph, std::span<const Point> values) {
  std::vector<Point> result(graph.size(), Point::Zero());
  for (std::size_t i = 0; i < graph.size(); ++i) {
    const auto neighbours = graph.neighbours(i);
    if (!graph.is_whole(i) || neighbours.empty()) continue;
    // Summing differences keeps the digits far from the origin.
    Point sum = Point::Zero();
    for (const std::uint32_t j : neighbours) sum += values[i] - values[j];
    result[i] = sum / static_cast<double>(neighbours.size());
  }
  return result;
}

/// Applies x = L − 1: the negative mean of the neighbours.
void negative_means(const VertexGraph& graph, const std::vector<Point>& values,
                    std::vector<Point>& result) {
  for (std::size_t i = 0; i < graph.size(); ++i) {
    const auto neighbours = graph.neighbours(i);
    Point sum = Point::Zero();
    for (const std::uint32_t j : neighbours) sum -= values[j];
    result[i] = neighbours.empty() ? sum : sum / static_cast<double>(neighbours.size());
  }
}

}  // namespace

VertexGraph::VertexGraph(const Surface& surface) {
  vertices_.reserve(surface.vertex_count());
  for (std::size_t v = 0; v < surface.vertex_count(); ++v) vertices_.emplace_back(v);
  std::vector<std::uint32_t> number_of(surface.vertex_count());
  std::iota(number_of.begin(), number_of.end(), 0U);
  connect(surface, number_of);
}

VertexGraph::VertexGraph(const Surface& surface, std::span<const VertexId> seeds, int rings) {
  std::vector<std::uint32_t> number_of(surface.vertex_count(), kOutside);
  const auto add = [&](VertexId v) {
    if (number_of[v.index()] != kOutside) return;
    number_of[v.index()] = static_cast<std::uint32_t>(vertices_.size());
    vertices_.push_back(v);
  };
  for (const VertexId v : seeds) add(v);
  std::size_t first = 0;
  for (int ring = 0; ring < rings; ++ring) {
    const std::size_t last = vertices_.size();
    for (; first < last; ++first) {
      for_each_spoke(surface, vertices_[first], [&](HalfedgeId h) { add(surface.head(h)); });
    }
  }
  connect(surface, number_of);
}

void VertexGraph::connect(const Surface& surface, std::span<const std::uint32_t> number_of) {
  begin_.reserve(vertices_.size() + 1);
  begin_.push_back(0);
  whole_.assign(vertices_.size(), 1);
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    for_each_spoke(surface, vertices_[i], [&](HalfedgeId h) {
      const std::uint32_t number = number_of[surface.head(h).index()];
      if (number == kOutside) {
        whole_[i] = 0;
      } else {
        neighbours_.push_back(number);
      }
    });
    begin_.push_back(static_cast<std::uint32_t>(neighbours_.size()));
  }
}

std::vector<std::vector<Point>> finer_parts(const VertexGraph& graph,
                                            std::span<const Point> positions,
                                            std::span<const double> scales,
                                            ProgressPoller& poller) {
  std::vector<Point> last = rough_part(graph, positions);  // L p
  std::vector<Point> now(graph.size()), next(graph.size());
  // Degree 14 for 4 edges, 20 for 6: the error of the polynomials is at most 0.003.
  const double widest = *std::max_element(scales.begin(), scales.end());
  const auto degree = std::min(kMostDegree, static_cast<std::size_t>(3 * widest + 2));
  std::vector<Coefficients> coefficients;
  for (const double scale : scales) coefficients.push_back(coefficients_of(scale, degree));
  std::vector<std::vector<Point>> parts(scales.size(),
                                        std::vector<Point>(graph.size(), Point::Zero()));
  const auto add = [&](std::size_t k, const std::vector<Point>& term) {
    for (std::size_t s = 0; s < scales.size(); ++s) {
      for (std::size_t i = 0; i < term.size(); ++i) parts[s][i] += coefficients[s][k] * term[i];
    }
  };
  negative_means(graph, last, now);
  add(0, last);
  add(1, now);
  for (std::size_t k = 2; k <= degree; ++k) {
    poller.add_work(graph.size());
    negative_means(graph, now, next);
    for (std::size_t i = 0; i < next.size(); ++i) next[i] = 2 * next[i] - last[i];
    last.swap(now);
    now.swap(next);
    add(k, now);
  }
  return parts;
}

void spread(const VertexGraph& graph, std::vector<double>& values, ProgressPoller& poller) {
  constexpr int kSteps = 16;
  std::vector<double> next(values.size());
  for (int step = 0; step < kSteps; ++step) {
    poller.add_work(graph.size() / 4);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto neighbours = graph.neighbours(i);
      double sum = 0;
      for (const std::uint32_t j : neighbours) sum += values[j];
      next[i] = neighbours.empty() ? values[i]
                                   : (values[i] + sum / static_cast<double>(neighbours.size())) / 2;
    }
    values.swap(next);
  }
}

}  // namespace talweg
