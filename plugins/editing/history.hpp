// The history holds the states of a drawing, one after another, for undo and redo.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "drawing.hpp"

namespace talweg::editing {

/// Keeps every state, so that undo is exact. Equal parts of successive states are stored once.
class History {
 public:
  /// `most`: the number of steps that can be undone; older ones are forgotten.
  explicit History(std::size_t most = 2000);
  explicit History(Drawing first);

  [[nodiscard]] const Drawing& now() const { return steps_[at_].drawing; }
  /// Identifies the current state; every state ever created has another number.
  [[nodiscard]] std::uint64_t number() const { return steps_[at_].number; }

  /// Adds a new state after this one and forgets undone states. Does nothing if the state is equal.
  /// Within a gesture all states become one step with the gesture's name.
  void add(const std::string& name, Drawing next);

  /// Begins a mouse gesture, which is one step however many edits it makes. Gestures do not nest.
  void begin_gesture(const std::string& name);
  void end_gesture() { gesture_ = Gesture::kNone; }
  [[nodiscard]] bool in_gesture() const { return gesture_ != Gesture::kNone; }

  [[nodiscard]] bool can_undo() const { return at_ > 0; }
  [[nodiscard]] bool can_redo() const { return at_ + 1 < steps_.size(); }
  /// Names of the steps that undo() and redo() would take; empty where there is none.
  [[nodiscard]] std::string undo_name() const { return can_undo() ? steps_[at_].name : ""; }
  [[nodiscard]] std::string redo_name() const { return can_redo() ? steps_[at_ + 1].name : ""; }
  bool undo();  ///< ends a gesture; false where there is nothing to undo
  bool redo();
  /// Goes to the state with that number; false if it is forgotten. For hosts that keep the list of
  /// steps.
  bool go_to(std::uint64_t number);

 private:
  struct Step {
    std::string name;  // of the step that led to this state
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
