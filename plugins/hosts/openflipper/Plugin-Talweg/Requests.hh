// Requests are what a session asks of its thread, and whether what comes of them is still wanted.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "CurveTickets.hh"
#include "talweg/editing/smoothing_thread.hpp"

namespace talweg::openflipper {

/// What has come of a request.
struct Answer {
  editing::Outcome outcome;
  std::vector<std::uint32_t> numbers;  ///< of its curves
  bool newest = false;                 ///< no later drawing was asked to be smoothed
};

class Requests {
 public:
  /// `wake` is called on the thread when there is an answer. With `sight` that is asked for, too.
  Requests(const editing::Plugins& plugins, std::function<void()> wake, bool sight)
      : plugins_(plugins), wake_(std::move(wake)), wants_sight_(sight) {}

  /// Another mesh, of which nothing is asked yet but to open it.
  void open(std::shared_ptr<const editing::MeshArrays> mesh, editing::Defects defects);

  enum class Asked { kAsAlready, kWithoutCurves, kNew };
  /// The drawing, unless it was asked last. Without curves that can be smoothed what was asked
  /// before is dropped.
  Asked smooth(const editing::Drawing& drawing, const host::Wanted& wanted, editing::Hand hand);
  /// As if that drawing was asked last; an empty one is never.
  void asked_already(const editing::Drawing& drawing) { asked_ = drawing; }
  /// Smoothed curves that were asked for come too late.
  void drop() { stale_ = ticket_; }
  /// The curves as they lie on the mesh, unless they were asked last.
  void draw(const editing::Drawing& drawing);
  /// How a curve would go on.
  void leg(const editing::Point& from, const editing::Point& to);
  void no_leg() { leg_ticket_ = 0; }
  void distance(const editing::Drawing& drawing) { thread_->distance(drawing); }
  void place(std::vector<host::Curve> curves) { thread_->place(std::move(curves)); }

  void cancel();
  /// Waits for the thread; its answers are still to be taken.
  void wait() { thread_->wait(); }
  /// The next answer that is wanted, if there is one.
  std::optional<Answer> take();
  /// Whether newer smoothed curves are on their way.
  [[nodiscard]] bool smooths() const { return done_ < ticket_; }
  [[nodiscard]] editing::Progress progress() const { return thread_->progress(); }

 private:
  [[nodiscard]] bool is_wanted(const editing::Outcome& outcome) const;

  const editing::Plugins& plugins_;
  std::function<void()> wake_;
  bool wants_sight_, has_sight_ = false;
  std::unique_ptr<editing::SmoothingThread> thread_;
  CurveTickets tickets_;
  editing::Drawing asked_;                                          // to be smoothed last
  std::vector<std::shared_ptr<const editing::Curve>> lines_asked_;  // to be drawn last
  std::uint64_t ticket_ = 0;                                        // of asked_
  std::uint64_t done_ = 0;        // the last one that was smoothed, or is not any more
  std::uint64_t stale_ = 0;       // results up to this ticket come too late
  std::uint64_t leg_ticket_ = 0;  // 0: no leg is wanted
};

}  // namespace talweg::openflipper
