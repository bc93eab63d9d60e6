// A budget limits the time or the counted work of a call; refinement ends when it is used up.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "talweg/intrinsic/error.hpp"

namespace talweg {

/// The limits of one call. When the budget is used up, stages that refine a result (fairing,
/// deviations, searches within a bound, junctions) end between two whole steps and return the best
/// result so far, with the bounds known for it. Stages whose partial results have no use, such as
/// straightening and solving, run to their end.
struct Budget {
  std::optional<double> seconds;      ///< s, > 0, by a clock
  std::optional<std::uint64_t> work;  ///< counted steps, > 0: the same result on every machine

  [[nodiscard]] bool any() const { return seconds.has_value() || work.has_value(); }
  /// Throws Error(kBadUsage) naming the field and its bound.
  void validate() const {
    if (seconds && !(*seconds > 0 && std::isfinite(*seconds))) {
      throw Error(ErrorCode::kBadUsage, "budget.seconds must be finite and > 0.");
    }
    if (work && *work == 0) throw Error(ErrorCode::kBadUsage, "budget.work must be > 0.");
  }

  bool operator==(const Budget&) const = default;
};

/// Counts the use of a budget since construction. Several threads may add work. The clock is read
/// only if the budget limits the seconds.
class BudgetUse {
 public:
  explicit BudgetUse(const Budget& budget) : most_work_(budget.work.value_or(UINT64_MAX)) {
    if (!budget.seconds) return;
    constexpr double kMost = 1e9;  // s; the clock cannot count much farther
    const std::chrono::duration<double> time(std::min(*budget.seconds, kMost));
    end_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(time);
  }

  void add(std::size_t units) { work_.fetch_add(units, std::memory_order_relaxed); }
  [[nodiscard]] bool is_work_used_up() const {
    return work_.load(std::memory_order_relaxed) >= most_work_;
  }
  [[nodiscard]] bool is_used_up() const {
    return is_work_used_up() || (end_ && Clock::now() >= *end_);
  }

  /// Records that a stage has ended early.
  void note_end() { has_ended_ = true; }
  /// Whether any stage has ended early.
  [[nodiscard]] bool has_ended() const { return has_ended_; }

 private:
  using Clock = std::chrono::steady_clock;

  std::uint64_t most_work_;
  std::optional<Clock::time_point> end_;
  std::atomic<std::uint64_t> work_ = 0;
  std::atomic<bool> has_ended_ = false;
};

/// Thrown by a ProgressPoller after ProgressPoller::end_with_budget() when the budget is used up.
struct BudgetUsedUp {};

}  // namespace talweg
