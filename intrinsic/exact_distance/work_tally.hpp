// A work tally counts work until the work is reported to a ProgressPoller.
#pragma once

#include <cstddef>

#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// Counts in the units of ProgressPoller::add_work(). add() never throws, but report() may: so work
/// is added anywhere and reported only between two complete steps.
class WorkTally {
 public:
  /// Sets the poller that receives the work; null for none.
  void set_poller(ProgressPoller* poller) { poller_ = poller; }
  void add(std::size_t units) { units_ += units; }
  /// Throws Cancelled if the poller does.
  void report() {
    if (poller_ != nullptr) poller_->add_work(units_);
    units_ = 0;
  }

 private:
  ProgressPoller* poller_ = nullptr;
  std::size_t units_ = 0;  // since the last report()
};

}  // namespace talweg
