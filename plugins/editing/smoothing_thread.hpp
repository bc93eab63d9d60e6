// Work on one mesh in a thread of its own: opening it, smoothing drawings on it, putting curves
// onto it, measuring distances.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "mesh_arrays.hpp"
#include "talweg/loader/talweg_loader.h"

namespace talweg::editing {

/// The plugins that were found (talweg_loader.h). Must outlive everything that uses them.
class Plugins {
 public:
  /// `folders` are separated by ':'; if empty, the loader's own.
  explicit Plugins(const std::string& folders = "");
  /// Throws Error that says where the plugin was looked for.
  [[nodiscard]] const talweg_plugin& find(const char* id) const;

 private:
  struct Close {
    void operator()(talweg_loader* loader) const { talweg_loader_close(loader); }
  };
  std::unique_ptr<talweg_loader, Close> loader_;
};

enum class Task {
  kOpen,      ///< opens the mesh; always the first task
  kSmooth,    ///< smooths a drawing: curves and report
  kPlace,     ///< puts positions in space onto the mesh: points of a drawing
  kDistance,  ///< distance and potential at every vertex
  kDraw,      ///< the drawn curves as they lie on the mesh
};

/// What the user is doing during a request.
enum class Hand {
  kRests,   ///< nothing: the result is final
  kSlides,  ///< moves a slider: the curve is needed, but no deviation is measured
  kDrags,   ///< moves a point: as kSlides, and smoothed only near the change if the plugin can
};

/// The outcome of a task.
struct Outcome {
  Task task = Task::kOpen;
  std::uint64_t ticket = 0;
  talweg_status status = TALWEG_OK;
  std::string sentence;            ///< the reason, if the status is not TALWEG_OK
  host::Results results;           ///< kSmooth, kDistance, kDraw
  std::vector<Curve> placed;       ///< kPlace
  std::vector<std::string> notes;  ///< warnings of the plugins
  double milliseconds = 0;         ///< wall-clock time
};

/// The progress of the running task.
struct Progress {
  bool busy = false;  ///< whether a task runs or waits
  Task task = Task::kOpen;
  std::string stage;  ///< the plugin's name for the current stage
  double fraction = 0;
};

/// Of smoothing requests only the newest counts: a waiting one is replaced, and a running one is
/// completed if it began less than `patience` ago (so that the curve follows the mouse) and
/// cancelled otherwise. Other requests are done in the order in which they were made. All methods
/// must be called from one thread; `wake` is called on another.
class SmoothingThread {
 public:
  /// Opens the mesh at once. `wake` is called whenever take() has something new; it must only
  /// notify. `plugins` must outlive the object.
  SmoothingThread(const Plugins& plugins, std::shared_ptr<const MeshArrays> mesh,
                  std::function<void()> wake = {}, double patience_ms = 400);
  /// Cancels the running task and waits for its end.
  ~SmoothingThread();
  SmoothingThread(const SmoothingThread&) = delete;
  SmoothingThread& operator=(const SmoothingThread&) = delete;

  /// These return the ticket of the request's outcome. A request that was replaced has no outcome.
  std::uint64_t smooth(const Drawing& drawing, const host::Wanted& wanted = {},
                       Hand hand = Hand::kRests);
  /// Places curves given by `positions`; each point goes to the nearest point of the mesh.
  std::uint64_t place(std::vector<host::Curve> curves);
  std::uint64_t distance(const Drawing& drawing);
  std::uint64_t draw(const Drawing& drawing);

  /// Returns the next outcome, in order; nothing if there is none.
  std::optional<Outcome> take();
  [[nodiscard]] Progress progress() const;
  /// Ends the running task soon, as cancelled, and drops waiting requests.
  void cancel();
  /// Waits until nothing runs or waits any more. For scripts and tests.
  void wait();

 private:
  struct Request;
  struct Workplace;

  std::uint64_t ask(std::unique_ptr<Request> request);
  void work();
  std::unique_ptr<Request> next();
  bool on_progress(const char* stage, double fraction);

  const Plugins& plugins_;
  std::shared_ptr<const MeshArrays> mesh_;
  std::function<void()> wake_;
  double patience_ms_;

  mutable std::mutex mutex_;  // protects all members below
  std::condition_variable asked_, done_;
  std::deque<std::unique_ptr<Request>> waiting_;
  std::deque<Outcome> outcomes_;
  Progress progress_;
  std::uint64_t tickets_ = 0;
  double began_ms_ = 0;
  bool cancelled_ = false;
  bool closing_ = false;

  std::thread thread_;  // last, so that everything exists when it begins
};

}  // namespace talweg::editing
