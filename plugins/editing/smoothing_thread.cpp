#include "smoothing_thread.hpp"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <utility>

#include "clock.hpp"

namespace talweg::editing {

struct SmoothingThread::Shared {
  mutable std::mutex mutex;  // protects all members up to the next mutex
  std::condition_variable asked, done;
  std::deque<Request> waiting;
  std::deque<Outcome> outcomes;
  Progress progress;
  double began_ms = 0;  // start of the running task; 0: no task runs
  double ended_ms = 0;  // time of cancel() during the running task; 0: it was not called
  bool cancelled = false;
  bool closing = false;

  std::mutex waking;  // protects `wake`
  std::function<void()> wake;

  std::shared_ptr<std::atomic<bool>> ended = std::make_shared<std::atomic<bool>>(false);

  bool on_progress(const char* stage, double fraction);
  std::optional<Request> next();
  void work(Workplace& workplace);
};

bool SmoothingThread::Shared::on_progress(const char* stage, double fraction) {
  const std::scoped_lock lock(mutex);
  progress.stage = stage;
  progress.fraction = fraction;
  return !cancelled;
}

/// Waits for a request; none when the thread is to end.
std::optional<Request> SmoothingThread::Shared::next() {
  std::unique_lock lock(mutex);
  progress.busy = !waiting.empty();
  began_ms = ended_ms = 0;
  if (!progress.busy) done.notify_all();
  asked.wait(lock, [this] { return closing || !waiting.empty(); });
  if (closing) return std::nullopt;
  Request request = std::move(waiting.front());
  waiting.pop_front();
  progress = {true, request.task, "", 0};
  began_ms = now_ms();
  cancelled = false;
  return request;
}

void SmoothingThread::Shared::work(Workplace& workplace) {
  while (const std::optional<Request> request = next()) {
    Outcome outcome = workplace.work(*request);
    {
      const std::scoped_lock lock(mutex);
      outcomes.push_back(std::move(outcome));
    }
    const std::scoped_lock lock(waking);
    if (wake) wake();
  }
}

SmoothingThread::SmoothingThread(const Plugins& plugins, std::shared_ptr<const MeshArrays> mesh,
                                 std::function<void()> wake, double patience_ms, Defects defects)
    : plugins_(plugins), patience_ms_(patience_ms), shared_(std::make_shared<Shared>()) {
  shared_->wake = std::move(wake);
  shared_->waiting.emplace_back();
  shared_->progress.busy = true;
  Shared* const asked = shared_.get();
  auto workplace = std::make_unique<Workplace>(
      plugins, std::move(mesh), defects,
      [asked](const char* stage, double fraction) { return asked->on_progress(stage, fraction); });
  thread_ = std::thread([shared = shared_, workplace = std::move(workplace)]() mutable {
    shared->work(*workplace);
    workplace.reset();
    *shared->ended = true;
  });
}

SmoothingThread::~SmoothingThread() {
  {
    const std::scoped_lock lock(shared_->mutex);
    shared_->closing = shared_->cancelled = true;
    shared_->waiting.clear();
  }
  shared_->asked.notify_all();
  {
    const std::scoped_lock lock(shared_->waking);
    shared_->wake = nullptr;
  }
  plugins_.ending_threads().take(std::move(thread_), shared_->ended);
}

namespace {

bool only_newest(Task task) {
  return task == Task::kSmooth || task == Task::kDraw || task == Task::kLeg;
}

}  // namespace

std::uint64_t SmoothingThread::ask(Request request) {
  const std::uint64_t ticket = request.ticket = ++tickets_;
  {
    const std::scoped_lock lock(shared_->mutex);
    if (only_newest(request.task)) {
      std::erase_if(shared_->waiting,
                    [&](const Request& other) { return other.task == request.task; });
    }
    if (request.task == Task::kSmooth) {
      const bool smooths = shared_->progress.task == Task::kSmooth && shared_->began_ms > 0;
      if (smooths && now_ms() - shared_->began_ms >= patience_ms_) shared_->cancelled = true;
    }
    auto& waiting = shared_->waiting;
    const bool opens = !waiting.empty() && waiting.front().task == Task::kOpen;
    const bool next = request.task == Task::kLeg;
    waiting.insert(next ? waiting.begin() + (opens ? 1 : 0) : waiting.end(), std::move(request));
    shared_->progress.busy = true;
  }
  shared_->asked.notify_all();
  return ticket;
}

std::uint64_t SmoothingThread::smooth(const Drawing& drawing, const host::Wanted& wanted,
                                      Hand hand) {
  return ask({Task::kSmooth, 0, drawing, wanted, {}, hand});
}

std::uint64_t SmoothingThread::place(std::vector<host::Curve> curves) {
  return ask({Task::kPlace, 0, {}, {}, std::move(curves), Hand::kRests});
}

std::uint64_t SmoothingThread::distance(const Drawing& drawing) {
  return ask({Task::kDistance, 0, drawing, {}, {}, Hand::kRests});
}

std::uint64_t SmoothingThread::draw(const Drawing& drawing) {
  return ask({Task::kDraw, 0, drawing, {}, {}, Hand::kRests});
}

std::uint64_t SmoothingThread::leg(const Point& from, const Point& to) {
  Drawing drawing;
  drawing.curves.push_back(std::make_shared<const Curve>(Curve{{from, to}}));
  return ask({Task::kLeg, 0, drawing, {}, {}, Hand::kRests});
}

std::uint64_t SmoothingThread::see() { return ask({Task::kSee, 0, {}, {}, {}, Hand::kRests}); }

std::optional<Outcome> SmoothingThread::take() {
  const std::scoped_lock lock(shared_->mutex);
  if (shared_->outcomes.empty()) return std::nullopt;
  Outcome outcome = std::move(shared_->outcomes.front());
  shared_->outcomes.pop_front();
  return outcome;
}

Progress SmoothingThread::progress() const {
  const std::scoped_lock lock(shared_->mutex);
  Progress progress = shared_->progress;
  if (shared_->ended_ms > 0) progress.cancelled_ms = now_ms() - shared_->ended_ms;
  return progress;
}

void SmoothingThread::cancel() {
  const std::scoped_lock lock(shared_->mutex);
  shared_->waiting.clear();
  if (shared_->began_ms > 0) {
    shared_->cancelled = true;
    if (shared_->ended_ms == 0) shared_->ended_ms = now_ms();
  } else {  // the worker has not taken the request and never will
    shared_->progress.busy = false;
    shared_->done.notify_all();
  }
}

void SmoothingThread::wait() {
  std::unique_lock lock(shared_->mutex);
  shared_->done.wait(lock, [this] { return !shared_->progress.busy; });
}

}  // namespace talweg::editing
