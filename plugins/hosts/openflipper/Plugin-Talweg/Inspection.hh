// Shows defects of smoothed curves to the user: combs of curvature, and a mark at the largest
// deviation or curvature.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "CurveNodes.hh"
#include "HostCalls.hh"
#include "talweg/editing/comb.hpp"

namespace talweg::openflipper {

/// The quantity whose largest value is marked.
enum class Mark { kNothing, kDeviation, kCurvature };

/// The input of an inspection.
struct Inspected {
  const editing::MeshArrays& mesh;
  const host::Results& results;
  const std::vector<std::uint32_t>& numbers;  ///< numbers of the results' curves
  bool newer_come = false;                    ///< whether newer results are being computed
};

class Inspection {
 public:
  /// `nodes` is null without a window. `size` is the length of the mesh's diagonal.
  Inspection(HostCalls& host, CurveNodes* nodes, double size)
      : host_(host), nodes_(nodes), size_(size) {}

  /// Whether the inspection needs fields of the results' points.
  [[nodiscard]] bool wants_fields() const { return with_combs_ || mark_ == Mark::kCurvature; }
  /// Whether combs are known.
  [[nodiscard]] bool has_combs() const { return !combs_.empty(); }
  /// Shows new results.
  void show(const Inspected& now);

  void show_combs(bool with);
  [[nodiscard]] bool with_combs() const { return with_combs_; }
  /// The curvature of the longest tooth, 1 / mesh unit; 0 without combs.
  [[nodiscard]] double longest_tooth() const { return most_curved_.curvature; }

  struct Marked {
    std::optional<ACG::Vec3d> at;  ///< empty: no mark
    double value = 0;              ///< mesh units, or 1 / mesh unit
    std::uint32_t curve = 0;       ///< number of the curve
  };
  /// Marks the largest value of a quantity at the next find_mark() or show(), which turns the view
  /// to it.
  void set_mark(Mark mark);
  void find_mark(const Inspected& now);
  [[nodiscard]] Mark mark() const { return mark_; }
  [[nodiscard]] const Marked& marked() const { return marked_; }

 private:
  struct Comb {
    std::vector<editing::Tooth> teeth;
    bool closed;
    std::uint32_t number;  // number of the curve
  };

  void measure(const Inspected& now);
  void draw_combs();
  [[nodiscard]] std::optional<ACG::Vec3d> place_of_largest(const host::Results& results) const;

  HostCalls& host_;
  CurveNodes* nodes_;
  double size_;
  bool with_combs_ = false;
  std::vector<Comb> combs_;  // combs of the results, if requested
  editing::Tooth most_curved_ = {};
  Mark mark_ = Mark::kNothing;
  Marked marked_;
  bool turns_ = false;  // whether the view turns to the mark
};

}  // namespace talweg::openflipper
