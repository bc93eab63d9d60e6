// The history holds the states of a drawing, one after another, for undo and redo.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "drawing.hpp"

namespace talweg::editing {

/// Keeps every state, so that going back is exact. What is alike in two states is there once.
class History {
 public:
  /// `most`: so many steps can be undone; the oldest are forgotten.
  explicit History(std::size_t most = 2000);

  [[nodiscard]] const Drawing& now() const { return steps_[at_].drawing; }
  /// Of the state that is there now; another number for every state there ever was.
  [[nodiscard]] std::uint64_t number() const { return steps_[at_].number; }

  /// A new state behind this one; what was undone is forgotten. Nothing happens when it is equal.
  /// Within a gesture the states become one step, which has the gesture's name.
  void add(const std::string& name, Drawing next);

  /// A movement of the hand that is one step however many edits it makes. They do not nest.
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
  /// To the state with that number; false when it is forgotten. For hosts that lead the list.
  bool go_to(std::uint64_t number);

 private:
  struct Step {
    std::string name;  // of what led here
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
