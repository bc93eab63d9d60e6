// What the plugin's parts ask of the host; all of it on the GUI's thread, except wake().
#pragma once

#include <QString>

#include "HostTypes.hh"

namespace talweg::openflipper {

class HostCalls {
 public:
  virtual ~HostCalls() = default;
  virtual int add_line(const QString& name) = 0;
  virtual void show_line(int id) = 0;     ///< its points have changed
  virtual void show_colours(int id) = 0;  ///< its colours have changed
  virtual void show_selection(int id) = 0;
  virtual void show_mesh(int id) = 0;  ///< all of it may have changed
  virtual int add_mesh(const QString& name, TriMesh&& mesh) = 0;
  virtual void remove_object(int id) = 0;
  virtual void push_backup(int id, const QString& name) = 0;
  virtual bool host_undo(int id) = 0;  ///< false where the host has nothing to undo
  virtual bool host_redo(int id) = 0;
  virtual void say(const QString& sentence) = 0;   ///< to the log
  virtual void warn(const QString& sentence) = 0;  ///< to the log and the status bar
  virtual void tell(const QString& sentence) = 0;  ///< to the status bar, for a while
  /// What a click would do; the mouse is on something that can be taken hold of, or not.
  virtual void hint(const QString& sentence, bool on_something) = 0;
  virtual void changed() = 0;  ///< drawing, results or state: show them
  /// Turns the view to a place, as seen from outside along the normal there.
  virtual void look_at(const ACG::Vec3d& place, const ACG::Vec3d& normal) = 0;
  virtual void redraw() = 0;  ///< only the scene has changed
  virtual void wake() = 0;    ///< from any thread: look at the sessions soon
};

}  // namespace talweg::openflipper
