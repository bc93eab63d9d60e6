#include "Requests.hh"

#include <utility>

namespace talweg::openflipper {

void Requests::open(std::shared_ptr<const editing::MeshArrays> mesh, editing::Defects defects) {
  thread_.reset();
  thread_ =
      std::make_unique<editing::SmoothingThread>(plugins_, std::move(mesh), wake_, 400, defects);
  tickets_.clear();
  asked_ = {};
  lines_asked_.clear();
  ticket_ = done_ = stale_ = leg_ticket_ = 0;
  has_sight_ = false;
}

Requests::Asked Requests::smooth(const editing::Drawing& drawing, const host::Wanted& wanted,
                                 editing::Hand hand) {
  if (drawing == asked_) return Asked::kAsAlready;
  asked_ = drawing;
  if (host_curves(drawing).empty()) {
    if (smooths()) cancel();
    drop();
    return Asked::kWithoutCurves;
  }
  ticket_ = thread_->smooth(drawing, wanted, hand);
  tickets_.asked(ticket_, drawing);
  return Asked::kNew;
}

void Requests::draw(const editing::Drawing& drawing) {
  if (drawing.curves == lines_asked_) return;
  lines_asked_ = drawing.curves;
  tickets_.asked(thread_->draw(drawing), drawing);
}

void Requests::leg(const editing::Point& from, const editing::Point& to) {
  if (!from.same_place(to)) leg_ticket_ = thread_->leg(from, to);
}

void Requests::cancel() {
  thread_->cancel();
  done_ = ticket_;
  lines_asked_.clear();
  if (wants_sight_ && !has_sight_) thread_->see();
}

bool Requests::is_wanted(const editing::Outcome& outcome) const {
  if (outcome.task == editing::Task::kLeg) return outcome.ticket <= leg_ticket_;
  const bool smoothed = outcome.task == editing::Task::kSmooth && outcome.status == TALWEG_OK;
  return !smoothed || outcome.ticket > stale_;
}

std::optional<Answer> Requests::take() {
  while (auto outcome = thread_->take()) {
    const bool smoothed = outcome->task == editing::Task::kSmooth;
    if (smoothed) done_ = outcome->ticket;
    if (outcome->status == TALWEG_OK) {
      has_sight_ = has_sight_ || outcome->task == editing::Task::kSee;
      if (outcome->task == editing::Task::kOpen && wants_sight_) thread_->see();
    }
    if (!is_wanted(*outcome)) continue;
    Answer answer{std::move(*outcome), {}, false};
    answer.newest = smoothed && answer.outcome.ticket == ticket_;
    const bool of_curves = smoothed || answer.outcome.task == editing::Task::kDraw;
    if (of_curves && answer.outcome.status == TALWEG_OK) {
      answer.numbers = tickets_.take(answer.outcome.ticket);
    }
    return answer;
  }
  return std::nullopt;
}

}  // namespace talweg::openflipper
