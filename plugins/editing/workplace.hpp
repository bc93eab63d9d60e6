// The workplace opens a mesh, smooths drawings on it, puts curves onto it and measures distances.
// All work is done on the caller's thread; SmoothingThread has a thread of its own for a workplace.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "ending_threads.hpp"
#include "mesh_arrays.hpp"
#include "sight.hpp"
#include "talweg/loader/talweg_loader.h"

namespace talweg::editing {

/// Plugins that stay loaded as long as a copy of this object exists.
class LoadedPlugins {
 public:
  /// Takes the loader over. Throws std::bad_alloc if the loader is null.
  explicit LoadedPlugins(talweg_loader* loader);
  /// Throws Error, which names the searched folders, if the plugin is not there.
  [[nodiscard]] const talweg_plugin& find(const char* id) const;

 private:
  std::shared_ptr<talweg_loader> loader_;
};

/// The plugins that the loader found (talweg_loader.h), and the threads that use them. The object
/// must outlive all other users of the plugins.
class Plugins {
 public:
  /// Searches `folders`, which are separated by ':'. An empty text means the loader's own folders.
  explicit Plugins(const std::string& folders = "");
  /// Uses the modules that are linked into the program.
  explicit Plugins(std::span<const talweg_linked_module> modules);
  /// Waits for the ending threads as EndingThreads::end() does. If a thread had to be detached, the
  /// plugins stay loaded for ever.
  ~Plugins();
  Plugins(const Plugins&) = delete;
  Plugins& operator=(const Plugins&) = delete;
  /// Throws Error, which names the searched folders, if the plugin is not there.
  [[nodiscard]] const talweg_plugin& find(const char* id) const { return loaded_.find(id); }
  /// A copy of this object keeps the plugins loaded.
  [[nodiscard]] const LoadedPlugins& loaded() const { return loaded_; }
  /// The threads that still use the plugins after their owners are gone.
  [[nodiscard]] EndingThreads& ending_threads() const { return ending_; }

 private:
  LoadedPlugins loaded_;
  mutable EndingThreads ending_;  // declared after loaded_, which its threads use
};

/// The tasks of a workplace.
enum class Task {
  kOpen,      ///< opens the mesh; always the first task of a thread
  kSmooth,    ///< smooths a drawing: curves and report
  kPlace,     ///< puts positions in space onto the mesh: points of a drawing
  kDistance,  ///< measures distance and potential at every vertex
  kDraw,      ///< draws the curves of a drawing along the mesh
  kLeg,       ///< draws one leg that is not part of the drawing yet
  kSee,       ///< builds the Sight of the mesh
};

/// The user's hand during a request.
enum class Hand {
  kRests,   ///< the hand rests: the result is final
  kSlides,  ///< moves a slider: the curve is needed, but no deviation is measured
  kDrags,   ///< moves a point: as kSlides, and smoothed only near the change if the plugin can
};

/// The treatment of a mesh that is not a surface, for example because a face occurs twice.
enum class Defects {
  kRefuse,  ///< the mesh is not opened; the outcome says what a repair would change
  kRepair,  ///< the mesh is repaired; results have the numbers of the mesh before the repair
};

/// The id of the plugin that does a task; "" if no plugin is needed.
const char* plugin_of(Task task);

struct Request {
  Task task = Task::kOpen;
  std::uint64_t ticket = 0;
  Drawing drawing;                  ///< kSmooth, kDistance, kDraw, kLeg
  host::Wanted wanted;              ///< kSmooth
  std::vector<host::Curve> curves;  ///< kPlace
  Hand hand = Hand::kRests;         ///< kSmooth
};

/// The outcome of a task.
struct Outcome {
  Task task = Task::kOpen;
  std::uint64_t ticket = 0;
  talweg_status status = TALWEG_OK;
  std::string sentence;                ///< the error, if the status is not TALWEG_OK
  host::Results results;               ///< kSmooth, kDistance, kDraw and kLeg (only curves)
  std::vector<Curve> placed;           ///< kPlace
  std::shared_ptr<const Sight> sight;  ///< kSee
  std::vector<std::string> repair;  ///< kOpen, TALWEG_BAD_MESH: the changes of a repair, a sentence
                                    ///< each; empty if a repair would not help
  std::vector<std::string> notes;   ///< warnings of the plugins
  double milliseconds = 0;          ///< wall-clock time
};

/// Does tasks on one mesh. An instance of a plugin is made, and gets the mesh, when a task first
/// needs it. Only one thread at a time may use the workplace.
class Workplace {
 public:
  /// Gets the plugin's name of the stage, and the fraction done, from 0 to 1; false cancels the
  /// task. Any thread may call the function.
  using Ask = std::function<bool(const char* stage, double fraction)>;

  /// Keeps the plugins loaded. The mesh is not opened yet.
  Workplace(const Plugins& plugins, std::shared_ptr<const MeshArrays> mesh,
            Defects defects = Defects::kRefuse, Ask ask = {});
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;

  /// Sets the distance, mesh units, within which a repair welds vertices; 0: vertices at one place
  /// become one vertex. Must be called before the first task.
  void weld_within(double tolerance) { weld_within_ = tolerance; }

  /// Does a task. Does not throw: errors of a request are in the outcome.
  Outcome work(const Request& request);

 private:
  void do_task(const Request& request, Outcome& outcome);
  void do_open(Outcome& outcome);
  void do_smooth(const Request& request, Outcome& outcome);
  void do_place(const Request& request, Outcome& outcome);
  void do_distance(const Request& request, Outcome& outcome);
  void do_draw(const Request& request, Outcome& outcome);
  void do_leg(const Request& request, Outcome& outcome);
  host::Curve drawn(const Curve& curve);
  host::Instance& opened(std::unique_ptr<host::Instance>& instance, const char* id);
  std::vector<std::string> repair_changes();

  LoadedPlugins plugins_;
  std::shared_ptr<const MeshArrays> mesh_;
  Defects defects_;
  double weld_within_ = 0;
  std::vector<std::string> notes_;
  host::Services services_;  // must outlive the instances
  std::unique_ptr<host::Instance> smooth_, draw_, distance_;
  // The drawings whose curves smooth_ and distance_ have.
  std::optional<Drawing> smoothed_, measured_;
  // The curves of the last kDraw with their lines. Equal pointers are equal curves.
  std::vector<std::pair<std::shared_ptr<const Curve>, host::Curve>> drawn_;
};

}  // namespace talweg::editing
