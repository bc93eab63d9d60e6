// The workplace does the work on one mesh: opening it, smoothing drawings on it, putting curves
// onto it, measuring distances. It works where it is called; SmoothingThread gives it a thread.
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

/// Plugins that are there as long as a copy of this object is.
class LoadedPlugins {
 public:
  /// Takes the loader over. Throws std::bad_alloc if it is null.
  explicit LoadedPlugins(talweg_loader* loader);
  /// Throws Error that says where the plugin was looked for.
  [[nodiscard]] const talweg_plugin& find(const char* id) const;

 private:
  std::shared_ptr<talweg_loader> loader_;
};

/// The plugins that were found (talweg_loader.h). Must outlive everything that uses them.
class Plugins {
 public:
  /// `folders` are separated by ':'; if empty, the loader's own.
  explicit Plugins(const std::string& folders = "");
  /// Those that are linked into the program.
  explicit Plugins(std::span<const talweg_linked_module> modules);
  /// Waits for its threads as EndingThreads::end() does; one that is left to itself keeps the
  /// plugins loaded for ever.
  ~Plugins();
  Plugins(const Plugins&) = delete;
  Plugins& operator=(const Plugins&) = delete;
  /// Throws Error that says where the plugin was looked for.
  [[nodiscard]] const talweg_plugin& find(const char* id) const { return loaded_.find(id); }
  /// What keeps the plugins loaded.
  [[nodiscard]] const LoadedPlugins& loaded() const { return loaded_; }
  /// Where threads that use the plugins end.
  [[nodiscard]] EndingThreads& ending_threads() const { return ending_; }

 private:
  LoadedPlugins loaded_;
  mutable EndingThreads ending_;  // after what its threads use
};

/// What is done in a workplace.
enum class Task {
  kOpen,      ///< opens the mesh; always the first task of a thread
  kSmooth,    ///< smooths a drawing: curves and report
  kPlace,     ///< puts positions in space onto the mesh: points of a drawing
  kDistance,  ///< distance and potential at every vertex
  kDraw,      ///< the drawn curves as they lie on the mesh
  kLeg,       ///< the same of one leg that is not drawn yet
  kSee,       ///< what tells where the mesh is under the mouse
};

/// What the user is doing during a request.
enum class Hand {
  kRests,   ///< nothing: the result is final
  kSlides,  ///< moves a slider: the curve is needed, but no deviation is measured
  kDrags,   ///< moves a point: as kSlides, and smoothed only near the change if the plugin can
};

/// What becomes of a mesh that is no surface, such as one with a face that comes twice.
enum class Defects {
  kRefuse,  ///< it cannot be opened; the outcome tells what a repair would do
  kRepair,  ///< it is repaired; results keep the numbers of the mesh as it came
};

/// The id of the plugin that does it; "" if none does.
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
  std::string sentence;                ///< the reason, if the status is not TALWEG_OK
  host::Results results;               ///< kSmooth, kDistance, kDraw and kLeg (only curves)
  std::vector<Curve> placed;           ///< kPlace
  std::shared_ptr<const Sight> sight;  ///< kSee
  std::vector<std::string> repair;  ///< kOpen, TALWEG_BAD_MESH: what a repair would do, a sentence
                                    ///< each; empty if it would not help
  std::vector<std::string> notes;   ///< warnings of the plugins
  double milliseconds = 0;          ///< wall-clock time
};

/// Instances of the plugins, each made and opened when first needed. One thread at a time.
class Workplace {
 public:
  /// Gets the plugin's name for the stage and a fraction; false cancels. May come from any thread.
  using Ask = std::function<bool(const char* stage, double fraction)>;

  /// Keeps the plugins loaded. Opens nothing yet.
  Workplace(const Plugins& plugins, std::shared_ptr<const MeshArrays> mesh,
            Defects defects = Defects::kRefuse, Ask ask = {});
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;

  /// Before the first task: a mesh that is repaired is welded within so many mesh units, too; 0:
  /// only vertices at one place become one.
  void weld_within(double tolerance) { weld_within_ = tolerance; }

  /// Never throws for what is wrong with a request: the outcome says it.
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
  std::vector<std::string> repair_told();

  LoadedPlugins plugins_;
  std::shared_ptr<const MeshArrays> mesh_;
  Defects defects_;
  double weld_within_ = 0;
  std::vector<std::string> notes_;
  host::Services services_;  // must outlive the instances
  std::unique_ptr<host::Instance> smooth_, draw_, distance_;
  std::optional<Drawing> smoothed_, measured_;  // whose curves the instances have
  // What was drawn last: curves are the same while their pointers are.
  std::vector<std::pair<std::shared_ptr<const Curve>, host::Curve>> drawn_;
};

}  // namespace talweg::editing
