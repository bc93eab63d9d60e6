// A work tally counts work until it is told to an asker.
#pragma once

#include <cstddef>

#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// Counts in the units of Asker::did(). Counting never throws, telling may: so work is counted
/// anywhere and told only between two complete steps.
class WorkTally {
 public:
  /// Sets whom to tell; null for nobody.
  void ask(Asker* asker) { asker_ = asker; }
  void add(std::size_t units) { units_ += units; }
  /// Throws Cancelled if the asker does.
  void tell() {
    if (asker_ != nullptr) asker_->did(units_);
    units_ = 0;
  }

 private:
  Asker* asker_ = nullptr;
  std::size_t units_ = 0;  // since the asker was last told
};

}  // namespace talweg
