#include "smoothing_thread.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string_view>
#include <utility>

namespace talweg::editing {
namespace {

double now_ms() {
  const auto since = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::milli>(since).count();
}

bool has_parameter(const talweg_plugin& plugin, std::string_view id) {
  const talweg_parameter* const* end = plugin.parameters + plugin.parameter_count;
  return std::any_of(plugin.parameters, end,
                     [&](const talweg_parameter* parameter) { return parameter->id == id; });
}

/// The points that were given, out of a drawn curve that has other points in between.
Curve given_points(const host::Curve& drawn) {
  const auto given = std::find_if(drawn.fields.begin(), drawn.fields.end(),
                                  [](const host::Field& field) { return field.name == "given"; });
  Curve curve;
  curve.closed = drawn.closed;
  for (std::size_t k = 0; k < drawn.faces.size(); ++k) {
    if (given != drawn.fields.end() && given->values[k] == 0) continue;
    const double exact = drawn.exact.empty() ? TALWEG_MARK_NONE : drawn.exact[k];
    curve.points.push_back({drawn.faces[k], drawn.barycentrics[k], false, exact});
  }
  return curve;
}

}  // namespace

Plugins::Plugins(const std::string& folders)
    : loader_(talweg_loader_open(folders.empty() ? nullptr : folders.c_str())) {
  if (loader_ == nullptr) throw std::bad_alloc();
}

const talweg_plugin& Plugins::find(const char* id) const {
  if (const talweg_plugin* plugin = talweg_loader_find(loader_.get(), id)) return *plugin;
  throw Error(std::string("The plugin ") + id + " was not found in " +
              talweg_loader_folders(loader_.get()) +
              "; TALWEG_PLUGIN_PATH can name another folder.");
}

struct SmoothingThread::Request {
  Task task;
  std::uint64_t ticket = 0;
  Drawing drawing;
  host::Wanted wanted;
  std::vector<host::Curve> curves;
  Hand hand = Hand::kRests;
};

/// The thread's own data: instances of the plugins, each made and opened when first needed.
struct SmoothingThread::Workplace {
  Workplace(SmoothingThread& owner)
      : plugins(owner.plugins_),
        mesh(*owner.mesh_),
        services(
            "Talweg editing", "1",
            [&owner](const char* stage, double fraction) {
              return owner.on_progress(stage, fraction);
            },
            [this](std::uint32_t severity, const char* message) {
              if (severity >= TALWEG_LOG_WARNING) notes.emplace_back(message);
            }) {}

  host::Instance& opened(std::unique_ptr<host::Instance>& instance, const char* id) {
    if (!instance) {
      auto made = std::make_unique<host::Instance>(plugins.find(id), services);
      set_mesh(*made, mesh);
      instance = std::move(made);
    }
    return *instance;
  }

  void do_task(const Request& request, Outcome& outcome) {
    switch (request.task) {
      case Task::kOpen:
        opened(smooth, "talweg.smooth");
        return;
      case Task::kSmooth:
        return do_smooth(request, outcome);
      case Task::kPlace:
        return do_place(request, outcome);
      case Task::kDistance:
        return do_distance(request, outcome);
      case Task::kDraw:
        return do_draw(request, outcome);
    }
  }

  void do_smooth(const Request& request, Outcome& outcome) {
    const std::vector<host::Curve> curves = host_curves(request.drawing);
    if (curves.empty()) return;
    host::Instance& instance = opened(smooth, "talweg.smooth");
    if (!known || stage_between(*known, request.drawing) == Stage::kCurves) {
      known.reset();
      instance.set_curves(curves);
      known = request.drawing;
    }
    apply(request.drawing.settings, instance);
    known->settings = request.drawing.settings;
    if (has_parameter(instance.plugin(), "preview")) {
      instance.set("preview", request.hand == Hand::kDrags ? 1.0 : 0.0);
    }
    if (request.hand == Hand::kRests) {
      instance.reset("deviation");
    } else {
      instance.set("deviation", "none");
    }
    outcome.results = instance.run(request.wanted);
  }

  void do_place(const Request& request, Outcome& outcome) {
    host::Instance& instance = opened(draw, "talweg.draw");
    instance.set("straight", 1.0);
    host::Wanted wanted;
    wanted.point_fields = true;
    for (const host::Curve& curve : request.curves) {
      // A curve that says nothing of its points is a stroke here: nobody has clicked them.
      if (has_parameter(instance.plugin(), "points")) {
        instance.set("points", curve.exact.empty() ? "rough" : "exact");
      }
      instance.set_curves({curve});
      outcome.placed.push_back(given_points(instance.run(wanted).curves.at(0)));
    }
  }

  void do_distance(const Request& request, Outcome& outcome) {
    const std::vector<host::Curve> curves = host_curves(request.drawing);
    if (curves.empty()) throw Error("There is no curve to measure the distance to.");
    host::Instance& instance = opened(distance, "talweg.distance");
    instance.set_curves(curves);
    instance.set("tau", request.drawing.settings.tau);
    if (request.drawing.settings.slack) {
      instance.set("slack", *request.drawing.settings.slack);
    } else {
      instance.reset("slack");
    }
    host::Wanted wanted;
    wanted.vertex_fields = true;
    outcome.results = instance.run(wanted);
  }

  void do_draw(const Request& request, Outcome& outcome) {
    const std::vector<host::Curve> curves = host_curves(request.drawing);
    if (curves.empty()) return;
    host::Instance& instance = opened(draw, "talweg.draw");
    instance.set("straight", 1.0);
    instance.set_curves(curves);
    outcome.results = instance.run();
  }

  const Plugins& plugins;
  const MeshArrays& mesh;
  std::vector<std::string> notes;
  host::Services services;  // must outlive the instances
  std::unique_ptr<host::Instance> smooth, draw, distance;
  std::optional<Drawing> known;  // the drawing whose curves `smooth` has
};

SmoothingThread::SmoothingThread(const Plugins& plugins, std::shared_ptr<const MeshArrays> mesh,
                                 std::function<void()> wake, double patience_ms)
    : plugins_(plugins), mesh_(std::move(mesh)), wake_(std::move(wake)), patience_ms_(patience_ms) {
  auto open = std::make_unique<Request>();
  open->task = Task::kOpen;
  waiting_.push_back(std::move(open));
  progress_.busy = true;
  thread_ = std::thread([this] { work(); });
}

SmoothingThread::~SmoothingThread() {
  {
    const std::scoped_lock lock(mutex_);
    closing_ = cancelled_ = true;
    waiting_.clear();
  }
  asked_.notify_all();
  thread_.join();
}

std::uint64_t SmoothingThread::ask(std::unique_ptr<Request> request) {
  std::uint64_t ticket = 0;
  {
    const std::scoped_lock lock(mutex_);
    ticket = request->ticket = ++tickets_;
    if (request->task == Task::kSmooth) {
      std::erase_if(waiting_, [](const auto& other) { return other->task == Task::kSmooth; });
      const bool smooths = progress_.task == Task::kSmooth && began_ms_ > 0;
      if (smooths && now_ms() - began_ms_ >= patience_ms_) cancelled_ = true;
    }
    waiting_.push_back(std::move(request));
    progress_.busy = true;
  }
  asked_.notify_all();
  return ticket;
}

std::uint64_t SmoothingThread::smooth(const Drawing& drawing, const host::Wanted& wanted,
                                      Hand hand) {
  return ask(std::make_unique<Request>(Request{Task::kSmooth, 0, drawing, wanted, {}, hand}));
}

std::uint64_t SmoothingThread::place(std::vector<host::Curve> curves) {
  return ask(
      std::make_unique<Request>(Request{Task::kPlace, 0, {}, {}, std::move(curves), Hand::kRests}));
}

std::uint64_t SmoothingThread::distance(const Drawing& drawing) {
  return ask(std::make_unique<Request>(Request{Task::kDistance, 0, drawing, {}, {}, Hand::kRests}));
}

std::uint64_t SmoothingThread::draw(const Drawing& drawing) {
  return ask(std::make_unique<Request>(Request{Task::kDraw, 0, drawing, {}, {}, Hand::kRests}));
}

std::optional<Outcome> SmoothingThread::take() {
  const std::scoped_lock lock(mutex_);
  if (outcomes_.empty()) return std::nullopt;
  Outcome outcome = std::move(outcomes_.front());
  outcomes_.pop_front();
  return outcome;
}

Progress SmoothingThread::progress() const {
  const std::scoped_lock lock(mutex_);
  return progress_;
}

void SmoothingThread::cancel() {
  const std::scoped_lock lock(mutex_);
  waiting_.clear();
  if (began_ms_ > 0) {
    cancelled_ = true;
  } else {  // the worker has not taken the request and never will
    progress_.busy = false;
    done_.notify_all();
  }
}

void SmoothingThread::wait() {
  std::unique_lock lock(mutex_);
  done_.wait(lock, [this] { return !progress_.busy; });
}

bool SmoothingThread::on_progress(const char* stage, double fraction) {
  const std::scoped_lock lock(mutex_);
  progress_.stage = stage;
  progress_.fraction = fraction;
  return !cancelled_;
}

/// Waits for a request; null if no more will come.
std::unique_ptr<SmoothingThread::Request> SmoothingThread::next() {
  std::unique_lock lock(mutex_);
  progress_.busy = !waiting_.empty();
  began_ms_ = 0;
  if (!progress_.busy) done_.notify_all();
  asked_.wait(lock, [this] { return closing_ || !waiting_.empty(); });
  if (closing_) return nullptr;
  std::unique_ptr<Request> request = std::move(waiting_.front());
  waiting_.pop_front();
  progress_ = {true, request->task, "", 0};
  began_ms_ = now_ms();
  cancelled_ = false;
  return request;
}

void SmoothingThread::work() {
  Workplace workplace(*this);
  while (const std::unique_ptr<Request> request = next()) {
    Outcome outcome;
    outcome.task = request->task;
    outcome.ticket = request->ticket;
    const double start = now_ms();
    try {
      workplace.do_task(*request, outcome);
    } catch (const host::Error& error) {
      outcome.status = error.status();
      outcome.sentence = error.what();
    } catch (const Error& error) {
      outcome.status = TALWEG_BAD_USAGE;
      outcome.sentence = error.what();
    } catch (const std::exception& error) {
      outcome.status = TALWEG_INTERNAL;
      outcome.sentence = error.what();
    }
    outcome.milliseconds = now_ms() - start;
    outcome.notes = std::exchange(workplace.notes, {});
    {
      const std::scoped_lock lock(mutex_);
      outcomes_.push_back(std::move(outcome));
    }
    if (wake_) wake_();
  }
}

}  // namespace talweg::editing
