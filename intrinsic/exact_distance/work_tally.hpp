// A work tally counts work until the work is reported to an Asker.
#pragma once

#include <cstddef>

#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// Counts in the units of Asker::did(). add() never throws, but tell() may: so work is added
/// anywhere and reported only between two complete steps.
class WorkTally {
 public:
  /// Sets the asker that tell() reports to; null for none.
  void ask(Asker* asker) { asker_ = asker; }
  void add(std::size_t units) { units_ += units; }
  /// Throws Cancelled if the asker does.
  void tell() {
    if (asker_ != nullptr) asker_->did(units_);
    units_ = 0;
  }

 private:
  Asker* asker_ = nullptr;
  std::size_t units_ = 0;  // since the last tell()
};

}  // namespace talweg
