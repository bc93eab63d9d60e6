// Offsets: curves at a distance along the surface from smoothed curves (talweg.offset).
#pragma once

#include <string>
#include <vector>

#include "answer.hpp"
#include "talweg/editing/workplace.hpp"

namespace talweg::browser {

/// `OffsetWish` in src/engine/types.ts.
struct OffsetWish {
  std::vector<std::size_t> curves;  ///< indices of the last smoothing's curves, from 0
  double distance = 0;              ///< along the surface, mesh units
  std::string side = "both";        ///< "both", "left" or "right"
  std::string caps = "round";       ///< "round" or "none"
};

OffsetWish offset_wish_of(const Json& json);

class Offsets {
 public:
  /// `weld_within` is the tolerance of a repair's welding, mesh units.
  Offsets(const editing::Plugins& plugins, const editing::MeshArrays& mesh,
          editing::Defects defects, double weld_within);

  /// Throws host::Error with the library's sentence, also if no point has this distance.
  void make(const std::vector<host::Curve>& curves, const OffsetWish& wish);
  void clear() { results_ = {}; }

  [[nodiscard]] const std::vector<host::Curve>& curves() const { return results_.curves; }
  /// `Offset` in src/engine/types.ts.
  [[nodiscard]] Answer told() const;

 private:
  host::Services services_;
  host::Instance instance_;
  host::Results results_;
};

}  // namespace talweg::browser
