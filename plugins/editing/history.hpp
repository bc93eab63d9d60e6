// The history holds the successive states of a drawing, for undo and redo.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "drawing.hpp"

namespace talweg::editing {

/// Every state is kept whole, so that undo is exact. Successive states share the curves that are
/// equal in both.
class History {
 public:
  /// `most`: the number of steps that can be undone; older steps are forgotten.
  explicit History(std::size_t most = 2000);
  explicit History(Drawing first);

  [[nodiscard]] const Drawing& now() const { return steps_[at_].drawing; }
  /// Identifies the current state: no two states of a history have the same number.
  [[nodiscard]] std::uint64_t number() const { return steps_[at_].number; }

  /// Adds a state after the current one and forgets undone states. A state equal to the current one
  /// is not added. All states of a gesture become one step with the gesture's name.
  void add(const std::string& name, Drawing next);

  /// Begins a mouse gesture, all edits of which are one step. Gestures do not nest.
  void begin_gesture(const std::string& name);
  void end_gesture() { gesture_ = Gesture::kNone; }
  [[nodiscard]] bool in_gesture() const { return gesture_ != Gesture::kNone; }

  [[nodiscard]] bool can_undo() const { return at_ > 0; }
  [[nodiscard]] bool can_redo() const { return at_ + 1 < steps_.size(); }
  /// Names of the steps that undo() and redo() would take; empty where there is none.
  [[nodiscard]] std::string undo_name() const { return can_undo() ? steps_[at_].name : ""; }
  [[nodiscard]] std::string redo_name() const { return can_redo() ? steps_[at_ + 1].name : ""; }
  /// Both functions end a gesture, and return false if there is no step to undo or to redo.
  bool undo();
  bool redo();
  /// Goes to the state with a number(); false if the state is forgotten. Hosts that keep the list
  /// of steps use this function.
  bool go_to(std::uint64_t number);

 private:
  struct Step {
    std::string name;  // of the edit that made this state
    Drawing drawing;
    std::uint64_t number;
  };
  enum class Gesture { kNone, kBegun, kMoved };

  std::size_t most_;
  std::vector<Step> steps_;
  std::size_t at_ = 0;
  std::uint64_t numbers_ = 0;
  Gesture gesture_ = Gesture::kNone;
  std::string gesture_name_;
};

}  // namespace talweg::editing
