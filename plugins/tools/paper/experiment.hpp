// Smooths one curve on one mesh as in the paper, and measures the time.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "talweg/core/smoothing/curve_smoother.hpp"
#include "tools/picture/render.hpp"

namespace talweg::paper {

struct Timed {
  SmoothingResult result;
  double solve_ms = 0;       ///< the paper's t_φ: the distance to the curve
  double straighten_ms = 0;  ///< the paper's t_λ: straightening and tracing
  double processor_ms = 0;   ///< of the whole run, with its measures; independent of other programs
};

/// A mesh with a drawing on it. All smoothing uses the paper's potential.
class Experiment {
 public:
  explicit Experiment(MeshLists lists);

  void set_drawing(SurfaceCurve drawn) { drawn_ = std::move(drawn); }
  /// Medians of `repeats` runs, each with the curve set anew.
  Timed smooth(double tau, int relax_rounds = 0, std::size_t repeats = 5);

  [[nodiscard]] const MeshLists& lists() const { return lists_; }
  [[nodiscard]] const OpenedMesh& mesh() const { return *mesh_; }
  [[nodiscard]] const SurfaceCurve& drawn() const { return drawn_; }
  /// Time from the lists to the factored heat solver.
  [[nodiscard]] double open_ms() const { return open_ms_; }
  [[nodiscard]] picture::PictureCurve tube(const SurfaceCurve& curve, const picture::Color& color,
                                           double width = 4) const;

 private:
  MeshLists lists_;
  double open_ms_ = 0;  // measured while mesh_ is made
  std::shared_ptr<const OpenedMesh> mesh_;
  CurveSmoother smoother_;
  SurfaceCurve drawn_;
};

constexpr picture::Color kDrawnColor{0.1, 0.1, 0.1};
constexpr picture::Color kSmoothColor{0.08, 0.31, 0.75};

/// The folders of results and of meshes.
struct Folders {
  std::filesystem::path out;
  std::filesystem::path meshes;
};

/// Each function writes its pictures and returns its part of the results as Markdown.
std::string table1(const Folders& folders);
std::string tau_figure(const Folders& folders);
std::string resolution_figures(const Folders& folders);
std::string relaxation_figure(const Folders& folders);

}  // namespace talweg::paper
