#include "stages.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "talweg/core/drawing/curve_embedding.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/core/lifting/lifted_lengths.hpp"
#include "talweg/core/lifting/potential.hpp"
#include "talweg/core/measure/deviation.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/core/smoothing/embedded_drawing.hpp"
#include "talweg/heat/curve_sources.hpp"
#include "tools/paper/ball.hpp"
#include "tools/paper/hand.hpp"
#include "tools/scenes/ply_writer.hpp"

namespace talweg::benchmarks {
namespace {

CurveOptions paper_method() {
  CurveOptions options;
  options.method = Method::kPaper;
  return options;
}

SmoothingOptions without_deviation(double tau) {
  SmoothingOptions options;
  options.tau = tau;
  options.deviation = DeviationMeasure::kNone;
  return options;
}

}  // namespace

Stages::Stages(std::filesystem::path mesh_file)
    : file_(std::move(mesh_file)),
      lists_(read_mesh(file_)),
      opened_(OpenedMesh::open(lists_)),
      drawn_(paper::tour(*opened_, 400, 1)),
      smoother_(opened_),
      in_corridor_(opened_),
      dijkstra_(opened_->surface()),
      dragged_(opened_->mesh(), drawn_, 20),
      meter_(opened_->mesh()) {
  smoother_.set_curve(drawn_, paper_method());
  triangulation_.emplace(opened_->surface());
  flip_out_.emplace(*triangulation_);
  tracer_.emplace(*triangulation_);
  capped_ = capped_curves(opened_->surface(), std::span(&drawn_, 1), paper_method());
  paths_ = embed_curves(*triangulation_, capped_).paths;
  straighten();
  trace();
  corridor();
  drag();
}

void Stages::read() { lists_ = read_mesh(file_); }

void Stages::open() { SurfaceMesh::open(lists_); }

void Stages::factor() {
  HeatOptions options;
  options.threads = 1;
  const HeatDistance heat(opened_->surface(), options);
}

void Stages::solve() {
  distance_ = opened_->heat(10)->solve(curve_sources(opened_->surface(), capped_.front()));
}

void Stages::set_curve() { smoother_.set_curve(drawn_, paper_method()); }

void Stages::straighten() {
  const std::span<const double> distance = smoother_.distance();
  double largest = 0;
  for (const double d : distance) {
    if (std::isfinite(d)) largest = std::max(largest, d);
  }
  const Potential potential({}, kTau, largest);
  triangulation_->set_metric([&](VertexId p, VertexId q, double length) {
    return lifted_length(length, potential(distance[p.index()]), potential(distance[q.index()]));
  });
  straight_ = flip_out_->run(paths_, {});
}

void Stages::trace() {
  const std::vector<EdgePath> paths{straight_.paths.front().path};
  traced_ = std::move(tracer_->trace_and_undo(paths).curves.front());
  triangulation_->set_metric({});
}

void Stages::measures() {
  const SurfaceMesh& mesh = opened_->mesh();
  measure_curve(mesh.surface(), traced_);
  talweg::deviation(positions_of(mesh, traced_), false, positions_of(mesh, drawn_), false);
}

void Stages::smooth() { smoother_.smooth(without_deviation(kTau)); }

void Stages::corridor() {
  in_corridor_.set_curve(drawn_);
  in_corridor_.smooth(without_deviation(1));
}

void Stages::corridor_tau() {
  tau_ = tau_ > 1.9 ? 1.1 : tau_ + 0.1;
  in_corridor_.smooth(without_deviation(tau_));
}

void Stages::drag() { in_corridor_.drag(0, dragged_.redraw(dijkstra_), without_deviation(tau_)); }

void Stages::deviation() { meter_.measure(std::span(&traced_, 1), std::span(&drawn_, 1)); }

std::filesystem::path generated_mesh() {
  const auto file = std::filesystem::temp_directory_path() / "talweg-benchmark-50k.ply";
  scenes::write_bytes(file, scenes::ply_bytes(paper::bumpy_ball(50, 1)));
  return file;
}

}  // namespace talweg::benchmarks
