// The stages of the method are called one by one by benchmarks.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "dragged_point.hpp"
#include "talweg/core/drawing/edge_dijkstra.hpp"
#include "talweg/core/measure/surface_deviation.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"
#include "talweg/intrinsic/flips/flip_out.hpp"
#include "talweg/intrinsic/flips/signpost_triangulation.hpp"
#include "talweg/intrinsic/flips/trace.hpp"

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
  void measures();    ///< length, curvature and deviation in space of the result
  void smooth();    ///< what CurveSmoother does per tau: straighten, trace, measures, no deviation
  void corridor();  ///< a new drawing to its first curve by the corridor, no deviation
  void corridor_tau();  ///< another tau after that
  void drag();          ///< a point dragged: two legs redrawn, and the result followed
  void deviation();     ///< both ways along the surface

  [[nodiscard]] std::size_t faces() const { return opened_->surface().face_count(); }

 private:
  static constexpr double kTau = 2;

  std::filesystem::path file_;
  MeshLists lists_;
  std::shared_ptr<const OpenedMesh> opened_;
  SurfaceCurve drawn_;
  std::vector<SurfaceCurve> capped_;
  std::vector<double> distance_;
  CurveSmoother smoother_;
  CurveSmoother in_corridor_;
  EdgeDijkstra dijkstra_;
  DraggedPoint dragged_;
  DeviationMeter meter_;
  double tau_ = 1;
  std::optional<SignpostTriangulation> triangulation_;
  std::optional<FlipOut> flip_out_;
  std::optional<Tracer> tracer_;
  std::vector<EdgePath> paths_;
  FlipOutResult straight_;
  SurfaceCurve traced_;
};

struct Stage {
  const char* name;
  void (Stages::*run)();
};
inline constexpr Stage kStages[] = {
    {"read", &Stages::read},
    {"open", &Stages::open},
    {"factor", &Stages::factor},
    {"solve", &Stages::solve},
    {"set_curve", &Stages::set_curve},
    {"straighten", &Stages::straighten},
    {"trace", &Stages::trace},
    {"measures", &Stages::measures},
    {"smooth", &Stages::smooth},
    {"corridor", &Stages::corridor},
    {"corridor_tau", &Stages::corridor_tau},
    {"drag", &Stages::drag},
    {"deviation", &Stages::deviation},
};

/// The bumpy ball of 50,000 faces, written to a temporary folder.
std::filesystem::path generated_mesh();

}  // namespace talweg::benchmarks
