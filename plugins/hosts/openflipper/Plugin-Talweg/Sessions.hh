// The drawings of all meshes of the host, and the current drawing.
#pragma once

#include <functional>
#include <map>
#include <memory>

#include "Session.hh"

namespace talweg::openflipper {

/// Whether the object is a target of commands in the host.
bool is_target(int object_id);

class Sessions {
 public:
  explicit Sessions(HostCalls& host) : host_(host) {}

  /// Finds the plugins.
  void begin();
  /// Waits for threads, for a limited time.
  void end();

  /// The drawing on a mesh, which becomes the current one; begun if there is none. Null, with a
  /// message, if that is impossible.
  Session* of(int mesh_id);
  [[nodiscard]] Session* existing(int mesh_id) const;
  /// The current drawing, which the panel shows; null: none.
  [[nodiscard]] Session* now() const { return existing(now_); }
  /// The mesh of the current drawing, or -1.
  [[nodiscard]] int mesh_now() const { return now_; }
  /// The drawing on a target mesh; begun if there is none.
  Session* target();
  [[nodiscard]] const std::map<int, std::unique_ptr<Session>>& all() const { return sessions_; }

  /// An edit of the current drawing; false if there is none, or if the edit is refused.
  bool edit(const std::function<void(editing::Editor&)>& change);
  /// An edit of the selected curve of the current drawing.
  void edit_selected(const std::function<void(editing::Editor&, std::size_t curve)>& change);
  void begin_gesture(const QString& name);
  void end_gesture();

  void show_points(bool with);
  [[nodiscard]] bool with_points() const { return with_points_; }

  void clear();
  /// An object of the host was deleted. True if it was a mesh with a drawing, or an object of a
  /// drawing.
  bool object_deleted(int id);

 private:
  HostCalls& host_;
  std::unique_ptr<editing::Plugins> plugins_;
  std::map<int, std::unique_ptr<Session>> sessions_;  // by id of the mesh
  int now_ = -1;                                      // id of a mesh
  bool with_points_ = true;
};

}  // namespace talweg::openflipper
