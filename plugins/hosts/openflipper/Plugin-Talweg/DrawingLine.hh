// The host's object for a drawing: a polyline with the points of the last curve, for files and
// scripts. The object also has the host's list for undo and redo.
#pragma once

#include <QString>
#include <cstdint>
#include <functional>
#include <memory>

#include "HostCalls.hh"
#include "talweg/editing/history.hpp"
#include "talweg/editing/mesh_arrays.hpp"

namespace talweg::openflipper {

class DrawingLine {
 public:
  using GoTo = std::function<void(std::uint64_t number)>;
  /// `go_to` is called when the host's list goes to a state of the history.
  DrawingLine(HostCalls& host, const QString& mesh_name, const editing::History& history,
              GoTo go_to);

  [[nodiscard]] int id() const { return id_; }  ///< -1: no object
  [[nodiscard]] bool is_hidden() const;
  /// Whether the deleted object was the line; if so, id() is -1 afterwards.
  bool was_deleted(int id);
  /// Updates the points. The scene hides the line, since its segments between points pass through
  /// the body.
  void show(const editing::Drawing& drawing, const TriMesh& mesh,
            const editing::MeshArrays& arrays);

  /// Adds the present state to the host's list. A new list begins with the state before.
  void keep(const editing::History& history);
  /// Notes that the host's list is at this state.
  void is_at(std::uint64_t number) { kept_ = number; }
  /// Undo and redo by the host's list; false if the list does not have the state.
  bool undo(const editing::History& history);
  bool redo(const editing::History& history);
  /// Takes another history, which needs another list and so another line. Returns the old line,
  /// which the caller must remove; -1: none.
  int begin_anew(const editing::History& history);

 private:
  HostCalls& host_;
  QString name_;
  std::shared_ptr<GoTo> go_to_;  // shared, since the line with the host's list may outlive this
                                 // object
  std::uint64_t first_;          // the first state of the host's list
  std::uint64_t kept_;           // the last state of the host's list
  int id_ = -1;
};

}  // namespace talweg::openflipper
