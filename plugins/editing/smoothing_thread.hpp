// Work on one mesh in a thread of its own.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "workplace.hpp"

namespace talweg::editing {

/// The progress of the running task.
struct Progress {
  bool busy = false;  ///< whether a task runs or waits
  Task task = Task::kOpen;
  std::string stage;  ///< the plugin's name for the current stage
  double fraction = 0;
  double cancelled_ms = 0;  ///< how long ago cancel() ended the running task; 0 if it did not
};

/// A workplace in a thread. Of requests to smooth, to draw and for a leg only the newest of each
/// counts: a waiting one is replaced. A running smooth() is completed if it began less than
/// `patience` ago (so that the curve follows the mouse) and cancelled otherwise. A leg comes before
/// everything else that waits; other requests are done in the order in which they were made. All
/// methods must be called from one thread; `wake` is called on another.
class SmoothingThread {
 public:
  /// Opens the mesh at once. `wake` is called whenever take() has something new; it must only
  /// notify. `plugins` must outlive the object.
  SmoothingThread(const Plugins& plugins, std::shared_ptr<const MeshArrays> mesh,
                  std::function<void()> wake = {}, double patience_ms = 400,
                  Defects defects = Defects::kRefuse);
  /// Cancels the running task and does not wait for its end; the plugins do for a while, at their
  /// own. `wake` is called no more.
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
  /// A straight line over the mesh from one point to another.
  std::uint64_t leg(const Point& from, const Point& to);
  std::uint64_t see();

  /// Returns the next outcome, in order; nothing if there is none.
  std::optional<Outcome> take();
  [[nodiscard]] Progress progress() const;
  /// Ends the running task soon, as cancelled, and drops waiting requests. A faulty plugin may
  /// never end it: then progress() tells how long it has taken, and another SmoothingThread can be
  /// made.
  void cancel();
  /// Waits until nothing runs or waits any more. For scripts and tests.
  void wait();

 private:
  struct Shared;

  std::uint64_t ask(Request request);

  const Plugins& plugins_;
  double patience_ms_;
  std::uint64_t tickets_ = 0;
  std::shared_ptr<Shared> shared_;  // with the thread, which may outlive this object
  std::thread thread_;
};

}  // namespace talweg::editing
