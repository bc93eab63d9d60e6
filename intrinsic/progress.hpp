// Progress is the caller's callback, which receives the state of a call and may cancel the call. A
// Progress may carry a budget.
#pragma once

#include <concepts>
#include <cstddef>
#include <functional>
#include <memory>
#include <type_traits>
#include <utility>

#include "talweg/intrinsic/budget.hpp"

namespace talweg {

/// Called from time to time with the stage's name and the done fraction in [0, 1]. A callback that
/// returns false cancels the call; the call then returns a typed result, and its object stays
/// usable. Constructed from any callable with these parameters. Copies share one budget, if there
/// is one.
class Progress {
 public:
  using Callback = std::function<bool(const char* stage, double fraction)>;

  Progress() = default;
  template <class Called>
  requires(!std::same_as<std::remove_cvref_t<Called>, Progress> &&
           std::constructible_from<Callback, Called>)
      Progress(  // NOLINT(bugprone-forwarding-reference-overload): never called with a Progress
          Called&& called)  // NOLINT(google-explicit-constructor): lambdas are passed as they are
      : callback_(std::forward<Called>(called)) {}

  /// Whether there is a callback.
  explicit operator bool() const { return static_cast<bool>(callback_); }
  bool operator()(const char* stage, double fraction) const { return callback_(stage, fraction); }

  /// The same callback with a new budget, whose use starts at this call; without a budget if
  /// `budget` sets no limit.
  [[nodiscard]] Progress with(const Budget& budget) const {
    Progress result = without_budget();
    if (budget.any()) result.use_ = std::make_shared<BudgetUse>(budget);
    return result;
  }
  [[nodiscard]] Progress without_budget() const {
    Progress result;
    result.callback_ = callback_;
    return result;
  }
  /// Null without a budget.
  [[nodiscard]] BudgetUse* budget() const { return use_.get(); }

 private:
  Callback callback_;
  std::shared_ptr<BudgetUse> use_;
};

/// True if the caller wants to go on. An empty callback never cancels.
inline bool go_on(const Progress& progress, const char* stage, double fraction) {
  return !progress || progress(stage, fraction);
}

/// Whether the budget is used up. A true answer is recorded as an early end, so a stage asks only
/// while it has more work to do, and ends on true.
inline bool ends_early(const Progress& progress) {
  BudgetUse* budget = progress.budget();
  if (budget == nullptr || !budget->is_used_up()) return false;
  budget->note_end();
  return true;
}

/// Whether a stage has ended early; its result must then not be cached for other calls.
inline bool has_ended_early(const Progress& progress) {
  return progress.budget() != nullptr && progress.budget()->has_ended();
}

/// Thrown by long work that is cancelled. Calls that return typed results catch Cancelled; the
/// docstrings of other functions name it.
struct Cancelled {};

/// Calls a Progress at construction and then at regular amounts of work. Work is counted, not
/// timed, in units of about a tenth of a microsecond, so the Progress is called about once per
/// millisecond.
class ProgressPoller {
 public:
  static constexpr std::size_t kEvery = 8192;  ///< units

  /// `fraction`: the done fraction of the stage at which the work begins, in [0, 1]. Throws
  /// Cancelled when the callback returns false, as poll() and add_work() do.
  ProgressPoller(Progress progress, const char* stage, double fraction = 0)
      : progress_(std::move(progress)), stage_(stage), fraction_(fraction) {
    poll();
  }

  /// Makes this call, and later calls of poll() and add_work(), throw BudgetUsedUp when the budget
  /// is used up.
  void end_with_budget() {
    ends_ = true;
    end_if(ends_early());
  }
  /// Whether the budget is used up: see ends_early(progress).
  [[nodiscard]] bool ends_early() const { return talweg::ends_early(progress_); }

  /// Reports the units of work done since the last call.
  void add_work(std::size_t units) {
    if (BudgetUse* budget = progress_.budget()) {
      budget->add(units);
      if (ends_ && budget->is_work_used_up()) poll();
    } else if (!progress_) {
      return;
    }
    if ((done_ += units) >= kEvery) poll();
  }
  /// Sets the fraction of the stage, in [0, 1], that later calls of the Progress report.
  void set_fraction(double fraction) { fraction_ = fraction; }
  void poll() {
    done_ = 0;
    if (!go_on(progress_, stage_, fraction_)) throw Cancelled();
    if (ends_) end_if(ends_early());
  }

 private:
  static void end_if(bool end) {
    if (end) throw BudgetUsedUp();
  }

  Progress progress_;
  const char* stage_;
  double fraction_;
  std::size_t done_ = 0;
  bool ends_ = false;
};

}  // namespace talweg
