// Progress is a callback of the caller's, which hears how far a call is and may cancel it; a budget
// travels with it.
#pragma once

#include <concepts>
#include <cstddef>
#include <functional>
#include <memory>
#include <type_traits>
#include <utility>

#include "talweg/intrinsic/budget.hpp"

namespace talweg {

/// Called from time to time with the stage's name and the done fraction in [0, 1]. Returning false
/// cancels the call, which then returns a typed result and stays usable. Made from anything that
/// can be called like that. Copies have the same budget, if there is one.
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

  /// The same callback with a budget that begins now; without any if this one is empty.
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

/// Whether a budget is used up, for a stage that then ends: to be asked only where there is more to
/// do, since it is noted.
inline bool ends_early(const Progress& progress) {
  BudgetUse* budget = progress.budget();
  if (budget == nullptr || !budget->is_used_up()) return false;
  budget->note_end();
  return true;
}

/// Whether a stage has ended early, so that what it made must not be kept for other calls.
inline bool has_ended_early(const Progress& progress) {
  return progress.budget() != nullptr && progress.budget()->has_ended();
}

/// Thrown by long work that is cancelled. Calls that return typed results catch it; functions that
/// let it through say so.
struct Cancelled {};

/// Asks a Progress at once and then at regular amounts of work. Work is counted, not timed, in
/// units of about a tenth of a microsecond, so that the Progress is asked about every millisecond.
class Asker {
 public:
  static constexpr std::size_t kEvery = 8192;  ///< units

  /// `fraction`: where the work begins that is asked about. Throws Cancelled, as all member
  /// functions that ask do.
  Asker(Progress progress, const char* stage, double fraction = 0)
      : progress_(std::move(progress)), stage_(stage), fraction_(fraction) {
    ask();
  }

  /// From now on BudgetUsedUp is thrown, too: at once and by all functions that ask.
  void end_with_budget() {
    ends_ = true;
    end_if(ends_early());
  }
  /// Whether the budget is used up: see ends_early(progress).
  [[nodiscard]] bool ends_early() const { return talweg::ends_early(progress_); }

  /// Reports the units of work done since the last call.
  void did(std::size_t units) {
    if (BudgetUse* budget = progress_.budget()) {
      budget->add(units);
      if (ends_ && budget->is_work_used_up()) ask();
    } else if (!progress_) {
      return;
    }
    if ((done_ += units) >= kEvery) ask();
  }
  /// Sets the fraction of the stage, in [0, 1], that later questions report.
  void is_at(double fraction) { fraction_ = fraction; }
  void ask() {
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
