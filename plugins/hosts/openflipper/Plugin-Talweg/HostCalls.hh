// The calls from the plugin's parts to the host, all on the thread of the GUI, except wake().
#pragma once

#include <QString>

#include "HostTypes.hh"

namespace talweg::openflipper {

class HostCalls {
 public:
  virtual ~HostCalls() = default;
  virtual int add_line(const QString& name) = 0;
  virtual void show_line(int id) = 0;     ///< after a change of its points
  virtual void show_colours(int id) = 0;  ///< after a change of its colours
  virtual void show_selection(int id) = 0;
  virtual void show_mesh(int id) = 0;  ///< after a change of any of its data
  virtual int add_mesh(const QString& name, TriMesh&& mesh) = 0;
  virtual void remove_object(int id) = 0;
  virtual void push_backup(int id, const QString& name) = 0;
  virtual bool host_undo(int id) = 0;  ///< false if the host has nothing to undo
  virtual bool host_redo(int id) = 0;
  virtual void say(const QString& sentence) = 0;   ///< to the log
  virtual void warn(const QString& sentence) = 0;  ///< to the log and the status bar
  virtual void tell(const QString& sentence) = 0;  ///< to the status bar, for a while
  /// Tells the effect of a click. `on_something`: the mouse is on a point or curve that can be
  /// grabbed.
  virtual void hint(const QString& sentence, bool on_something) = 0;
  virtual void changed() = 0;  ///< after a change of drawing, results or state: updates the panel
  /// Turns the view to a place, as seen from outside along the normal there.
  virtual void look_at(const ACG::Vec3d& place, const ACG::Vec3d& normal) = 0;
  virtual void redraw() = 0;  ///< after a change of the scene only
  virtual void wake() = 0;    ///< from any thread: looks at the sessions soon
};

}  // namespace talweg::openflipper
