// A session's requests to its thread, and the answers that are still wanted.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "CurveTickets.hh"
#include "talweg/editing/smoothing_thread.hpp"

namespace talweg::openflipper {

/// The answer to a request.
struct Answer {
  editing::Outcome outcome;
  std::vector<std::uint32_t> numbers;  ///< numbers of the outcome's curves
  bool newest = false;                 ///< whether no later drawing was to be smoothed
};

class Requests {
 public:
  /// `wake` is called on the thread when there is an answer. `sight`: also request the search tree
  /// of the mesh.
  Requests(const editing::Plugins& plugins, std::function<void()> wake, bool sight)
      : plugins_(plugins), wake_(std::move(wake)), wants_sight_(sight) {}

  /// Takes another mesh and requests its opening.
  void open(std::shared_ptr<const editing::MeshArrays> mesh, editing::Defects defects);

  enum class Asked { kAsAlready, kWithoutCurves, kNew };
  /// Requests smoothing of the drawing, unless it is the last requested. Without curves to be
  /// smoothed, the earlier request is dropped.
  Asked smooth(const editing::Drawing& drawing, const host::Wanted& wanted, editing::Hand hand);
  /// Sets the last requested drawing; an empty drawing makes the next request new.
  void asked_already(const editing::Drawing& drawing) { asked_ = drawing; }
  /// Drops the answers to earlier requests for smoothing.
  void drop() { stale_ = ticket_; }
  /// Requests the drawn curves as lines on the mesh, unless they are the last requested.
  void draw(const editing::Drawing& drawing);
  /// Requests the continuation of a curve to the mouse.
  void leg(const editing::Point& from, const editing::Point& to);
  void no_leg() { leg_ticket_ = 0; }
  void distance(const editing::Drawing& drawing) { thread_->distance(drawing); }
  void place(std::vector<host::Curve> curves) { thread_->place(std::move(curves)); }

  void cancel();
  /// Waits for the thread; the answers are then taken by take().
  void wait() { thread_->wait(); }
  /// The next answer that is still wanted, if there is one.
  std::optional<Answer> take();
  /// Whether newer smoothed curves are being computed.
  [[nodiscard]] bool smooths() const { return done_ < ticket_; }
  [[nodiscard]] editing::Progress progress() const { return thread_->progress(); }

 private:
  [[nodiscard]] bool is_wanted(const editing::Outcome& outcome) const;

  const editing::Plugins& plugins_;
  std::function<void()> wake_;
  bool wants_sight_, has_sight_ = false;
  std::unique_ptr<editing::SmoothingThread> thread_;
  CurveTickets tickets_;
  editing::Drawing asked_;                                          // last request for smoothing
  std::vector<std::shared_ptr<const editing::Curve>> lines_asked_;  // last request for lines
  std::uint64_t ticket_ = 0;                                        // ticket of asked_
  std::uint64_t done_ = 0;        // last ticket that was smoothed or dropped
  std::uint64_t stale_ = 0;       // results up to this ticket are outdated
  std::uint64_t leg_ticket_ = 0;  // 0: no leg is requested
};

}  // namespace talweg::openflipper
