#include "history.hpp"

#include <algorithm>
#include <utility>

namespace talweg::editing {

History::History(std::size_t most) : most_(most) { steps_.push_back({"", {}, numbers_++}); }

History::History(Drawing first) : History() { steps_.front().drawing = std::move(first); }

void History::add(const std::string& name, Drawing next) {
  if (next == now()) return;
  if (gesture_ == Gesture::kMoved) {
    steps_[at_].drawing = std::move(next);
    steps_[at_].number = numbers_++;
    return;
  }
  steps_.resize(at_ + 1);
  steps_.push_back({in_gesture() ? gesture_name_ : name, std::move(next), numbers_++});
  if (steps_.size() > most_ + 1) steps_.erase(steps_.begin());
  at_ = steps_.size() - 1;
  if (in_gesture()) gesture_ = Gesture::kMoved;
}

void History::begin_gesture(const std::string& name) {
  gesture_ = Gesture::kBegun;
  gesture_name_ = name;
}

bool History::undo() {
  end_gesture();
  if (!can_undo()) return false;
  --at_;
  return true;
}

bool History::redo() {
  end_gesture();
  if (!can_redo()) return false;
  ++at_;
  return true;
}

bool History::go_to(std::uint64_t number) {
  const auto step =
      std::find_if(steps_.begin(), steps_.end(), [&](const Step& s) { return s.number == number; });
  if (step == steps_.end()) return false;
  end_gesture();
  at_ = static_cast<std::size_t>(step - steps_.begin());
  return true;
}

}  // namespace talweg::editing
