// An inspection is how a person looks for what is wrong with smoothed curves: combs of curvature,
// and a mark at the place where something is largest.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "CurveNodes.hh"
#include "HostCalls.hh"
#include "talweg/editing/comb.hpp"

namespace talweg::openflipper {

/// What is marked where it is largest.
enum class Mark { kNothing, kDeviation, kCurvature };

/// What is looked at.
struct Inspected {
  const editing::MeshArrays& mesh;
  const host::Results& results;
  const std::vector<std::uint32_t>& numbers;  ///< of the results' curves
  bool newer_come = false;                    ///< newer results are on their way
};

class Inspection {
 public:
  /// Without a window there are no nodes. `size`: the mesh's diagonal.
  Inspection(HostCalls& host, CurveNodes* nodes, double size)
      : host_(host), nodes_(nodes), size_(size) {}

  /// Whether it needs the fields of points.
  [[nodiscard]] bool wants_fields() const { return with_combs_ || mark_ == Mark::kCurvature; }
  /// Whether combs are known.
  [[nodiscard]] bool has_combs() const { return !combs_.empty(); }
  /// There are other results.
  void show(const Inspected& now);

  void show_combs(bool with);
  [[nodiscard]] bool with_combs() const { return with_combs_; }
  /// Of the tooth that is longest, 1 / mesh unit; 0: there is no comb.
  [[nodiscard]] double longest_tooth() const { return most_curved_.curvature; }

  struct Marked {
    std::optional<ACG::Vec3d> at;  ///< none: nothing is marked
    double value = 0;              ///< mesh units, or 1 / mesh unit
    std::uint32_t curve = 0;       ///< its number
  };
  /// Marks the place where that is largest when find_mark() or show() comes next, which turns the
  /// view to it.
  void set_mark(Mark mark);
  void find_mark(const Inspected& now);
  [[nodiscard]] Mark mark() const { return mark_; }
  [[nodiscard]] const Marked& marked() const { return marked_; }

 private:
  struct Comb {
    std::vector<editing::Tooth> teeth;
    bool closed;
    std::uint32_t number;  // of its curve
  };

  void measure(const Inspected& now);
  void draw_combs();
  [[nodiscard]] std::optional<ACG::Vec3d> place_of_largest(const host::Results& results) const;

  HostCalls& host_;
  CurveNodes* nodes_;
  double size_;
  bool with_combs_ = false;
  std::vector<Comb> combs_;  // of the results, where they are wanted
  editing::Tooth most_curved_ = {};
  Mark mark_ = Mark::kNothing;
  Marked marked_;
  bool turns_ = false;  // the view, to the mark
};

}  // namespace talweg::openflipper
