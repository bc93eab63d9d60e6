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

/// The plugins that were found (talweg_loader.h). Outlives what works with them.
class Plugins {
 public:
  /// `folders`, separated by ':'; empty: the loader's own.
  explicit Plugins(const std::string& folders = "");
  /// Throws Error that tells where it was looked for.
  [[nodiscard]] const talweg_plugin& find(const char* id) const;

 private:
  struct Close {
    void operator()(talweg_loader* loader) const { talweg_loader_close(loader); }
  };
  std::unique_ptr<talweg_loader, Close> loader_;
};

enum class Task {
  kOpen,      ///< the mesh; always the first
  kSmooth,    ///< a drawing: curves and report
  kPlace,     ///< positions in space: points of a drawing
  kDistance,  ///< distance and potential at every vertex
  kDraw,      ///< the drawn curves as they lie on the mesh
};

/// What a hand does meanwhile.
enum class Hand {
  kRests,   ///< the result counts
  kSlides,  ///< moves a slider: the curve counts, but no deviation is measured
  kDrags,   ///< moves a point: the same, and smoothed only near the change where the plugin can
};

/// What a task has come to.
struct Outcome {
  Task task = Task::kOpen;
  std::uint64_t ticket = 0;
  talweg_status status = TALWEG_OK;
  std::string sentence;            ///< why, where the status is not TALWEG_OK
  host::Results results;           ///< kSmooth, kDistance, kDraw
  std::vector<Curve> placed;       ///< kPlace
  std::vector<std::string> notes;  ///< warnings of the plugins
  double milliseconds = 0;         ///< by the clock on the wall
};

/// How far the task is that runs.
struct Progress {
  bool busy = false;  ///< something runs or waits
  Task task = Task::kOpen;
  std::string stage;  ///< the plugin's name for what it does
  double fraction = 0;
};

/// Of smoothing only the newest request counts: one that waits gives way to it, and one that runs
/// is left to its end if it began less than `patience` ago (so that the curve follows the hand) and
/// is cancelled otherwise. Everything else is done in the order in which it was asked for. All
/// methods are called from one thread, and `wake` is called on another.
class SmoothingThread {
 public:
  /// Opens the mesh at once. `wake` is called whenever take() has something new; it must only
  /// notify. `plugins` outlives the object.
  SmoothingThread(const Plugins& plugins, std::shared_ptr<const MeshArrays> mesh,
                  std::function<void()> wake = {}, double patience_ms = 400);
  /// Cancels what runs and waits for its end.
  ~SmoothingThread();
  SmoothingThread(const SmoothingThread&) = delete;
  SmoothingThread& operator=(const SmoothingThread&) = delete;

  /// Each gives the ticket of its outcome. A request that gave way has none.
  std::uint64_t smooth(const Drawing& drawing, const host::Wanted& wanted = {},
                       Hand hand = Hand::kRests);
  /// Curves given by `positions`; each point goes to the nearest one of the mesh.
  std::uint64_t place(std::vector<host::Curve> curves);
  std::uint64_t distance(const Drawing& drawing);
  std::uint64_t draw(const Drawing& drawing);

  /// What is done, in order; nothing: none.
  std::optional<Outcome> take();
  [[nodiscard]] Progress progress() const;
  /// What runs ends soon, as cancelled; what waits goes.
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

  mutable std::mutex mutex_;  // for all below
  std::condition_variable asked_, done_;
  std::deque<std::unique_ptr<Request>> waiting_;
  std::deque<Outcome> outcomes_;
  Progress progress_;
  std::uint64_t tickets_ = 0;
  double began_ms_ = 0;
  bool cancelled_ = false;
  bool closing_ = false;

  std::thread thread_;  // last: everything is there when it begins
};

}  // namespace talweg::editing
