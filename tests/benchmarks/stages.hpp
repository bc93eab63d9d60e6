// The stages of the method one by one, as benchmarks call them.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "talweg/core/curve_smoother.hpp"

namespace talweg::benchmarks {

/// One mesh file with a drawing of about 400 vertices on it. Every stage may be called any number
/// of times and does the whole of its work each time; only trace() must follow straighten().
class Stages {
 public:
  explicit Stages(std::filesystem::path mesh_file);

  void read();        ///< the file
  void open();        ///< checks, connectivity, lengths
  void factor();      ///< Laplacian and Cholesky factors, one thread
  void solve();       ///< the distance to the drawing
  void set_curve();   ///< what CurveSmoother does per drawing, with the solve
  void straighten();  ///< FlipOut with the paper's potential, tau = 2, from nothing laid out
  void trace();       ///< takes the flips back
  void measures();    ///< length, curvature and deviation of the result
  void smooth();      ///< what CurveSmoother does per tau: straighten, trace, measures

  [[nodiscard]] std::size_t faces() const { return opened_->surface().face_count(); }

 private:
  static constexpr double kTau = 2;

  std::filesystem::path file_;
  MeshLists lists_;
  std::shared_ptr<const OpenedMesh> opened_;
  SurfaceCurve drawn_;
  std::vector<double> distance_;
  CurveSmoother smoother_;
  std::optional<SignpostTriangulation> triangulation_;
  std::optional<FlipOut> flip_out_;
  std::optional<Tracer> tracer_;
  std::vector<EdgePath> paths_;
  FlipOutResult straight_;
  SurfaceCurve traced_;
};

/// The bumpy ball of 50,000 faces, written to a temporary folder.
std::filesystem::path generated_mesh();

}  // namespace talweg::benchmarks
