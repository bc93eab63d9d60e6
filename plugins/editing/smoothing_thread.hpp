// A smoothing thread works on one mesh while the host stays usable.
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
  double cancelled_ms = 0;  ///< time since cancel() of the running task; 0 without cancel()
};

/// A workplace in a thread of its own. A new request to smooth, to draw or for a leg replaces a
/// waiting request of the same kind. A new request to smooth also cancels a running smooth(),
/// unless smooth() began less than `patience_ms` ago, so that the curve follows the mouse. A leg is
/// done before all other waiting requests but the opening of the mesh. Other requests are done in
/// the order of their calls. All methods must be called from one thread; `wake` is called on
/// another thread.
class SmoothingThread {
 public:
  /// Opens the mesh as the first task. `wake` is called whenever take() has a new outcome, and must
  /// only notify the host's own thread. `plugins` must outlive the object.
  SmoothingThread(const Plugins& plugins, std::shared_ptr<const MeshArrays> mesh,
                  std::function<void()> wake = {}, double patience_ms = 400,
                  Defects defects = Defects::kRefuse);
  /// Cancels the running task and does not wait for its end. The destructor of Plugins waits a
  /// moment for the thread. `wake` is not called any more.
  ~SmoothingThread();
  SmoothingThread(const SmoothingThread&) = delete;
  SmoothingThread& operator=(const SmoothingThread&) = delete;

  // The request functions return the ticket of the request's outcome. A replaced request has no
  // outcome.

  std::uint64_t smooth(const Drawing& drawing, const host::Wanted& wanted = {},
                       Hand hand = Hand::kRests);
  /// Moves the points of curves, which have `positions`, to the nearest points of the mesh.
  std::uint64_t place(std::vector<host::Curve> curves);
  std::uint64_t distance(const Drawing& drawing);
  std::uint64_t draw(const Drawing& drawing);
  /// Draws a straight line over the mesh from one point to another.
  std::uint64_t leg(const Point& from, const Point& to);
  std::uint64_t see();

  /// Returns the next outcome, in the order of the tasks; none if no outcome waits.
  std::optional<Outcome> take();
  [[nodiscard]] Progress progress() const;
  /// Asks the running task to end soon, as cancelled, and drops waiting requests. A faulty plugin
  /// may never end its task: then Progress::cancelled_ms grows, and the host can make another
  /// SmoothingThread.
  void cancel();
  /// Waits until no task runs or waits. Scripts and tests use this function.
  void wait();

 private:
  struct Shared;

  std::uint64_t ask(Request request);

  const Plugins& plugins_;
  double patience_ms_;
  std::uint64_t tickets_ = 0;
  std::shared_ptr<Shared> shared_;  // shared with the thread, which may outlive this object
  std::thread thread_;
};

}  // namespace talweg::editing
